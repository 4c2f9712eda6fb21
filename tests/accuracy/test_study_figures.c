/* S1 to S9 again with fixed seeds: the verdicts that hold and those that do not, as intervals, so that a
 * change in either direction is seen. The intervals come from exk-study paper --seeds 2000, widened by
 * the error of the fewer seeds here (about 4 standard errors). */
#include <math.h>
#include <string.h>

#include "claims.h"
#include "unity.h"
#include "words.h"
#include "work.h"

enum { SEEDS = 100, SEEDS_OF_WORDS = 500 };

static const char folder[] = EXK_SOURCE_DIR "/profiles/study";
static study_paper all;
static study_paper few; /* S4 alone, many seeds */
static study_sums sums;
static study_sums many;

void setUp(void)
{
}

void tearDown(void)
{
}

static void run(study_paper *paper, study_sums *totals, uint32_t parts, uint64_t n_seeds)
{
    const study_work work = {.n_trials = n_seeds, .n_threads = 2, .quiet = true};
    TEST_ASSERT_EQUAL_INT(STUDY_GOOD, study_paper_init(paper, folder, parts));
    TEST_ASSERT_EQUAL_INT(STUDY_GOOD, study_sums_open(totals, paper->measures, STUDY_N_PAPER));
    TEST_ASSERT_EQUAL_INT(STUDY_GOOD, study_run(&paper->task, &work, totals));
}

static void run_everything(void)
{
    run(&all, &sums, STUDY_ALL_PARTS, SEEDS);
    run(&few, &many, 1U << STUDY_PART_S4, SEEDS_OF_WORDS);
    TEST_ASSERT_EQUAL_STRING("frozen", all.noise);
}

static void published_figures(void)
{
    static const struct {
        const char *id;
        double mean_low, mean_high;
        bool inside;
    } rows[] = {
        {"S5", 0.098, 0.149, true},       {"S6", 0.056, 0.087, true},
        {"S7_min", 0.0038, 0.0058, true}, {"S7_max", 0.0478, 0.0543, true},
        {"S8_min", 0.0071, 0.0132, true}, {"S8_max", 0.062, 0.084, true},
        {"S9_rate", 0.69, 0.75, true},    {"S9_mean", 0.0228, 0.0244, true},
        {"S10_rate", 0.69, 0.75, false},  {"S10_mean", 0.0228, 0.0244, false},
        {"S11_rate", 0.69, 0.75, true},   {"S11_mean", 0.0228, 0.0244, true},
    };
    size_t n = 0;
    const study_claim *claims = study_claims(&n);
    TEST_ASSERT_EQUAL_UINT64(sizeof rows / sizeof rows[0], n);
    for (size_t i = 0; i < n; i++) {
        const study_verdict v = study_judge(&claims[i], sums.tallies);
        TEST_ASSERT_EQUAL_STRING(rows[i].id, claims[i].id);
        TEST_ASSERT_TRUE_MESSAGE(rows[i].mean_low <= v.mean && v.mean <= rows[i].mean_high,
                                 rows[i].id);
        TEST_ASSERT_EQUAL_MESSAGE(rows[i].inside, v.inside, rows[i].id);
    }
}

static bool holds(const study_sums *totals, const char *id)
{
    study_word words[STUDY_WORDS_MAX];
    const size_t n = study_words(totals->tallies, words);
    for (size_t i = 0; i < n; i++) {
        if (strcmp(words[i].id, id) == 0) {
            return words[i].holds;
        }
    }
    TEST_FAIL_MESSAGE(id);
    return false;
}

static void claims_in_words(void)
{
    static const struct {
        const char *id;
        bool holds;
    } rows[] = {
        {"S1", true},           {"S1_both", true},
        {"S2", true},           {"S2_zero_order", false},
        {"S3_negative", true},  {"S3_positive", true},
        {"S3_strongest", true}, {"S3_over_sine", true},
        {"S4_run2", true},      {"S4_run3", true},
        {"S4_gap", true},       {"S7_edge", false},
        {"S7_turn", false},     {"S8_mean", true},
        {"S8_edge", false},     {"S8_turn", false},
        {"S10", true},          {"S11", false},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        TEST_ASSERT_EQUAL_MESSAGE(rows[i].holds, holds(&sums, rows[i].id), rows[i].id);
    }
}

/* The gap at the last point has |dx| > |dy| by the ratio of the arms, 1.10: seen only over many
 * seeds. On their own arms the two are alike: 2/pi atan(1.10) = 53 % of the trials. */
static void the_gap_at_the_last_point_is_larger_in_x(void)
{
    const study_tally *t = &many.tallies[STUDY_M_S4_DX_LESS_DY];
    const double share = (double)t->n_positive / (double)t->moments.n;
    TEST_ASSERT_DOUBLE_WITHIN(4.0 * 0.5 / 22.4, 0.530, share); /* 4 sigma of 500 trials */
    TEST_ASSERT_TRUE(t->moments.mean > 0.0);
}

/* Frozen noise: each run leaves 1 - K of the error; the tip is linear in the angles to 1e-3. */
static void learning_halves_the_error(void)
{
    const double first = sums.tallies[STUDY_M_S5_LAST_1].moments.mean;
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 0.5, sums.tallies[STUDY_M_S5_LAST_2].moments.mean / first);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 0.25, sums.tallies[STUDY_M_S5_LAST_3].moments.mean / first);
}

/* Learning as the study words it: the tool's position is learned and given back through the inverse,
 * u + K (p_ref - p) in the plane. Error left after three runs at one tick, its noise given. */
static double learned_by_position_m(const study_lab *lab, const exk_waypoint *at,
                                    const double n_rad[EXK_N_AXES])
{
    double u_m[2] = {0.0, 0.0};
    double e_m[2] = {0.0, 0.0};
    for (int run = 1; run <= 3; run++) {
        exk_tool tool = at->ref.tool;
        exk_joints joints;
        for (int i = 0; i < 2; i++) {
            u_m[i] += 0.5 * e_m[i];
            tool.tip_m[i] += u_m[i];
        }
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_inverse(&lab->rig->kin, &tool, &joints));
        joints.angle_rad[EXK_ALPHA] += n_rad[EXK_ALPHA];
        joints.angle_rad[EXK_BETA] += n_rad[EXK_BETA];
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_forward(&lab->rig->kin, &joints, &tool));
        e_m[0] = at->ref.tool.tip_m[0] - tool.tip_m[0];
        e_m[1] = at->ref.tool.tip_m[1] - tool.tip_m[1];
    }
    return sqrt(e_m[0] * e_m[0] + e_m[1] * e_m[1]);
}

/* On the enlarged noise of S4, 20 mrad and 20 mm at the last point, both ways leave the same: the
 * two differ by the curvature, of second order in 20 mrad. */
static void learning_angles_is_learning_positions(void)
{
    const study_variant as_published = study_as_published();
    study_lab lab;
    double by_angle_m = 0.0, by_position_m = 0.0, largest = 0.0;
    TEST_ASSERT_EQUAL(STUDY_GOOD, study_lab_open(&lab, folder, STUDY_S4, &as_published));
    for (uint32_t trial = 0; trial < 50; trial++) {
        exk_accuracy accuracy;
        TEST_ASSERT_EQUAL(STUDY_GOOD, study_lab_trial(&lab, trial, &accuracy));
        const size_t last = lab.series.n - 1;
        const double n_rad[] = {lab.series.noise_rad[0][last], lab.series.noise_rad[1][last]};
        const double other_m = learned_by_position_m(&lab, &lab.series.way[last], n_rad);
        by_angle_m += accuracy.last_point_m;
        by_position_m += other_m;
        largest = fmax(largest, fabs(other_m - accuracy.last_point_m) / accuracy.last_point_m);
    }
    study_lab_close(&lab);
    TEST_ASSERT_DOUBLE_WITHIN(0.01, 1.0, by_position_m / by_angle_m);
    TEST_ASSERT_TRUE(largest > 0.0 && largest < 0.05);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(run_everything);
    if (Unity.TestFailures == 0) { /* the others judge what it counted */
        RUN_TEST(published_figures);
        RUN_TEST(claims_in_words);
        RUN_TEST(the_gap_at_the_last_point_is_larger_in_x);
        RUN_TEST(learning_halves_the_error);
    }
    RUN_TEST(learning_angles_is_learning_positions);
    study_sums_close(&sums);
    study_sums_close(&many);
    return UNITY_END();
}
