/* One step of the loop against its equations, and the guard on what the source answers. */
#include "exk/loop.h"

#include <math.h>
#include <string.h>

#include "unity.h"

enum { N_U = 4 };
static const exk_hole holes[] = {{7, {-0.15, -0.10, 0.95}, {0.0, 0.0, 1.0}},
                                 {9, {0.15, -0.10, 0.95}, {0.0, 0.0, 1.0}}};
static exk_segment segments[32];
static exk_plan plan;
static exk_kin kin;
static exk_loop loop;
static exk_loop_config cfg;
static exk_sample sample;

/* A source that adds a fixed disturbance and can be told to answer something bad. */
static struct {
    double n_rad[EXK_N_AXES];
    double answer; /* put in place of alpha while bad */
    bool bad;
    bool stale;
    exk_err err;
    exk_drive drive;
    int n_calls;
} fake;

static exk_err exchange(void *ctx, int64_t k, const exk_drive *drive, exk_reading *out)
{
    (void)ctx;
    (void)k;
    fake.drive = *drive;
    fake.n_calls++;
    *out = (exk_reading){.fresh = !fake.stale, .has_true = true};
    for (int i = 0; i < EXK_N_AXES; i++) {
        out->true_rad[i] = drive->angle_rad[i] + fake.n_rad[i];
        out->measured_rad[i] = out->true_rad[i];
    }
    if (fake.bad) {
        out->measured_rad[EXK_ALPHA] = fake.answer;
    }
    return fake.err;
}

void setUp(void)
{
    const exk_geometry geo = exk_geometry_default();
    exk_plan_config plan_cfg = exk_plan_default();
    plan_cfg.dt_s = 0.001;
    memset(&fake, 0, sizeof fake);
    fake.n_rad[EXK_ALPHA] = 2e-4;
    fake.n_rad[EXK_BETA] = -1e-4;
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, EXK_KIN_PENDULUM, EXK_WRIST_AB, &geo));
    TEST_ASSERT_EQUAL(EXK_OK, exk_plan_init(&plan, &plan_cfg, holes, 2, segments, 32));
    cfg = (exk_loop_config){.kin = &kin,
                            .plan = &plan,
                            .source = {.exchange = exchange},
                            .feedback = exk_feedback_default(),
                            .angle_max_rad = 0.61,
                            .n_bad_max = 5};
    cfg.feedback.kind = EXK_FEEDBACK_PID;
    cfg.feedback.pid.kp = 0.2;
    cfg.feedback.pid.ki = 50.0;
    cfg.feedback.pid.dt_s = 0.001;
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_init(&loop, &cfg));
}

void tearDown(void)
{
}

static void one_step_follows_the_equations(void)
{
    static const double u_alpha[N_U] = {1e-5, 2e-5, 3e-5, 4e-5};
    static const double u_beta[N_U] = {-1e-5, -2e-5, -3e-5, -4e-5};
    cfg.u_rad[EXK_ALPHA] = u_alpha;
    cfg.u_rad[EXK_BETA] = u_beta;
    cfg.n_u = N_U;
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_init(&loop, &cfg));
    double c_rad[EXK_N_AXES] = {0.0, 0.0};
    double integral_rad[EXK_N_AXES] = {0.0, 0.0};
    for (int64_t k = 0; k < 6; k++) {
        TEST_ASSERT_EQUAL(EXK_OK, exk_loop_step(&loop, k, &sample));
        const double u_rad[] = {u_alpha[k < N_U ? k : N_U - 1], u_beta[k < N_U ? k : N_U - 1]};
        for (int i = 0; i < EXK_N_AXES; i++) {
            TEST_ASSERT_EQUAL_DOUBLE(c_rad[i], sample.c_rad[i]);
            TEST_ASSERT_EQUAL_DOUBLE(u_rad[i], sample.u_rad[i]);
            TEST_ASSERT_EQUAL_DOUBLE(sample.r_rad[i] + c_rad[i] + u_rad[i], sample.q_rad[i]);
            TEST_ASSERT_EQUAL_DOUBLE(sample.q_rad[i], fake.drive.angle_rad[i]);
            TEST_ASSERT_EQUAL_DOUBLE(sample.q_rad[i] + fake.n_rad[i], sample.m_rad[i]);
            const double e_rad = sample.r_rad[i] - sample.m_rad[i];
            integral_rad[i] += 50.0 * 0.001 * e_rad;
            c_rad[i] = 0.2 * e_rad + integral_rad[i];
        }
        TEST_ASSERT_TRUE(sample.sensor_ok);
        TEST_ASSERT_EQUAL_INT64(1000 * k, sample.time_us);
    }
}

/* P: x = L2 sin alpha, so the tip is off by the arm times the angle error. */
static void the_tips_are_forward_of_what_was_measured_and_what_is_true(void)
{
    exk_tool tool;
    fake.bad = true;
    fake.answer = 0.01;
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_step(&loop, 0, &sample));
    const exk_joints m = {.angle_rad = {0.01, sample.m_rad[EXK_BETA]}, .h_m = sample.h_m};
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_forward(&kin, &m, &tool));
    TEST_ASSERT_EQUAL_DOUBLE_ARRAY(tool.tip_m, sample.est.tip_m, 3);
    const exk_joints theta = {.angle_rad = {sample.theta_rad[0], sample.theta_rad[1]},
                              .h_m = sample.h_m};
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_forward(&kin, &theta, &tool));
    TEST_ASSERT_TRUE(sample.has_true);
    TEST_ASSERT_EQUAL_DOUBLE_ARRAY(tool.tip_m, sample.real.tip_m, 3);
}

static const struct {
    const char *name;
    double value;
    bool stale;
} bad_rows[] = {
    {"NaN", (double)NAN, false},
    {"infinite", (double)INFINITY, false},
    {"minus infinite", -(double)INFINITY, false},
    {"beyond the range", 0.62, false},
    {"not fresh", 0.0, true},
};

static void a_bad_sample_is_counted_and_the_correction_held(void)
{
    for (size_t row = 0; row < sizeof bad_rows / sizeof bad_rows[0]; row++) {
        const char *name = bad_rows[row].name;
        setUp();
        for (int64_t k = 0; k < 3; k++) {
            exk_loop_step(&loop, k, &sample);
        }
        const exk_sample before = sample;
        const double c_rad = loop.c_rad[EXK_ALPHA];
        fake.bad = !bad_rows[row].stale;
        fake.stale = bad_rows[row].stale;
        fake.answer = bad_rows[row].value;
        for (int64_t k = 3; k < 7; k++) {
            TEST_ASSERT_EQUAL_MESSAGE(EXK_OK, exk_loop_step(&loop, k, &sample), name);
            TEST_ASSERT_FALSE_MESSAGE(sample.sensor_ok, name);
            TEST_ASSERT_TRUE_MESSAGE(sample.c_rad[EXK_ALPHA] == c_rad, name);
            TEST_ASSERT_TRUE_MESSAGE(sample.m_rad[EXK_ALPHA] == before.m_rad[EXK_ALPHA], name);
            TEST_ASSERT_TRUE_MESSAGE(isfinite(sample.est.tip_m[0]), name);
        }
        TEST_ASSERT_EQUAL_INT64_MESSAGE(4, loop.n_bad, name);
        fake.bad = false;
        fake.stale = false;
        TEST_ASSERT_EQUAL_MESSAGE(EXK_OK, exk_loop_step(&loop, 7, &sample), name);
        TEST_ASSERT_TRUE_MESSAGE(sample.sensor_ok, name);
        TEST_ASSERT_EQUAL_MESSAGE(0, loop.n_bad_row, name);
    }
}

static void too_many_bad_samples_are_a_fault_that_holds(void)
{
    exk_loop_step(&loop, 0, &sample);
    const exk_sample good = sample;
    fake.bad = true;
    fake.answer = (double)NAN;
    for (int64_t k = 1; k < 5; k++) {
        TEST_ASSERT_EQUAL(EXK_OK, exk_loop_step(&loop, k, &sample));
    }
    const exk_sample held = sample;
    TEST_ASSERT_EQUAL(EXK_ERR_SENSOR, exk_loop_step(&loop, 5, &sample));
    TEST_ASSERT_EQUAL(EXK_STATE_FAULT, loop.sm.state);
    TEST_ASSERT_EQUAL(EXK_ERR_SENSOR, loop.fault);
    const int n_calls = fake.n_calls;
    fake.bad = false;
    TEST_ASSERT_EQUAL(EXK_ERR_SENSOR, exk_loop_step(&loop, 6, &sample));
    TEST_ASSERT_EQUAL(n_calls, fake.n_calls);
    TEST_ASSERT_EQUAL_INT64(6, sample.k);
    TEST_ASSERT_EQUAL_DOUBLE_ARRAY(held.q_rad, sample.q_rad, EXK_N_AXES);
    TEST_ASSERT_EQUAL_DOUBLE_ARRAY(good.m_rad, sample.m_rad, EXK_N_AXES);
    exk_loop_reset(&loop);
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_step(&loop, 6, &sample));
}

static void a_first_sample_that_is_bad_stands_for_the_reference(void)
{
    fake.bad = true;
    fake.answer = (double)NAN;
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_step(&loop, 0, &sample));
    TEST_ASSERT_EQUAL_DOUBLE_ARRAY(sample.r_rad, sample.m_rad, EXK_N_AXES);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, loop.c_rad[EXK_ALPHA]);
}

static void the_end_of_a_source_is_a_fault(void)
{
    fake.err = EXK_ERR_END;
    TEST_ASSERT_EQUAL(EXK_ERR_END, exk_loop_step(&loop, 0, &sample));
    TEST_ASSERT_EQUAL(EXK_STATE_FAULT, loop.sm.state);
    TEST_ASSERT_TRUE(isfinite(sample.q_rad[0]));
}

static void a_fault_from_outside_keeps_the_first_reason(void)
{
    exk_loop_step(&loop, 0, &sample);
    const exk_fault_report first = {.cause = EXK_CAUSE_OVERRUN, .err = EXK_ERR_OVERRUN};
    const exk_fault_report second = {.cause = EXK_CAUSE_SENSOR, .err = EXK_ERR_SENSOR};
    exk_loop_fail(&loop, &first);
    exk_loop_fail(&loop, &second);
    TEST_ASSERT_EQUAL(EXK_ERR_OVERRUN, exk_loop_step(&loop, 1, &sample));
    TEST_ASSERT_FALSE(sample.judged);
}

static void the_last_tick_ends_the_run(void)
{
    TEST_ASSERT_EQUAL(EXK_STATE_IDLE, loop.sm.state);
    exk_loop_step(&loop, 0, &sample);
    TEST_ASSERT_EQUAL(EXK_STATE_RUN, loop.sm.state);
    TEST_ASSERT_EQUAL(7, sample.hole_id);
    exk_loop_step(&loop, plan.n_ticks - 1, &sample);
    TEST_ASSERT_EQUAL(EXK_STATE_DONE, loop.sm.state);
}

static void configurations_that_cannot_run_are_refused(void)
{
    static const double one = 0.0;
    static const struct {
        const char *name;
        int what;
        exk_err want;
    } rows[] = {
        {"no kinematics", 0, EXK_ERR_ARG},
        {"no plan", 1, EXK_ERR_ARG},
        {"no source", 2, EXK_ERR_ARG},
        {"angle limit NaN", 3, EXK_ERR_ARG},
        {"no bad sample allowed", 4, EXK_ERR_ARG},
        {"one stored axis", 5, EXK_ERR_SIZE},
        {"stored, no length", 6, EXK_ERR_SIZE},
        {"gain refused", 7, EXK_ERR_ARG},
        {"angle limit infinite", 8, EXK_ERR_ARG},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        exk_loop_config c = cfg;
        c.kin = rows[i].what == 0 ? NULL : c.kin;
        c.plan = rows[i].what == 1 ? NULL : c.plan;
        c.source.exchange = rows[i].what == 2 ? NULL : c.source.exchange;
        c.angle_max_rad = rows[i].what == 3 ? (double)NAN : c.angle_max_rad;
        c.angle_max_rad = rows[i].what == 8 ? (double)INFINITY : c.angle_max_rad;
        c.n_bad_max = rows[i].what == 4 ? 0 : c.n_bad_max;
        c.u_rad[EXK_ALPHA] = rows[i].what >= 5 && rows[i].what <= 6 ? &one : NULL;
        c.u_rad[EXK_BETA] = rows[i].what == 6 ? &one : NULL;
        c.feedback.pid.kp = rows[i].what == 7 ? 1.0 : c.feedback.pid.kp;
        TEST_ASSERT_EQUAL_MESSAGE(rows[i].want, exk_loop_init(&loop, &c), rows[i].name);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(one_step_follows_the_equations);
    RUN_TEST(the_tips_are_forward_of_what_was_measured_and_what_is_true);
    RUN_TEST(a_bad_sample_is_counted_and_the_correction_held);
    RUN_TEST(too_many_bad_samples_are_a_fault_that_holds);
    RUN_TEST(a_first_sample_that_is_bad_stands_for_the_reference);
    RUN_TEST(the_end_of_a_source_is_a_fault);
    RUN_TEST(a_fault_from_outside_keeps_the_first_reason);
    RUN_TEST(the_last_tick_ends_the_run);
    RUN_TEST(configurations_that_cannot_run_are_refused);
    return UNITY_END();
}
