/* The loop under commands and faults: who stops it, what it says, how it goes on. */
#include "exk/loop.h"

#include <math.h>
#include <string.h>

#include "exk/loop_report.h"
#include "unity.h"

enum { N_HOLES = 2, SEGMENTS = 5 * N_HOLES, N_CAPTURE = 8 };

static const exk_hole holes[N_HOLES] = {{7, {-0.02, -0.01, 0.95}, {0.0, 0.0, 1.0}},
                                        {9, {0.02, -0.01, 0.95}, {0.0, 0.0, 1.0}}};
static exk_segment segments[SEGMENTS];
static exk_sample kept[N_CAPTURE];
static exk_plan plan;
static exk_kin kin;
static exk_capture capture;
static exk_loop loop;
static exk_loop_config cfg;
static exk_sample sample;

/* A machine that follows exactly, or answers what it is told to. */
static struct {
    bool bad;
    double off_rad;
    double true_rad;
    exk_err err;
    int n_calls;
} fake;

static exk_err exchange(void *ctx, int64_t k, const exk_drive *drive, exk_reading *out)
{
    (void)ctx;
    (void)k;
    fake.n_calls++;
    *out = (exk_reading){.fresh = true, .has_true = true};
    for (int i = 0; i < EXK_N_AXES; i++) {
        out->measured_rad[i] = fake.bad ? (double)NAN : drive->angle_rad[i] + fake.off_rad;
        out->true_rad[i] = drive->angle_rad[i] + fake.true_rad;
    }
    return fake.err;
}

void setUp(void)
{
    const exk_geometry geo = exk_geometry_default();
    exk_plan_config plan_cfg = exk_plan_default();
    plan_cfg.clearance_m = 0.005;
    plan_cfg.stroke_m = 0.003;
    plan_cfg.dwell_s = 0.02;
    memset(&fake, 0, sizeof fake);
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, EXK_KIN_PENDULUM, EXK_WRIST_AB, &geo));
    TEST_ASSERT_EQUAL(EXK_OK,
                      exk_plan_init(&plan, &plan_cfg, holes, N_HOLES, segments, SEGMENTS));
    TEST_ASSERT_EQUAL(EXK_OK, exk_capture_init(&capture, kept, N_CAPTURE));
    cfg = (exk_loop_config){.kin = &kin,
                            .plan = &plan,
                            .source = {.exchange = exchange},
                            .feedback = exk_feedback_default(),
                            .angle_max_rad = 0.61,
                            .n_bad_max = 3,
                            .limits = exk_limits_default(),
                            .capture = &capture};
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_init(&loop, &cfg));
}

void tearDown(void)
{
}

static void restart(void)
{
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_init(&loop, &cfg));
}

static exk_err step(void)
{
    return exk_loop_step(&loop, loop.motion.k + 1, &sample);
}

static void step_to(int64_t k)
{
    while (loop.motion.k < k) {
        TEST_ASSERT_EQUAL(EXK_OK, step());
    }
}

static int64_t middle_of(exk_phase phase)
{
    for (size_t i = 0; i < plan.n_segments; i++) {
        if (segments[i].phase == phase) {
            return segments[i].k_begin + segments[i].n_ticks / 2;
        }
    }
    TEST_FAIL_MESSAGE("no such phase");
    return 0;
}

static void steps_until_over(void)
{
    for (int i = 0; i < 20000 && !exk_loop_is_over(&loop); i++) {
        step();
    }
    TEST_ASSERT_TRUE(exk_loop_is_over(&loop));
}

static void it_waits_for_start_when_told_to(void)
{
    cfg.waits = true;
    restart();
    for (int i = 0; i < 5; i++) {
        TEST_ASSERT_EQUAL(EXK_OK, step());
        TEST_ASSERT_EQUAL(EXK_STATE_IDLE, loop.sm.state);
        TEST_ASSERT_FALSE(exk_loop_moves(&loop));
    }
    TEST_ASSERT_EQUAL_INT(0, fake.n_calls);
    TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_START, 5));
    TEST_ASSERT_EQUAL(EXK_OK, step());
    TEST_ASSERT_EQUAL_INT64(0, loop.motion.j); /* nothing of the plan was missed */
    TEST_ASSERT_EQUAL_INT64(plan.n_ticks - 1 + 5, exk_loop_last_tick(&loop));
}

static void stop_holds_and_start_goes_on_to_the_end(void)
{
    static const exk_cause causes[] = {EXK_CAUSE_STOP, EXK_CAUSE_TIMEOUT};
    for (size_t i = 0; i < 2; i++) {
        setUp();
        step_to(middle_of(EXK_PHASE_TRAVEL));
        TEST_ASSERT_TRUE(exk_loop_request(&loop, causes[i], loop.motion.k + 1));
        step_to(loop.motion.k + 500);
        TEST_ASSERT_EQUAL(EXK_STATE_HOLD, loop.sm.state);
        TEST_ASSERT_EQUAL(causes[i], loop.sm.cause);
        TEST_ASSERT_FALSE(exk_loop_is_over(&loop));
        TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_START, loop.motion.k + 1));
        steps_until_over();
        TEST_ASSERT_EQUAL(EXK_STATE_DONE, loop.sm.state);
        TEST_ASSERT_EQUAL_INT64(exk_loop_last_tick(&loop), loop.motion.k);
        TEST_ASSERT_EQUAL_INT64(plan.n_ticks - 1, loop.motion.j);
    }
}

/* Between two ticks of the plan the stored correction is taken between its samples. */
static void the_stored_correction_slows_down_too(void)
{
    enum { N = 4000 };
    static double u_rad[EXK_N_AXES][N];
    for (int k = 0; k < N; k++) {
        u_rad[0][k] = 1e-6 * k;
        u_rad[1][k] = -1e-6 * k;
    }
    cfg.u_rad[0] = u_rad[0];
    cfg.u_rad[1] = u_rad[1];
    cfg.n_u = N;
    restart();
    step_to(middle_of(EXK_PHASE_TRAVEL));
    exk_loop_request(&loop, EXK_CAUSE_STOP, loop.motion.k + 1);
    bool between = false;
    for (int i = 0; i < 150; i++) {
        TEST_ASSERT_EQUAL(EXK_OK, step());
        between = between || loop.motion.part > 0.0;
        const double want = 1e-6 * ((double)loop.motion.j + loop.motion.part);
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, want, sample.u_rad[0]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, -want, sample.u_rad[1]);
    }
    TEST_ASSERT_TRUE(between);
}

/* Abort takes its state, says where it was, and stays at once; a second one changes nothing. */
static void abort_stays_at_once(void)
{
    step_to(100);
    const exk_sample last = sample;
    TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_ABORT, 101));
    TEST_ASSERT_EQUAL(EXK_STATE_FAULT, loop.sm.state);
    TEST_ASSERT_EQUAL(EXK_CAUSE_ABORT, loop.report.cause);
    TEST_ASSERT_EQUAL_INT64(101, loop.report.k);
    TEST_ASSERT_EQUAL_INT(7, loop.report.hole_id);
    TEST_ASSERT_TRUE(exk_loop_is_over(&loop));
    const int n_calls = fake.n_calls;
    TEST_ASSERT_EQUAL(EXK_ERR_ABORT, step());
    TEST_ASSERT_EQUAL_INT(n_calls, fake.n_calls);
    TEST_ASSERT_EQUAL_DOUBLE_ARRAY(last.q_rad, sample.q_rad, EXK_N_AXES);
    TEST_ASSERT_FALSE(exk_loop_request(&loop, EXK_CAUSE_ABORT, 103));
    TEST_ASSERT_EQUAL_INT64(101, loop.report.k);
    TEST_ASSERT_EQUAL_INT64(1, loop.sm.n_refused);
}

static void clear_leads_back_to_idle_and_the_run_goes_on(void)
{
    cfg.waits = true;
    restart();
    exk_loop_request(&loop, EXK_CAUSE_START, 0);
    step_to(middle_of(EXK_PHASE_APPROACH));
    exk_loop_request(&loop, EXK_CAUSE_ABORT, loop.motion.k + 1);
    step();
    TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_CLEAR, loop.motion.k + 1));
    TEST_ASSERT_EQUAL(EXK_STATE_IDLE, loop.sm.state);
    TEST_ASSERT_EQUAL(EXK_OK, loop.fault);
    TEST_ASSERT_EQUAL_INT64(-1, loop.report.k);
    TEST_ASSERT_TRUE(capture.frozen); /* until its owner has written it */
    TEST_ASSERT_EQUAL(EXK_OK, step());
    TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_START, loop.motion.k + 1));
    steps_until_over();
    TEST_ASSERT_EQUAL(EXK_STATE_DONE, loop.sm.state);
}

/* Without a ring to keep samples in, the same. */
static void clear_waits_for_the_end_of_the_way_out(void)
{
    cfg.capture = NULL;
    restart();
    step_to(middle_of(EXK_PHASE_DRILL));
    fake.bad = true;
    while (step() == EXK_OK) {
    }
    fake.bad = false;
    TEST_ASSERT_EQUAL(EXK_ERR_SENSOR, step());
    TEST_ASSERT_FALSE(exk_loop_request(&loop, EXK_CAUSE_CLEAR, loop.motion.k + 1));
    TEST_ASSERT_FALSE(exk_loop_is_over(&loop));
    steps_until_over();
    TEST_ASSERT_EQUAL(EXK_PHASE_RETRACT, sample.phase);
    TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_CLEAR, loop.motion.k + 1));
    TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_START, loop.motion.k + 1));
    steps_until_over();
    TEST_ASSERT_EQUAL(EXK_STATE_DONE, loop.sm.state);
}

/* A run that began by itself does not go on by itself. */
static void clear_alone_moves_nothing(void)
{
    step_to(middle_of(EXK_PHASE_TRAVEL));
    exk_loop_request(&loop, EXK_CAUSE_ABORT, loop.motion.k + 1);
    step();
    const int n_calls = fake.n_calls;
    TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_CLEAR, loop.motion.k + 1));
    for (int i = 0; i < 50; i++) {
        TEST_ASSERT_EQUAL(EXK_OK, step());
        TEST_ASSERT_EQUAL(EXK_STATE_IDLE, loop.sm.state);
    }
    TEST_ASSERT_EQUAL_INT(n_calls, fake.n_calls);
    TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_START, loop.motion.k + 1));
    steps_until_over();
    TEST_ASSERT_EQUAL(EXK_STATE_DONE, loop.sm.state);
}

/* The correction that broke a limit is not tried again after clear. */
static void after_clear_the_correction_of_the_last_command_goes_on(void)
{
    cfg.feedback.pid.kp = 0.5;
    cfg.feedback.pid.kd = 1e-4;
    cfg.limits.correction_max_rad = 1e-3;
    restart();
    fake.off_rad = 1e-4;
    step_to(100);
    fake.off_rad = 0.01;
    step();
    const double c_rad = sample.c_rad[0];
    TEST_ASSERT_EQUAL(EXK_ERR_LIMIT, step());
    TEST_ASSERT_EQUAL(EXK_QUANTITY_CORRECTION, loop.report.what.quantity);
    fake.off_rad = 0.0;
    TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_CLEAR, loop.motion.k + 1));
    TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_START, loop.motion.k + 1));
    TEST_ASSERT_EQUAL(EXK_OK, step());
    TEST_ASSERT_TRUE(c_rad != 0.0);
    TEST_ASSERT_EQUAL_DOUBLE(c_rad, sample.c_rad[0]);
    steps_until_over();
    TEST_ASSERT_EQUAL(EXK_STATE_DONE, loop.sm.state);
}

static void causes_that_nobody_may_ask_for_are_refused(void)
{
    static const exk_cause refused[] = {EXK_CAUSE_NONE,   EXK_CAUSE_READY,   EXK_CAUSE_END,
                                        EXK_CAUSE_SENSOR, EXK_CAUSE_LIMIT,   EXK_CAUSE_OVERRUN,
                                        EXK_CAUSE_SOURCE, EXK_CAUSE_COUNT,   (exk_cause)-1,
                                        EXK_CAUSE_CLEAR,  EXK_CAUSE_TIMEOUT, EXK_CAUSE_STOP};
    const int64_t n = (int64_t)(sizeof refused / sizeof refused[0]);
    for (int64_t i = 0; i < n; i++) {
        TEST_ASSERT_FALSE(exk_loop_request(&loop, refused[i], 0));
        TEST_ASSERT_EQUAL_INT64(i + 1, loop.sm.n_refused);
    }
    TEST_ASSERT_EQUAL(EXK_STATE_IDLE, loop.sm.state);
    TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_QUIT, 0));
    TEST_ASSERT_EQUAL(EXK_STATE_DONE, loop.sm.state);
    TEST_ASSERT_TRUE(exk_loop_is_over(&loop));
}

static void faulted(exk_cause cause, exk_err err, exk_quantity quantity, int64_t k)
{
    TEST_ASSERT_EQUAL(EXK_STATE_FAULT, loop.sm.state);
    TEST_ASSERT_EQUAL_STRING(exk_cause_name(cause), exk_cause_name(loop.report.cause));
    TEST_ASSERT_EQUAL(err, loop.report.err);
    TEST_ASSERT_EQUAL_STRING(exk_quantity_name(quantity),
                             exk_quantity_name(loop.report.what.quantity));
    TEST_ASSERT_EQUAL_INT64(k, loop.report.k);
}

/* Each limit by a run that breaks it; the command that does is never sent. */
static void what_breaks_a_limit_is_not_sent(void)
{
    cfg.limits.box_max_m[2] = 0.94;
    restart();
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_init(&loop, &cfg));
    int64_t k = 0;
    while (step() == EXK_OK) {
        k++;
    }
    faulted(EXK_CAUSE_LIMIT, EXK_ERR_LIMIT, EXK_QUANTITY_WORKSPACE, k);
    TEST_ASSERT_EQUAL_INT(k, fake.n_calls);
    TEST_ASSERT_EQUAL(EXK_ERR_LIMIT, step());
    TEST_ASSERT_EQUAL_INT(k, fake.n_calls);
}

static void use_machine(const exk_geometry *geo)
{
    const exk_plan_config plan_cfg = plan.cfg;
    static exk_hole high[N_HOLES]; /* lent: the plan keeps it */
    high[0] = holes[0];
    high[1] = holes[1];
    high[0].target_m[2] = 1.45;
    high[1].target_m[2] = 1.45;
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, EXK_KIN_MACHINE, EXK_WRIST_AB, geo));
    TEST_ASSERT_EQUAL(EXK_OK,
                      exk_plan_init(&plan, &plan_cfg, high, N_HOLES, segments, SEGMENTS));
}

/* A command that no pose meets: the stored correction leads beyond the joint. */
static void a_command_beyond_the_joint_names_the_angle(void)
{
    static const double big[2] = {0.0, 1.0};
    static const double small[2] = {0.0, 0.0};
    const exk_geometry geo = exk_geometry_default();
    use_machine(&geo);
    for (int axis = 0; axis < EXK_N_AXES; axis++) {
        cfg.u_rad[axis] = big;
        cfg.u_rad[1 - axis] = small;
        cfg.n_u = 2;
        restart();
        TEST_ASSERT_EQUAL(EXK_OK, step());
        TEST_ASSERT_TRUE(step() != EXK_OK);
        faulted(EXK_CAUSE_LIMIT, loop.fault, EXK_QUANTITY_ANGLE, 1);
        TEST_ASSERT_EQUAL_INT(axis, loop.report.what.index);
        TEST_ASSERT_DOUBLE_WITHIN(0.05, 1.0, loop.report.what.value);
    }
}

/* A stroke that ends 0.1 mm before or after the legs of tick 0, and a correction beyond it. */
static void a_command_beyond_the_stroke_names_leg_length_and_limit(void)
{
    static const double lean[2] = {0.0, 0.25};
    static const double still[2] = {0.0, 0.0};
    cfg.u_rad[EXK_ALPHA] = lean;
    cfg.u_rad[EXK_BETA] = still;
    cfg.n_u = 2;
    for (int end = 0; end < 2; end++) {
        exk_geometry geo = exk_geometry_default();
        use_machine(&geo);
        restart();
        TEST_ASSERT_EQUAL(EXK_OK, step());
        const double *legs_m = sample.legs_m;
        const double least_m = fmin(legs_m[0], fmin(legs_m[1], legs_m[2]));
        const double most_m = fmax(legs_m[0], fmax(legs_m[1], legs_m[2]));
        geo.l_min_m = end == 0 ? least_m - 1e-4 : most_m + 1e-4 - geo.d5_m;
        use_machine(&geo);
        restart();
        TEST_ASSERT_EQUAL(EXK_OK, step());
        TEST_ASSERT_TRUE(step() != EXK_OK);
        faulted(EXK_CAUSE_LIMIT, EXK_ERR_LIMIT, EXK_QUANTITY_LEG, 1);
        const exk_violation *what = &loop.report.what;
        const double beyond_m =
            end == 0 ? what->limit - what->value : what->value - what->limit;
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, geo.l_min_m + (end == 0 ? 0.0 : geo.d5_m),
                                  what->limit);
        TEST_ASSERT_TRUE(beyond_m > 1e-3 && beyond_m < 0.1);
    }
}

/* A hole out of reach of the mechanism: no inverse. */
static void a_reference_out_of_reach_is_a_fault(void)
{
    exk_hole far[N_HOLES] = {holes[0], holes[1]};
    exk_plan_config plan_cfg = plan.cfg;
    far[1].target_m[0] = 50.0;
    TEST_ASSERT_EQUAL(EXK_OK,
                      exk_plan_init(&plan, &plan_cfg, far, N_HOLES, segments, SEGMENTS));
    restart();
    for (int i = 0; i < 20000 && step() == EXK_OK; i++) {
    }
    faulted(EXK_CAUSE_LIMIT, loop.fault, EXK_QUANTITY_POSE, loop.motion.k);
    TEST_ASSERT_TRUE(isfinite(sample.q_rad[0]));
}

/* Within angles and stroke, but r = h cos(alpha) + d2 sin(beta) < 0: no leg and no angle is to blame. */
static void a_command_off_the_branch_is_a_pose(void)
{
    static const double lean[2] = {0.0, -1.0};
    static const double still[2] = {0.0, 0.0};
    const exk_hole near[1] = {{7, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}};
    exk_geometry geo = exk_geometry_default();
    exk_plan_config plan_cfg = plan.cfg;
    geo.angle_max_rad = 1.04;
    geo.l_min_m = 0.3;
    cfg.angle_max_rad = 1.04;
    use_machine(&geo);
    TEST_ASSERT_EQUAL(EXK_OK, exk_plan_init(&plan, &plan_cfg, near, 1, segments, SEGMENTS));
    cfg.u_rad[EXK_ALPHA] = still;
    cfg.u_rad[EXK_BETA] = lean;
    cfg.n_u = 2;
    restart();
    TEST_ASSERT_EQUAL(EXK_OK, step());
    TEST_ASSERT_EQUAL(EXK_ERR_UNREACHABLE, step());
    faulted(EXK_CAUSE_LIMIT, EXK_ERR_UNREACHABLE, EXK_QUANTITY_POSE, 1);
}

static void a_following_error_is_a_fault(void)
{
    cfg.limits.following_rad = 1e-3;
    restart();
    step_to(50);
    fake.off_rad = 2e-3;
    TEST_ASSERT_EQUAL(EXK_ERR_LIMIT, step());
    faulted(EXK_CAUSE_LIMIT, EXK_ERR_LIMIT, EXK_QUANTITY_FOLLOWING, 51);
    TEST_ASSERT_TRUE(exk_loop_is_over(&loop));
}

/* Angles in the sensor's range of which no pose is known. */
static void a_measurement_without_a_pose_is_a_fault(void)
{
    cfg.angle_max_rad = 1.7;
    restart();
    step_to(50);
    fake.off_rad = 1.6;
    fake.true_rad = 1.6;
    TEST_ASSERT_TRUE(step() != EXK_OK);
    faulted(EXK_CAUSE_LIMIT, loop.fault, EXK_QUANTITY_POSE, 51);
    TEST_ASSERT_FALSE(sample.has_true && !isfinite(sample.real.tip_m[0]));
}

/* What the machine says is true, but is no pose, is not taken for the truth. */
static void a_truth_without_a_pose_is_no_truth(void)
{
    step_to(50);
    fake.true_rad = 1.6;
    TEST_ASSERT_EQUAL(EXK_OK, step());
    TEST_ASSERT_FALSE(sample.has_true);
    TEST_ASSERT_TRUE(sample.theta_rad[0] == 0.0);
}

static void a_source_that_fails_on_the_way_out_freezes_it(void)
{
    step_to(middle_of(EXK_PHASE_DRILL));
    fake.bad = true;
    while (loop.motion.mode != EXK_MOTION_RETRACT) {
        step();
    }
    faulted(EXK_CAUSE_SENSOR, EXK_ERR_SENSOR, EXK_QUANTITY_SAMPLES, loop.report.k);
    TEST_ASSERT_EQUAL(EXK_SAMPLE_NAN, loop.report.sample);
    TEST_ASSERT_EQUAL_DOUBLE(3.0, loop.report.what.value);
    fake.err = EXK_ERR_END;
    TEST_ASSERT_EQUAL(EXK_ERR_SENSOR, step()); /* the first reason stays */
    TEST_ASSERT_TRUE(exk_loop_is_over(&loop));
}

/* Missed deadlines on the way out: its timing is in doubt, so it ends where it is. */
static void a_fault_from_outside_freezes_the_way_out(void)
{
    const exk_fault_report report = {.cause = EXK_CAUSE_OVERRUN, .err = EXK_ERR_OVERRUN};
    step_to(middle_of(EXK_PHASE_DRILL));
    fake.bad = true;
    while (loop.motion.mode != EXK_MOTION_RETRACT) {
        step();
    }
    const int n_calls = fake.n_calls;
    exk_loop_fail(&loop, &report);
    TEST_ASSERT_EQUAL(EXK_CAUSE_SENSOR, loop.report.cause);
    TEST_ASSERT_EQUAL(EXK_ERR_SENSOR, step());
    TEST_ASSERT_TRUE(exk_loop_is_over(&loop));
    TEST_ASSERT_EQUAL_INT(n_calls, fake.n_calls);
}

/* A good sample on the way out is shown and corrects nothing. */
static void under_a_fault_nothing_is_corrected(void)
{
    cfg.feedback.kind = EXK_FEEDBACK_PID;
    cfg.feedback.pid.kp = 0.5;
    cfg.feedback.pid.dt_s = plan.cfg.dt_s;
    restart();
    step_to(middle_of(EXK_PHASE_DRILL));
    fake.bad = true;
    while (step() == EXK_OK) {
    }
    fake.bad = false;
    fake.off_rad = 1e-3;
    const double c_rad = loop.c_rad[0];
    step();
    TEST_ASSERT_TRUE(sample.sensor_ok);
    TEST_ASSERT_EQUAL_DOUBLE(c_rad, loop.c_rad[0]);
    TEST_ASSERT_EQUAL_INT(3, loop.n_bad_row);
}

static void ticks_must_rise(void)
{
    exk_drive drive;
    step_to(10);
    const exk_sample before = sample;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_loop_step(&loop, 10, &sample));
    TEST_ASSERT_EQUAL_MEMORY(&before, &sample, sizeof sample);
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_loop_command(&loop, 9, &drive));
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_step(&loop, 11, &sample));
}

/* A measure answers one command, once. */
static void a_measure_without_a_command_is_refused(void)
{
    exk_drive drive;
    exk_reading r;
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_command(&loop, 0, &drive));
    TEST_ASSERT_TRUE(exk_loop_moves(&loop));
    exchange(NULL, 0, &drive, &r);
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_measure(&loop, &r, &sample));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_loop_measure(&loop, &r, &sample));
    TEST_ASSERT_EQUAL_INT64(0, sample.k);
}

/* What was kept ends with the sample at which the fault was found. */
static void the_ring_is_frozen_by_a_fault(void)
{
    step_to(30);
    fake.bad = true;
    while (step() == EXK_OK) {
    }
    const int64_t k = loop.report.k;
    for (int i = 0; i < 5; i++) {
        step();
    }
    TEST_ASSERT_EQUAL_UINT(N_CAPTURE, exk_capture_count(&capture));
    TEST_ASSERT_EQUAL_INT64(k, exk_capture_at(&capture, N_CAPTURE - 1)->k);
    TEST_ASSERT_EQUAL_INT64(k - N_CAPTURE + 1, exk_capture_at(&capture, 0)->k);
}

static void a_fault_from_outside_is_refused_when_done(void)
{
    const exk_fault_report report = {.cause = EXK_CAUSE_OVERRUN, .err = EXK_ERR_OVERRUN};
    steps_until_over();
    TEST_ASSERT_EQUAL(EXK_STATE_DONE, loop.sm.state);
    exk_loop_fail(&loop, &report);
    TEST_ASSERT_EQUAL(EXK_STATE_DONE, loop.sm.state);
    TEST_ASSERT_EQUAL(EXK_OK, loop.fault);
}

static void configurations_of_guard_and_limits_are_refused(void)
{
    cfg.guard = exk_guard_default();
    cfg.guard.stuck_s = (double)NAN;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_loop_init(&loop, &cfg));
    cfg.guard.stuck_s = 0.0;
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_init(&loop, &cfg));
    cfg.limits.following_rad = -1.0;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_loop_init(&loop, &cfg));
    cfg.limits = (exk_limits_config){.dt_s = 0.0}; /* unlimited */
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_init(&loop, &cfg));
    TEST_ASSERT_TRUE(isinf(loop.limits.cfg.leg_max_m));
    cfg.wait_s = (double)NAN;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_loop_init(&loop, &cfg));
}

/* The tip of what is measured is worked out where either angle differs from the truth. */
static void one_angle_off_is_off(void)
{
    exk_drive drive;
    for (int axis = 0; axis < EXK_N_AXES; axis++) {
        exk_reading r = {.fresh = true, .has_true = true};
        restart();
        TEST_ASSERT_EQUAL(EXK_OK, exk_loop_command(&loop, 0, &drive));
        for (int i = 0; i < EXK_N_AXES; i++) {
            r.true_rad[i] = drive.angle_rad[i];
            r.measured_rad[i] = drive.angle_rad[i] + (i == axis ? 1e-3 : 0.0);
        }
        TEST_ASSERT_EQUAL(EXK_OK, exk_loop_measure(&loop, &r, &sample));
        TEST_ASSERT_TRUE(sample.est.tip_m[axis] != sample.real.tip_m[axis]);
        TEST_ASSERT_TRUE(sample.est.tip_m[1 - axis] == sample.real.tip_m[1 - axis]);
    }
}

static void reports_tell_what_the_loop_holds(void)
{
    exk_loop_report report;
    exk_transition note[EXK_STATE_NOTES];
    step_to(30);
    fake.bad = true;
    while (step() == EXK_OK) {
    }
    exk_loop_tell(&loop, &report);
    TEST_ASSERT_EQUAL(EXK_CAUSE_SENSOR, report.cause);
    TEST_ASSERT_EQUAL_INT64(loop.report.k, report.k_cause);
    TEST_ASSERT_EQUAL_INT64(3, report.n_rejected[EXK_SAMPLE_NAN]);
    TEST_ASSERT_EQUAL_INT64(31, report.n_rejected[EXK_SAMPLE_GOOD]);
    TEST_ASSERT_EQUAL_INT64(3, report.n_transitions); /* ready, start, sensor */
    TEST_ASSERT_EQUAL(EXK_ERR_SENSOR, report.fault.err);
    TEST_ASSERT_EQUAL_INT(3, exk_loop_take_notes(&loop, note));
    TEST_ASSERT_EQUAL(EXK_STATE_FAULT, note[2].to);
    TEST_ASSERT_EQUAL_INT(0, exk_loop_take_notes(&loop, note));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(it_waits_for_start_when_told_to);
    RUN_TEST(stop_holds_and_start_goes_on_to_the_end);
    RUN_TEST(the_stored_correction_slows_down_too);
    RUN_TEST(abort_stays_at_once);
    RUN_TEST(clear_leads_back_to_idle_and_the_run_goes_on);
    RUN_TEST(clear_waits_for_the_end_of_the_way_out);
    RUN_TEST(clear_alone_moves_nothing);
    RUN_TEST(after_clear_the_correction_of_the_last_command_goes_on);
    RUN_TEST(causes_that_nobody_may_ask_for_are_refused);
    RUN_TEST(what_breaks_a_limit_is_not_sent);
    RUN_TEST(a_command_beyond_the_joint_names_the_angle);
    RUN_TEST(a_command_beyond_the_stroke_names_leg_length_and_limit);
    RUN_TEST(a_reference_out_of_reach_is_a_fault);
    RUN_TEST(a_command_off_the_branch_is_a_pose);
    RUN_TEST(a_following_error_is_a_fault);
    RUN_TEST(a_measurement_without_a_pose_is_a_fault);
    RUN_TEST(a_truth_without_a_pose_is_no_truth);
    RUN_TEST(a_source_that_fails_on_the_way_out_freezes_it);
    RUN_TEST(a_fault_from_outside_freezes_the_way_out);
    RUN_TEST(under_a_fault_nothing_is_corrected);
    RUN_TEST(ticks_must_rise);
    RUN_TEST(a_measure_without_a_command_is_refused);
    RUN_TEST(the_ring_is_frozen_by_a_fault);
    RUN_TEST(a_fault_from_outside_is_refused_when_done);
    RUN_TEST(configurations_of_guard_and_limits_are_refused);
    RUN_TEST(one_angle_off_is_off);
    RUN_TEST(reports_tell_what_the_loop_holds);
    return UNITY_END();
}
