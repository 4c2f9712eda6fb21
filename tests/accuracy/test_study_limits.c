/* Controllers on fresh and frozen noise against what they should give, the geometry in: K = 1 at 1.41 x
 * the floor of white noise, and worse than no control on noise that accumulates. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "compare.h"
#include "unity.h"
#include "work.h"

enum { SEEDS = 20 };

static study_compare compare;
static study_sums sums;
static exk_rig rig;

void setUp(void)
{
}

void tearDown(void)
{
}

static void run_everything(void)
{
    const study_work work = {.n_trials = SEEDS, .n_threads = 2, .quiet = true};
    TEST_ASSERT_EQUAL_INT(STUDY_GOOD,
                          study_compare_init(&compare, EXK_SOURCE_DIR "/profiles/study"));
    TEST_ASSERT_EQUAL_INT(STUDY_GOOD,
                          study_sums_open(&sums, compare.measures, STUDY_N_COMPARE));
    TEST_ASSERT_EQUAL_INT(STUDY_GOOD, study_run(&compare.task, &work, &sums));
    TEST_ASSERT_EQUAL_INT(STUDY_GOOD, study_rig_open(&rig, compare.folder, STUDY_S5));
}

static int cell(const char *noise, bool frozen, const char *controller)
{
    for (int i = 0; i < STUDY_N_CELLS; i++) {
        const study_cell c = study_cell_at(i);
        if (c.frozen == frozen && strcmp(compare.noises[c.noise].name, noise) == 0 &&
            strcmp(study_controller_at(c.controller)->name, controller) == 0) {
            return i;
        }
    }
    TEST_FAIL_MESSAGE(controller);
    return 0;
}

static double rms_m(int i)
{
    return sqrt(sums.tallies[3 * i].moments.mean);
}

static double floor_m(int i)
{
    study_cell_apply(&compare, study_cell_at(i), &rig);
    return study_cell_floor(&compare, study_cell_at(i), &rig).path_m;
}

/* Every cell that is not learned away, within 5 of its own standard errors or 0.5 % (the sine's
 * curvature and the judged first tick). */
static void every_cell_is_what_theory_gives(void)
{
    for (int i = 0; i < STUDY_N_CELLS; i++) {
        const study_tally *t = &sums.tallies[3 * i];
        study_cell_apply(&compare, study_cell_at(i), &rig);
        const double want = study_cell_theory(&compare, study_cell_at(i), &rig).path_m;
        const double error =
            exk_moments_std(&t->moments) / sqrt((double)SEEDS) / (2.0 * rms_m(i));
        char name[32];
        snprintf(name, sizeof name, "cell %d", i);
        if (want > 1e-12) {
            TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(5.0 * error + 0.005 * want, want, rms_m(i), name);
        } else {
            TEST_ASSERT_TRUE_MESSAGE(rms_m(i) < 1e-9, name); /* all learned */
        }
    }
}

static void ratios_on_fresh_white_noise(void)
{
    static const struct {
        const char *controller;
        double ratio;
    } rows[] = {{"none", 1.0}, {"ilc", 1.155}, {"ilc_k1", 1.414}, {"dead_beat", 1.414}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const int at = cell("white", false, rows[i].controller);
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(0.03 * rows[i].ratio, rows[i].ratio,
                                          rms_m(at) / floor_m(at), rows[i].controller);
    }
}

static void learning_is_worse_than_nothing_on_a_fresh_walk(void)
{
    const double none = rms_m(cell("first_order", false, "none"));
    TEST_ASSERT_TRUE(rms_m(cell("first_order", false, "ilc")) > none);
    TEST_ASSERT_TRUE(rms_m(cell("first_order", false, "ilc_k1")) > none);
}

static void a_dead_beat_integral_meets_the_floor_of_a_walk(void)
{
    const int at = cell("first_order", false, "dead_beat");
    TEST_ASSERT_DOUBLE_WITHIN(0.03, 1.0, rms_m(at) / floor_m(at));
}

static void frozen_noise_has_no_floor_for_learning(void)
{
    TEST_ASSERT_EQUAL_DOUBLE(0.0, floor_m(cell("white", true, "ilc")));
    TEST_ASSERT_TRUE(floor_m(cell("white", true, "none")) > 0.0);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(run_everything);
    RUN_TEST(every_cell_is_what_theory_gives);
    RUN_TEST(ratios_on_fresh_white_noise);
    RUN_TEST(learning_is_worse_than_nothing_on_a_fresh_walk);
    RUN_TEST(a_dead_beat_integral_meets_the_floor_of_a_walk);
    RUN_TEST(frozen_noise_has_no_floor_for_learning);
    exk_rig_close(&rig);
    study_sums_close(&sums);
    return UNITY_END();
}
