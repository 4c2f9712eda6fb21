#include <math.h>
#include <string.h>

#include "exk/feedback.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static exk_feedback_config pid_of(double kp, double ki)
{
    exk_feedback_config cfg = exk_feedback_default();
    cfg.kind = EXK_FEEDBACK_PID;
    cfg.pid = (exk_pid_config){.kp = kp, .ki = ki, .c_max_rad = 1.0, .dt_s = 1.0};
    return cfg;
}

static void init_accepts_and_refuses_by_the_table(void)
{
    const struct {
        const char *name;
        exk_feedback_config cfg;
        exk_err want;
    } rows[] = {
        {"default", exk_feedback_default(), EXK_OK},
        {"pid", pid_of(0.2, 0.5), EXK_OK},
        {"pid with unstable gains", pid_of(0.2, 1.7), EXK_ERR_ARG},
        {"pid with NaN", pid_of(NAN, 0.5), EXK_ERR_ARG},
        {"none does not look at the gains", {.kind = EXK_FEEDBACK_NONE}, EXK_OK},
        {"kind past the end", {.kind = EXK_FEEDBACK_COUNT}, EXK_ERR_ARG},
        {"kind below the first", {.kind = (exk_feedback_kind)-1}, EXK_ERR_ARG},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        exk_feedback fb;
        memset(&fb, 0x5a, sizeof fb);
        const exk_feedback before = fb;
        TEST_ASSERT_EQUAL_MESSAGE(rows[i].want, exk_feedback_init(&fb, &rows[i].cfg),
                                  rows[i].name);
        const int untouched = memcmp(&before, &fb, sizeof fb) == 0;
        TEST_ASSERT_EQUAL_MESSAGE(rows[i].want != EXK_OK, untouched, rows[i].name);
    }
}

static void none_gives_no_correction(void)
{
    const exk_feedback_config cfg = {.kind = EXK_FEEDBACK_NONE};
    exk_feedback fb;
    TEST_ASSERT_EQUAL(EXK_OK, exk_feedback_init(&fb, &cfg));
    const double error[EXK_N_AXES] = {1.0, NAN};
    double c[EXK_N_AXES] = {9.0, 9.0};
    exk_feedback_step(&fb, error, c);
    TEST_ASSERT_TRUE(c[EXK_ALPHA] == 0.0 && c[EXK_BETA] == 0.0);
}

/* Each angle has a controller of its own: NaN in one leaves the other at work. */
static void pid_serves_each_angle_alone(void)
{
    const exk_feedback_config cfg = pid_of(0.25, 0.5);
    exk_feedback fb;
    exk_pid alone[EXK_N_AXES];
    TEST_ASSERT_EQUAL(EXK_OK, exk_feedback_init(&fb, &cfg));
    for (int i = 0; i < EXK_N_AXES; i++) {
        TEST_ASSERT_EQUAL(EXK_OK, exk_pid_init(&alone[i], &cfg.pid));
    }
    for (int k = 0; k < 20; k++) {
        const double error[EXK_N_AXES] = {k == 7 ? NAN : 0.1 * k, -0.05};
        double c[EXK_N_AXES];
        exk_feedback_step(&fb, error, c);
        for (int i = 0; i < EXK_N_AXES; i++) {
            TEST_ASSERT_TRUE(c[i] == exk_pid_step(&alone[i], error[i]));
        }
    }
}

static void reset_begins_again(void)
{
    const exk_feedback_config cfg = pid_of(0.25, 0.5);
    exk_feedback fb;
    TEST_ASSERT_EQUAL(EXK_OK, exk_feedback_init(&fb, &cfg));
    const double error[EXK_N_AXES] = {0.1, -0.2};
    double first[EXK_N_AXES];
    double again[EXK_N_AXES];
    exk_feedback_step(&fb, error, first);
    exk_feedback_step(&fb, error, again);
    TEST_ASSERT_TRUE(first[EXK_ALPHA] != again[EXK_ALPHA]);
    exk_feedback_reset(&fb);
    exk_feedback_step(&fb, error, again);
    TEST_ASSERT_TRUE(first[EXK_ALPHA] == again[EXK_ALPHA]);
    TEST_ASSERT_TRUE(first[EXK_BETA] == again[EXK_BETA]);
}

/* As one that had that correction and knows no error before: the derivative sees no step. */
static void preset_goes_on_from_a_correction(void)
{
    exk_feedback_config cfg = pid_of(0.25, 0.5);
    cfg.pid.kd = 1e-4;
    exk_feedback fb;
    const double error[EXK_N_AXES] = {0.04, -0.02};
    const double held[EXK_N_AXES] = {0.01, -0.03};
    double c[EXK_N_AXES];
    TEST_ASSERT_EQUAL(EXK_OK, exk_feedback_init(&fb, &cfg));
    exk_feedback_step(&fb, error, c);
    exk_feedback_preset(&fb, held);
    exk_feedback_step(&fb, error, c);
    for (int i = 0; i < EXK_N_AXES; i++) {
        const double want = held[i] + (0.25 + 0.5 * cfg.pid.dt_s) * error[i];
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, want, c[i]);
    }
}

static void every_kind_has_a_name_of_its_own(void)
{
    TEST_ASSERT_EQUAL_STRING("none", exk_feedback_name(EXK_FEEDBACK_NONE));
    TEST_ASSERT_EQUAL_STRING("pid", exk_feedback_name(EXK_FEEDBACK_PID));
    TEST_ASSERT_EQUAL_STRING("unknown", exk_feedback_name(EXK_FEEDBACK_COUNT));
    TEST_ASSERT_EQUAL_STRING("unknown", exk_feedback_name((exk_feedback_kind)-1));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(init_accepts_and_refuses_by_the_table);
    RUN_TEST(none_gives_no_correction);
    RUN_TEST(pid_serves_each_angle_alone);
    RUN_TEST(reset_begins_again);
    RUN_TEST(preset_goes_on_from_a_correction);
    RUN_TEST(every_kind_has_a_name_of_its_own);
    return UNITY_END();
}
