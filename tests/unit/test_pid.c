#include <float.h>
#include <math.h>
#include <string.h>

#include "exk/pid.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* --- what init refuses ------------------------------------------------------------------------ */

/* kp, ki, kd, d_filter, c_max, dt; dt = 1 makes ki the gain g of a step. */
static const struct {
    const char *name;
    exk_pid_config cfg;
    exk_err want;
} checks[] = {
    {"all gains 0", {0.0, 0.0, 0.0, 0.0, 1.0, 1.0}, EXK_OK},
    {"the study's PI", {0.2, 500.0, 0.0, 0.0, 0.1, 1e-3}, EXK_OK},
    {"kp just below 1", {1.0 - DBL_EPSILON, 0.0, 0.0, 0.0, 1.0, 1.0}, EXK_OK},
    {"kp 1", {1.0, 0.0, 0.0, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"kp negative", {-1e-300, 0.0, 0.0, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"g just below 2 (1 - kp)", {0.25, 1.5 - 1e-15, 0.0, 0.0, 1.0, 1.0}, EXK_OK},
    {"g at 2 (1 - kp)", {0.25, 1.5, 0.0, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"integral only, just below 2", {0.0, 2.0 - 1e-15, 0.0, 0.0, 1.0, 1.0}, EXK_OK},
    {"integral only, 2", {0.0, 2.0, 0.0, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"g through dt", {0.0, 2000.0, 0.0, 0.0, 1.0, 1e-3}, EXK_ERR_ARG},
    {"ki negative", {0.5, -0.1, 0.0, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"derivative only, just below h = 1/2", {0.0, 0.0, 0.5 - 1e-15, 0.0, 1.0, 1.0}, EXK_OK},
    {"derivative only, h = 1/2", {0.0, 0.0, 0.5, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"all three on the border: a root at -1", {0.5, 0.5, 0.125, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"all three, just inside", {0.5, 0.5, 0.125 - 1e-15, 0.0, 1.0, 1.0}, EXK_OK},
    {"kd negative", {0.2, 0.2, -1e-3, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"filter negative", {0.2, 0.2, 0.1, -1.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"limit 0", {0.2, 0.2, 0.0, 0.0, 0.0, 1.0}, EXK_ERR_ARG},
    {"limit negative", {0.2, 0.2, 0.0, 0.0, -1.0, 1.0}, EXK_ERR_ARG},
    {"dt 0", {0.2, 0.2, 0.0, 0.0, 1.0, 0.0}, EXK_ERR_ARG},
    {"dt negative", {0.2, 0.0, 0.0, 0.0, 1.0, -1.0}, EXK_ERR_ARG},
    {"kp NaN", {NAN, 0.2, 0.0, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"ki NaN", {0.2, NAN, 0.0, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"kd NaN", {0.2, 0.2, NAN, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"filter NaN", {0.2, 0.2, 0.1, NAN, 1.0, 1.0}, EXK_ERR_ARG},
    {"limit NaN", {0.2, 0.2, 0.0, 0.0, NAN, 1.0}, EXK_ERR_ARG},
    {"dt NaN", {0.2, 0.2, 0.0, 0.0, 1.0, NAN}, EXK_ERR_ARG},
    {"kp Inf", {INFINITY, 0.2, 0.0, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"ki Inf", {0.2, INFINITY, 0.0, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"kd Inf", {0.2, 0.2, INFINITY, 0.0, 1.0, 1.0}, EXK_ERR_ARG},
    {"filter Inf", {0.2, 0.2, 0.1, INFINITY, 1.0, 1.0}, EXK_ERR_ARG},
    {"limit Inf", {0.2, 0.2, 0.0, 0.0, INFINITY, 1.0}, EXK_ERR_ARG},
    {"dt Inf", {0.2, 0.0, 0.0, 0.0, 1.0, INFINITY}, EXK_ERR_ARG},
};

static void init_accepts_and_refuses_by_the_table(void)
{
    for (size_t i = 0; i < sizeof checks / sizeof *checks; i++) {
        exk_pid pid;
        memset(&pid, 0x5a, sizeof pid);
        const exk_pid before = pid;
        TEST_ASSERT_EQUAL_MESSAGE(checks[i].want, exk_pid_init(&pid, &checks[i].cfg),
                                  checks[i].name);
        const int untouched = memcmp(&before, &pid, sizeof pid) == 0;
        TEST_ASSERT_EQUAL_MESSAGE(checks[i].want != EXK_OK, untouched, checks[i].name);
    }
}

static exk_pid start(exk_pid_config cfg)
{
    exk_pid pid;
    TEST_ASSERT_EQUAL(EXK_OK, exk_pid_init(&pid, &cfg));
    return pid;
}

static void the_default_is_accepted(void)
{
    exk_pid pid = start(exk_pid_default());
    TEST_ASSERT_TRUE(exk_pid_step(&pid, 0.0) == 0.0);
}

/* --- the law, number by number ---------------------------------------------------------------- */

/* Gains and errors are sums of powers of two, so every product is exact. */
static const struct {
    const char *name;
    exk_pid_config cfg;
    double error[4];
    double want[4];
} sequences[] = {
    {"no error, no command", {0.25, 0.25, 0.25, 0.0, 8.0, 1.0}, {0.0}, {0.0}},
    {"proportional only", {0.5, 0.0, 0.0, 0.0, 8.0, 1.0}, {1, -2, 0, 4}, {0.5, -1, 0, 2}},
    {"integral only", {0.0, 0.5, 0.0, 0.0, 8.0, 1.0}, {1, 1, -2, 4}, {0.5, 1, 0, 2}},
    {"integral by time", {0.0, 2.0, 0.0, 0.0, 8.0, 0.25}, {1, 1, -2, 4}, {0.5, 1, 0, 2}},
    {"both", {0.25, 0.5, 0.0, 0.0, 8.0, 1.0}, {1, 1, -2, 4}, {0.75, 1.25, -0.5, 3}},
    {"the first derivative is 0",
     {0.0, 0.0, 0.25, 0.0, 8.0, 1.0},
     {4, 4, 6, 2},
     {0, 0, 0.5, -1}},
    {"derivative by time", {0.0, 0.0, 0.0625, 0.0, 8.0, 0.25}, {4, 4, 6, 2}, {0, 0, 0.5, -1}},
    {"all three", {0.25, 0.25, 0.25, 0.0, 8.0, 1.0}, {4, 0, 4, 4}, {2, 0, 4, 4}},
    {"clips above and below", {0.5, 0.0, 0.0, 0.0, 1.0, 1.0}, {2, 3, -2, -9}, {1, 1, -1, -1}},
};

static void steps_follow_the_law(void)
{
    for (size_t i = 0; i < sizeof sequences / sizeof *sequences; i++) {
        exk_pid pid = start(sequences[i].cfg);
        for (int k = 0; k < 4; k++) {
            const double c = exk_pid_step(&pid, sequences[i].error[k]);
            TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(sequences[i].want[k], c, sequences[i].name);
            TEST_ASSERT_TRUE(pid.output_rad == c);
        }
    }
}

/* A step of the error from 0 to 1 after the first: D = (kd/dt)(1 - b) b^k. */
static void the_derivative_decays_with_its_filter(void)
{
    exk_pid pid = start((exk_pid_config){0.0, 0.0, 1e-4, 4e-3, 1.0, 1e-3});
    const double b = exp(-0.25);
    TEST_ASSERT_TRUE(exk_pid_step(&pid, 0.0) == 0.0);
    for (int k = 0; k < 20; k++) {
        const double want = 0.1 * (1.0 - b) * exp(-0.25 * k);
        TEST_ASSERT_DOUBLE_WITHIN(1e-16, want, exk_pid_step(&pid, 1.0));
    }
}

/* --- saturation ------------------------------------------------------------------------------- */

/* The integral stays at what it was when the limit was met, so the first error of the other sign
 * is answered at once, in both directions. */
static void the_integral_does_not_wind_up(void)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        exk_pid pid = start((exk_pid_config){0.0, 0.25, 0.0, 0.0, 1.0, 1.0});
        for (int k = 0; k < 1000; k++) {
            const double c = exk_pid_step(&pid, sign);
            TEST_ASSERT_EQUAL_DOUBLE(sign * fmin(0.25 * (k + 1), 1.0), c);
        }
        TEST_ASSERT_EQUAL_DOUBLE(sign * 0.75, exk_pid_step(&pid, -sign));
    }
}

/* kp e alone holds the output at the limit; an integral of the other sign still unwinds. */
static void an_error_that_leads_back_is_integrated_in_saturation(void)
{
    exk_pid pid = start((exk_pid_config){0.5, 0.25, 0.0, 0.0, 1.0, 1.0});
    exk_pid_preset(&pid, -1.0, 0.0);
    TEST_ASSERT_EQUAL_DOUBLE(-0.25, exk_pid_step(&pid, 1.0));
    TEST_ASSERT_EQUAL_DOUBLE(1.0, exk_pid_step(&pid, 8.0));
    exk_pid_preset(&pid, 1.0, -8.0);
    const double held = pid.integral_rad;
    TEST_ASSERT_EQUAL_DOUBLE(5.0, held);
    TEST_ASSERT_EQUAL_DOUBLE(1.0, exk_pid_step(&pid, -1.0));
    TEST_ASSERT_EQUAL_DOUBLE(4.75, pid.integral_rad);
}

/* --- bad errors ------------------------------------------------------------------------------- */

static void an_error_that_is_not_finite_changes_nothing(void)
{
    static const double bad[] = {NAN, -NAN, INFINITY, -INFINITY};
    exk_pid pid = start((exk_pid_config){0.2, 0.3, 0.1, 2.0, 1.0, 1.0});
    exk_pid clean = pid;
    for (int k = 0; k < 40; k++) {
        const double e = sin(0.3 * k);
        TEST_ASSERT_TRUE(exk_pid_step(&pid, e) == exk_pid_step(&clean, e));
        TEST_ASSERT_TRUE(exk_pid_step(&pid, bad[k % 4]) == clean.output_rad);
    }
}

/* Finite errors whose difference overflows: every output stays finite and inside the limit. */
static void huge_errors_never_leave_the_limit(void)
{
    static const double huge[] = {DBL_MAX, -DBL_MAX, 1e300, -DBL_MAX, DBL_MAX, 0.0};
    exk_pid pid = start((exk_pid_config){0.2, 0.3, 0.1, 2.0, 1.0, 1.0});
    for (int k = 0; k < 600; k++) {
        TEST_ASSERT_TRUE(fabs(exk_pid_step(&pid, huge[(k * k + k / 7) % 6])) <= 1.0);
        TEST_ASSERT_TRUE(isfinite(pid.integral_rad) && isfinite(pid.derivative_rad));
    }
}

/* --- reset and preset ------------------------------------------------------------------------- */

static void reset_clears_the_state_and_keeps_the_configuration(void)
{
    const exk_pid_config cfg = {0.2, 0.3, 0.1, 2.0, 1.0, 1.0};
    exk_pid pid = start(cfg);
    exk_pid fresh = start(cfg);
    for (int k = 0; k < 10; k++) {
        (void)exk_pid_step(&pid, 1.0 + k);
    }
    exk_pid_reset(&pid);
    for (int k = 0; k < 10; k++) {
        TEST_ASSERT_TRUE(exk_pid_step(&pid, 0.1 * k) == exk_pid_step(&fresh, 0.1 * k));
    }
}

/* With the error unchanged the output goes on from where it was: only ki dt e is added. */
static void preset_is_bumpless(void)
{
    static const struct {
        double output, error, want;
    } rows[] = {
        {0.5, 0.0, 0.5},
        {0.5, 0.25, 0.5 + 0.125 * 0.25},
        {-0.5, 0.25, -0.5 + 0.125 * 0.25},
        {7.0, -1.0, 0.875},
        {-7.0, 1.0, -0.875},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        exk_pid pid = start((exk_pid_config){0.25, 0.125, 0.0625, 2.0, 1.0, 1.0});
        (void)exk_pid_step(&pid, 3.0);
        (void)exk_pid_step(&pid, -3.0);
        TEST_ASSERT_TRUE(pid.derivative_rad != 0.0);
        exk_pid_preset(&pid, rows[i].output, rows[i].error);
        TEST_ASSERT_EQUAL_DOUBLE(fmax(-1.0, fmin(1.0, rows[i].output)), pid.output_rad);
        TEST_ASSERT_EQUAL_DOUBLE(rows[i].want, exk_pid_step(&pid, rows[i].error));
    }
}

static void preset_with_bad_numbers_changes_nothing(void)
{
    static const double bad[][2] = {{NAN, 0.0}, {INFINITY, 0.0}, {-INFINITY, 0.0},
                                    {0.1, NAN}, {0.1, INFINITY}, {NAN, NAN}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        exk_pid pid = start((exk_pid_config){0.25, 0.125, 0.0, 0.0, 1.0, 1.0});
        (void)exk_pid_step(&pid, 1.0);
        exk_pid clean = pid;
        exk_pid_preset(&pid, bad[i][0], bad[i][1]);
        TEST_ASSERT_TRUE(pid.output_rad == clean.output_rad);
        TEST_ASSERT_TRUE(exk_pid_step(&pid, 0.5) == exk_pid_step(&clean, 0.5));
    }
}

/* D alone, kd/dt = 0.4: it sees the step from the error that was rejoined, not from the one before. */
static void after_a_gap_the_derivative_sees_no_jump(void)
{
    const exk_pid_config cfg = {.kd = 0.4, .c_max_rad = 10.0, .dt_s = 1.0};
    exk_pid pid;
    TEST_ASSERT_EQUAL(EXK_OK, exk_pid_init(&pid, &cfg));
    TEST_ASSERT_EQUAL_DOUBLE(0.0, exk_pid_step(&pid, 1.0));
    exk_pid_rejoin(&pid, 3.0);
    exk_pid_rejoin(&pid, (double)NAN);
    exk_pid_rejoin(&pid, (double)INFINITY);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.4, exk_pid_step(&pid, 4.0));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(init_accepts_and_refuses_by_the_table);
    RUN_TEST(the_default_is_accepted);
    RUN_TEST(steps_follow_the_law);
    RUN_TEST(the_derivative_decays_with_its_filter);
    RUN_TEST(the_integral_does_not_wind_up);
    RUN_TEST(an_error_that_leads_back_is_integrated_in_saturation);
    RUN_TEST(an_error_that_is_not_finite_changes_nothing);
    RUN_TEST(huge_errors_never_leave_the_limit);
    RUN_TEST(reset_clears_the_state_and_keeps_the_configuration);
    RUN_TEST(preset_is_bumpless);
    RUN_TEST(preset_with_bad_numbers_changes_nothing);
    RUN_TEST(after_a_gap_the_derivative_sees_no_jump);
    return UNITY_END();
}
