#include <math.h>

#include "exk/twin.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static const exk_realisation which = {.seed = 5, .series = 1, .run = 1};

static exk_disturbance_config walk_of(double sigma)
{
    exk_disturbance_config cfg = exk_disturbance_default();
    cfg.wave = EXK_WAVE_GAUSSIAN;
    cfg.order = 1;
    cfg.amplitude = sigma;
    return cfg;
}

static exk_twin start(const exk_twin_config *cfg)
{
    exk_twin twin;
    TEST_ASSERT_EQUAL(EXK_OK, exk_twin_init(&twin, cfg, which));
    return twin;
}

static exk_reading step(exk_twin *twin, int64_t k, double alpha, double beta)
{
    const double q[EXK_N_AXES] = {alpha, beta};
    exk_reading out = {.has_true = false, .fresh = false};
    exk_twin_step(twin, k, q, &out);
    TEST_ASSERT_TRUE(out.has_true && out.fresh);
    return out;
}

/* --- what init refuses ------------------------------------------------------------------------ */

static const struct {
    const char *name;
    exk_twin_config cfg;
    exk_err want;
} checks[] = {
    {"plain", {.dt_s = 1e-3}, EXK_OK},
    {"everything", {1e-3, 5e-3, 1e-6, 1e-7, true, {{.order = 1}}, 1}, EXK_OK},
    {"all places taken", {.dt_s = 1e-3, .n_disturbances = EXK_MAX_DISTURBANCES}, EXK_OK},
    {"one too many", {.dt_s = 1e-3, .n_disturbances = EXK_MAX_DISTURBANCES + 1}, EXK_ERR_SIZE},
    {"dt 0", {.dt_s = 0.0}, EXK_ERR_ARG},
    {"dt negative", {.dt_s = -1e-3}, EXK_ERR_ARG},
    {"dt NaN", {.dt_s = NAN}, EXK_ERR_ARG},
    {"dt Inf", {.dt_s = INFINITY}, EXK_ERR_ARG},
    {"tau negative", {.dt_s = 1e-3, .servo_tau_s = -1.0}, EXK_ERR_ARG},
    {"tau NaN", {.dt_s = 1e-3, .servo_tau_s = NAN}, EXK_ERR_ARG},
    {"tau Inf", {.dt_s = 1e-3, .servo_tau_s = INFINITY}, EXK_ERR_ARG},
    {"sigma negative", {.dt_s = 1e-3, .sensor_sigma_rad = -1.0}, EXK_ERR_ARG},
    {"sigma NaN", {.dt_s = 1e-3, .sensor_sigma_rad = NAN}, EXK_ERR_ARG},
    {"sigma Inf", {.dt_s = 1e-3, .sensor_sigma_rad = INFINITY}, EXK_ERR_ARG},
    {"quantum negative", {.dt_s = 1e-3, .sensor_quantum_rad = -1.0}, EXK_ERR_ARG},
    {"quantum NaN", {.dt_s = 1e-3, .sensor_quantum_rad = NAN}, EXK_ERR_ARG},
    {"quantum Inf", {.dt_s = 1e-3, .sensor_quantum_rad = INFINITY}, EXK_ERR_ARG},
    {"second disturbance refused",
     {.dt_s = 1e-3, .disturbance = {{.order = 0}, {.order = 9}}, .n_disturbances = 2},
     EXK_ERR_ARG},
    {"a disturbance past the count is not looked at",
     {.dt_s = 1e-3, .disturbance = {{.order = 0}, {.order = 9}}, .n_disturbances = 1},
     EXK_OK},
};

static void init_accepts_and_refuses_by_the_table(void)
{
    for (size_t i = 0; i < sizeof checks / sizeof *checks; i++) {
        exk_twin twin;
        TEST_ASSERT_EQUAL_MESSAGE(checks[i].want, exk_twin_init(&twin, &checks[i].cfg, which),
                                  checks[i].name);
    }
}

/* --- servo ------------------------------------------------------------------------------------ */

static void the_default_passes_the_command_on_exactly(void)
{
    const exk_twin_config cfg = exk_twin_default();
    exk_twin twin = start(&cfg);
    for (int64_t k = 0; k < 10; k++) {
        const exk_reading m = step(&twin, k, 0.1 * (double)k, -0.3);
        TEST_ASSERT_TRUE(m.true_rad[EXK_ALPHA] == 0.1 * (double)k);
        TEST_ASSERT_TRUE(m.measured_rad[EXK_ALPHA] == m.true_rad[EXK_ALPHA]);
        TEST_ASSERT_TRUE(m.measured_rad[EXK_BETA] == -0.3);
    }
}

/* A step of the command from 0 to 1 at tick 1: x[k] = 1 - exp(-k dt / tau). */
static void a_step_rises_with_the_time_constant(void)
{
    exk_twin_config cfg = exk_twin_default();
    cfg.servo_tau_s = 8e-3;
    exk_twin twin = start(&cfg);
    TEST_ASSERT_TRUE(step(&twin, 0, 0.0, 0.7).true_rad[EXK_BETA] == 0.7);
    for (int64_t k = 1; k < 100; k++) {
        const exk_reading m = step(&twin, k, 1.0, 0.7);
        TEST_ASSERT_DOUBLE_WITHIN(1e-14, -expm1(-(double)k / 8.0), m.true_rad[EXK_ALPHA]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-14, 0.7, m.true_rad[EXK_BETA]);
    }
}

static void skipped_ticks_hold_the_last_command(void)
{
    exk_twin_config cfg = exk_twin_default();
    cfg.servo_tau_s = 4e-3;
    cfg.disturbance[0] = walk_of(1e-3);
    cfg.n_disturbances = 1;
    exk_twin every = start(&cfg);
    exk_twin some = start(&cfg);
    double held = 0.0;
    for (int64_t k = 0; k < 200; k++) {
        const bool seen = k == 0 || k % 6 == 5 || k % 6 == 1; /* 1 or 3 skipped */
        held = seen ? sin(0.1 * (double)k) : held;
        const exk_reading a = step(&every, k, held, -held);
        if (seen) {
            const exk_reading b = step(&some, k, held, -held);
            TEST_ASSERT_DOUBLE_WITHIN(1e-14, a.true_rad[EXK_ALPHA], b.true_rad[EXK_ALPHA]);
            TEST_ASSERT_DOUBLE_WITHIN(1e-14, a.true_rad[EXK_BETA], b.true_rad[EXK_BETA]);
        }
    }
}

static void a_tick_that_does_not_rise_moves_nothing(void)
{
    exk_twin_config cfg = exk_twin_default();
    cfg.servo_tau_s = 4e-3;
    exk_twin twin = start(&cfg);
    (void)step(&twin, 0, 0.0, 0.0);
    const double there = step(&twin, 5, 1.0, 0.0).true_rad[EXK_ALPHA];
    TEST_ASSERT_TRUE(step(&twin, 5, 9.0, 0.0).true_rad[EXK_ALPHA] == there);
    TEST_ASSERT_TRUE(step(&twin, 3, 9.0, 0.0).true_rad[EXK_ALPHA] == there);
}

/* NaN or Inf in either angle: both stay, also over skipped ticks, and later commands work. */
static void a_bad_command_leaves_the_servo_where_it_is(void)
{
    static const double bad[][EXK_N_AXES] = {
        {NAN, 0.2}, {0.2, NAN}, {INFINITY, 0.2}, {0.2, -INFINITY}};
    for (size_t i = 0; i < 4; i++) {
        for (int lag = 0; lag < 2; lag++) {
            exk_twin_config cfg = exk_twin_default();
            cfg.servo_tau_s = lag * 3e-3;
            exk_twin twin = start(&cfg);
            (void)step(&twin, 0, 0.0, 0.0);
            const exk_reading before = step(&twin, 1, 0.1, -0.1);
            const exk_reading m = step(&twin, 2, bad[i][0], bad[i][1]);
            const exk_reading later = step(&twin, 9, bad[i][0], bad[i][1]);
            for (int axis = 0; axis < EXK_N_AXES; axis++) {
                TEST_ASSERT_DOUBLE_WITHIN(1e-15, before.true_rad[axis], m.true_rad[axis]);
                TEST_ASSERT_DOUBLE_WITHIN(1e-15, before.true_rad[axis], later.true_rad[axis]);
            }
            (void)step(&twin, 10, 0.3, 0.3); /* a second of it: 300 time constants */
            TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.3, step(&twin, 1010, 0.3, 0.3).true_rad[0]);
        }
    }
}

static void before_the_first_good_command_the_servo_is_at_zero(void)
{
    exk_twin_config cfg = exk_twin_default();
    cfg.servo_tau_s = 3e-3;
    exk_twin twin = start(&cfg);
    const exk_reading m = step(&twin, 0, NAN, 0.5);
    TEST_ASSERT_TRUE(m.true_rad[EXK_ALPHA] == 0.0 && m.true_rad[EXK_BETA] == 0.0);
    TEST_ASSERT_TRUE(step(&twin, 1, 0.4, 0.5).true_rad[EXK_ALPHA] == 0.4);
}

/* --- disturbances and sensor ------------------------------------------------------------------ */

static void disturbances_add_up_as_sources_of_their_own(void)
{
    exk_twin_config cfg = exk_twin_default();
    cfg.disturbance[0] = walk_of(1e-3);
    cfg.disturbance[1] = walk_of(2e-3);
    cfg.n_disturbances = 2;
    exk_twin twin = start(&cfg);
    exk_disturbance alone[2];
    for (int i = 0; i < 2; i++) {
        const exk_disturbance_config one = cfg.disturbance[i];
        TEST_ASSERT_EQUAL(EXK_OK,
                          exk_disturbance_init(&alone[i], &one, cfg.dt_s, which, (uint8_t)i));
    }
    for (int64_t k = 0; k < 50; k++) {
        double sum[EXK_N_AXES] = {0.1, 0.2};
        exk_disturbance_add(&alone[0], k, sum);
        exk_disturbance_add(&alone[1], k, sum);
        const exk_reading m = step(&twin, k, 0.1, 0.2);
        TEST_ASSERT_TRUE(m.true_rad[EXK_ALPHA] == sum[EXK_ALPHA]);
        TEST_ASSERT_TRUE(m.true_rad[EXK_BETA] == sum[EXK_BETA]);
    }
}

static void the_sensor_adds_its_draw_to_the_measured_angle_only(void)
{
    exk_twin_config cfg = exk_twin_default();
    cfg.sensor_sigma_rad = 1e-4;
    exk_twin twin = start(&cfg);
    for (int64_t k = 0; k < 20; k++) {
        const exk_reading m = step(&twin, k, 0.1, 0.2);
        for (int axis = 0; axis < EXK_N_AXES; axis++) {
            const exk_stream v = {5, 1, 1, EXK_SOURCE_SENSOR, (uint8_t)axis};
            const double theta = axis == EXK_ALPHA ? 0.1 : 0.2;
            TEST_ASSERT_TRUE(m.true_rad[axis] == theta);
            TEST_ASSERT_TRUE(m.measured_rad[axis] == theta + 1e-4 * exk_normal(&v, k));
        }
    }
}

static double first_measured(bool frozen, uint32_t run)
{
    exk_twin_config cfg = exk_twin_default();
    cfg.sensor_sigma_rad = 1e-4;
    cfg.sensor_frozen = frozen;
    exk_twin twin;
    const exk_realisation r = {.seed = 5, .series = 1, .run = run};
    TEST_ASSERT_EQUAL(EXK_OK, exk_twin_init(&twin, &cfg, r));
    return step(&twin, 0, 0.0, 0.0).measured_rad[EXK_ALPHA];
}

static void sensor_noise_is_fresh_unless_frozen(void)
{
    TEST_ASSERT_TRUE(first_measured(false, 1) != first_measured(false, 2));
    TEST_ASSERT_TRUE(first_measured(true, 1) == first_measured(true, 2));
    TEST_ASSERT_FALSE(exk_twin_default().sensor_frozen);
}

static void the_encoder_rounds_to_its_quantum(void)
{
    static const struct {
        double theta, want;
    } rows[] = {
        {0.0, 0.0},  {0.124, 0.0},    {0.126, 0.25},  {0.375, 0.5},
        {-0.1, 0.0}, {-0.126, -0.25}, {-0.375, -0.5}, {100.2, 100.25},
    };
    exk_twin_config cfg = exk_twin_default();
    cfg.sensor_quantum_rad = 0.25;
    exk_twin twin = start(&cfg);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const exk_reading m = step(&twin, (int64_t)i, rows[i].theta, 0.0);
        TEST_ASSERT_TRUE(m.measured_rad[EXK_ALPHA] == rows[i].want);
        TEST_ASSERT_TRUE(m.true_rad[EXK_ALPHA] == rows[i].theta);
    }
}

/* --- life cycle and interface ----------------------------------------------------------------- */

static exk_twin_config full(void)
{
    exk_twin_config cfg = exk_twin_default();
    cfg.servo_tau_s = 5e-3;
    cfg.sensor_sigma_rad = 1e-4;
    cfg.sensor_quantum_rad = 1e-6;
    cfg.disturbance[0] = walk_of(1e-3);
    cfg.n_disturbances = 1;
    return cfg;
}

static void reset_and_the_source_give_the_same_readings(void)
{
    const exk_twin_config cfg = full();
    exk_twin twin = start(&cfg);
    exk_twin again = start(&cfg);
    exk_twin other = start(&cfg);
    (void)step(&again, 17, 3.0, 4.0);
    exk_twin_reset(&again);
    const exk_source source = exk_twin_source(&other);
    for (int64_t k = 0; k < 30; k++) {
        const double q = 0.01 * (double)k;
        const exk_reading a = step(&twin, k, q, -q);
        const exk_reading b = step(&again, k, q, -q);
        const exk_drive drive = {.angle_rad = {q, -q}};
        exk_reading c;
        TEST_ASSERT_EQUAL(EXK_OK, source.exchange(source.ctx, k, &drive, &c));
        TEST_ASSERT_TRUE(c.has_true && c.fresh);
        for (int axis = 0; axis < EXK_N_AXES; axis++) {
            TEST_ASSERT_TRUE(a.measured_rad[axis] == b.measured_rad[axis]);
            TEST_ASSERT_TRUE(a.true_rad[axis] == b.true_rad[axis]);
            TEST_ASSERT_TRUE(a.measured_rad[axis] == c.measured_rad[axis]);
            TEST_ASSERT_TRUE(a.true_rad[axis] == c.true_rad[axis]);
        }
    }
}

static void a_loan_begins_at_tick_0(void)
{
    double n_rad[EXK_N_AXES][3] = {{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}};
    double *const lend[EXK_N_AXES] = {n_rad[0], n_rad[1]};
    exk_twin_config cfg = exk_twin_default();
    cfg.n_disturbances = 1;
    cfg.disturbance[0] = exk_disturbance_default();
    exk_twin twin = start(&cfg);
    exk_twin_lend(&twin, 3, lend);
    TEST_ASSERT_TRUE(step(&twin, -1, 0.0, 0.0).true_rad[0] == 0.0);
    TEST_ASSERT_TRUE(step(&twin, 2, 0.0, 0.0).true_rad[0] == 1.0);
    TEST_ASSERT_TRUE(step(&twin, 3, 0.0, 0.0).true_rad[0] == 0.0);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(init_accepts_and_refuses_by_the_table);
    RUN_TEST(the_default_passes_the_command_on_exactly);
    RUN_TEST(a_step_rises_with_the_time_constant);
    RUN_TEST(skipped_ticks_hold_the_last_command);
    RUN_TEST(a_tick_that_does_not_rise_moves_nothing);
    RUN_TEST(a_bad_command_leaves_the_servo_where_it_is);
    RUN_TEST(before_the_first_good_command_the_servo_is_at_zero);
    RUN_TEST(disturbances_add_up_as_sources_of_their_own);
    RUN_TEST(the_sensor_adds_its_draw_to_the_measured_angle_only);
    RUN_TEST(sensor_noise_is_fresh_unless_frozen);
    RUN_TEST(the_encoder_rounds_to_its_quantum);
    RUN_TEST(reset_and_the_source_give_the_same_readings);
    RUN_TEST(a_loan_begins_at_tick_0);
    return UNITY_END();
}
