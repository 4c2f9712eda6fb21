/* Brief steps against whole ones: the same bits while all is in order, refused as soon as it is not. */
#include "exk/brief.h"

#include <string.h>

#include "exk/twin.h"
#include "unity.h"

enum { TICKS_MAX = 8192, SEGMENTS = 32 };

static const exk_hole upright[] = {{7, {-0.10, -0.05, 0.95}, {0.0, 0.0, 1.0}},
                                   {9, {0.10, -0.05, 0.95}, {0.0, 0.0, 1.0}}};
static const exk_hole tilted[] = {{7, {-0.05, -0.03, 1.45}, {0.0, 0.0, 1.0}},
                                  {9, {0.05, -0.03, 1.45}, {0.0, 0.05, 0.99874921777}}};

static exk_segment segments[SEGMENTS];
static exk_waypoint way[TICKS_MAX];
static double u_rad[EXK_N_AXES][TICKS_MAX];
static double n_rad[EXK_N_AXES][TICKS_MAX];
static exk_plan plan;
static exk_kin kin;
static exk_twin twin;
static exk_loop loop;
static exk_loop_config cfg;
static exk_twin_config twin_cfg;

static const exk_realisation which = {.seed = 3, .series = 2, .run = 4};

/* One row of the table of loops that are compared. */
typedef struct {
    const char *name;
    exk_kin_model model;
    exk_feedback_kind feedback;
    bool stored, leg_limit, sensor_noise, servo, two_noises, lent;
} row;

static const row rows[] = {
    {"no control", EXK_KIN_PENDULUM, EXK_FEEDBACK_NONE, false, false, false, false, false,
     false},
    {"stored correction", EXK_KIN_PENDULUM, EXK_FEEDBACK_NONE, true, false, false, false, false,
     true},
    {"PI", EXK_KIN_PENDULUM, EXK_FEEDBACK_PID, false, false, false, false, false, true},
    {"both, a leg limit", EXK_KIN_PENDULUM, EXK_FEEDBACK_PID, true, true, false, false, false,
     false},
    {"sensor noise and a servo", EXK_KIN_PENDULUM, EXK_FEEDBACK_PID, true, false, true, true,
     false, true},
    {"two disturbances", EXK_KIN_UNIVERSAL, EXK_FEEDBACK_PID, true, false, false, false, true,
     false},
    {"whole machine", EXK_KIN_MACHINE, EXK_FEEDBACK_PID, true, true, true, true, false, true},
};

void setUp(void)
{
}

void tearDown(void)
{
}

static void set_noise(const row *r)
{
    twin_cfg = exk_twin_default();
    twin_cfg.dt_s = 0.01;
    twin_cfg.servo_tau_s = r->servo ? 0.02 : 0.0;
    twin_cfg.sensor_sigma_rad = r->sensor_noise ? 1e-6 : 0.0;
    twin_cfg.n_disturbances = r->two_noises ? 2 : 1;
    for (int i = 0; i < 2; i++) {
        twin_cfg.disturbance[i] = exk_disturbance_default();
        twin_cfg.disturbance[i].wave = EXK_WAVE_GAUSSIAN;
        twin_cfg.disturbance[i].order = 1 - i;
        twin_cfg.disturbance[i].amplitude = 1e-4;
    }
}

static void set_up(const row *r)
{
    const exk_geometry geo = exk_geometry_default();
    const bool machine = r->model == EXK_KIN_MACHINE;
    exk_plan_config plan_cfg = exk_plan_default();
    plan_cfg.dt_s = 0.01;
    set_noise(r);
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, r->model, EXK_WRIST_AB, &geo));
    TEST_ASSERT_EQUAL(EXK_OK, exk_plan_init(&plan, &plan_cfg, machine ? tilted : upright, 2,
                                            segments, SEGMENTS));
    TEST_ASSERT_TRUE(plan.n_ticks <= TICKS_MAX);
    TEST_ASSERT_EQUAL(EXK_OK, exk_waypoints(&plan, &kin, way));
    cfg = (exk_loop_config){.kin = &kin,
                            .plan = &plan,
                            .source = exk_twin_source(&twin),
                            .feedback = exk_feedback_default(),
                            .angle_max_rad = 0.61,
                            .n_bad_max = 5,
                            .limits = exk_limits_default()};
    cfg.feedback.kind = r->feedback;
    cfg.feedback.pid.dt_s = 0.01;
    cfg.limits.leg_speed_max_mps = r->leg_limit ? 5.0 : cfg.limits.leg_speed_max_mps;
    for (int i = 0; i < EXK_N_AXES && r->stored; i++) {
        cfg.u_rad[i] = u_rad[i];
        cfg.n_u = TICKS_MAX;
        for (int k = 0; k < TICKS_MAX; k++) {
            u_rad[i][k] = 1e-6 * (k % 97) * (i == 0 ? 1.0 : -1.0);
        }
    }
}

static void start(bool lent)
{
    double *const lend[EXK_N_AXES] = {n_rad[0], n_rad[1]};
    TEST_ASSERT_EQUAL(EXK_OK, exk_twin_init(&twin, &twin_cfg, which));
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_init(&loop, &cfg));
    if (lent) {
        TEST_ASSERT_TRUE(exk_twin_draw(&twin, TICKS_MAX, lend));
        exk_twin_lend(&twin, TICKS_MAX, lend);
    }
}

static bool same(const void *a, const void *b, size_t n)
{
    return memcmp(a, b, n) == 0;
}

static void compare_run(const row *r)
{
    static exk_sample samples[TICKS_MAX];
    start(false);
    for (int64_t k = 0; k < plan.n_ticks; k++) {
        TEST_ASSERT_EQUAL_MESSAGE(EXK_OK, exk_loop_step(&loop, k, &samples[k]), r->name);
    }
    start(r->lent);
    for (int64_t k = 0; k < plan.n_ticks; k++) {
        const exk_sample *s = &samples[k];
        exk_brief brief;
        TEST_ASSERT_EQUAL_MESSAGE(EXK_OK, exk_loop_brief(&loop, k, &way[k], &brief), r->name);
        const double e_rad[] = {s->r_rad[0] - s->m_rad[0], s->r_rad[1] - s->m_rad[1]};
        TEST_ASSERT_TRUE_MESSAGE(same(&s->real, &brief.tool, sizeof brief.tool), r->name);
        TEST_ASSERT_TRUE_MESSAGE(same(e_rad, brief.e_rad, sizeof e_rad), r->name);
        TEST_ASSERT_TRUE_MESSAGE(same(s->c_rad, brief.c_rad, sizeof brief.c_rad), r->name);
        TEST_ASSERT_TRUE_MESSAGE(same(&s->ref, &way[k].ref.tool, sizeof s->ref), r->name);
    }
    TEST_ASSERT_EQUAL_MESSAGE(EXK_STATE_DONE, loop.sm.state, r->name);
}

static void brief_steps_give_the_bits_of_whole_ones(void)
{
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        set_up(&rows[i]);
        compare_run(&rows[i]);
    }
}

static void only_a_plain_loop_is_taken(void)
{
    exk_brief brief;
    set_up(&rows[0]);
    start(false);
    TEST_ASSERT_EQUAL(EXK_ERR_ARG,
                      exk_loop_brief(&loop, 1, &way[1], &brief)); /* tick skipped */
    start(false);
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_brief(&loop, 0, &way[0], &brief));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_loop_brief(&loop, 0, &way[0], &brief)); /* repeated */
    TEST_ASSERT_TRUE(exk_loop_request(&loop, EXK_CAUSE_STOP, 1));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_loop_brief(&loop, 1, &way[1], &brief)); /* held */
    cfg.waits = true;
    start(false);
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_loop_brief(&loop, 0, &way[0], &brief));
}

static void whatever_is_not_in_order_ends_it(void)
{
    exk_brief brief;
    set_up(&rows[1]);
    u_rad[EXK_BETA][1] = 1.0; /* beyond the angles */
    start(false);
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_brief(&loop, 0, &way[0], &brief));
    TEST_ASSERT_EQUAL(EXK_ERR_LIMIT, exk_loop_brief(&loop, 1, &way[1], &brief));
    set_up(&rows[1]);
    cfg.limits.correction_max_rad = 1e-9;
    start(false);
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_brief(&loop, 0, &way[0], &brief));
    TEST_ASSERT_EQUAL(EXK_ERR_LIMIT, exk_loop_brief(&loop, 1, &way[1], &brief));
    set_up(&rows[0]);
    start(true);
    n_rad[EXK_ALPHA][2] = 1.0; /* what is measured is out of range */
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_brief(&loop, 0, &way[0], &brief));
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_brief(&loop, 1, &way[1], &brief));
    TEST_ASSERT_EQUAL(EXK_ERR_SENSOR, exk_loop_brief(&loop, 2, &way[2], &brief));
}

static void noise_of_several_sources_is_not_lent(void)
{
    double *const lend[EXK_N_AXES] = {n_rad[0], n_rad[1]};
    set_up(&rows[5]);
    start(false);
    TEST_ASSERT_FALSE(exk_twin_draw(&twin, 10, lend));
}

/* Past the end of what was lent the twin goes on drawing; a new init forgets the loan. */
static void a_loan_ends(void)
{
    const double q[EXK_N_AXES] = {0.0, 0.0};
    double *const lend[EXK_N_AXES] = {n_rad[0], n_rad[1]};
    exk_reading lent, drawn;
    set_up(&rows[0]);
    exk_twin other;
    TEST_ASSERT_EQUAL(EXK_OK, exk_twin_init(&other, &twin_cfg, which));
    start(false);
    TEST_ASSERT_TRUE(exk_twin_draw(&twin, 5, lend));
    exk_twin_lend(&twin, 5, lend);
    for (int64_t k = 0; k < 12; k++) {
        exk_twin_step(&twin, k, q, &lent);
        exk_twin_step(&other, k, q, &drawn);
        TEST_ASSERT_TRUE(same(lent.true_rad, drawn.true_rad, sizeof lent.true_rad));
    }
    n_rad[EXK_ALPHA][0] = 1.0;
    TEST_ASSERT_EQUAL(EXK_OK, exk_twin_init(&twin, &twin_cfg, which));
    exk_twin_step(&twin, 0, q, &drawn);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, drawn.true_rad[EXK_ALPHA]);
}

/* Going on after a hold is not plain: first the ramp, then the plan is behind the ticks. */
static void a_loop_that_is_behind_or_watched_is_not_plain(void)
{
    exk_brief brief;
    exk_sample sample;
    static exk_sample kept[4];
    static exk_capture capture;
    set_up(&rows[0]);
    start(false);
    int64_t k = 0;
    for (; k < 200; k++) {
        if (k == 100 || k == 150) {
            exk_loop_request(&loop, k == 100 ? EXK_CAUSE_STOP : EXK_CAUSE_START, k);
        }
        TEST_ASSERT_EQUAL(EXK_OK, exk_loop_step(&loop, k, &sample));
        if (k >= 99) {
            exk_loop copy = loop;
            TEST_ASSERT_EQUAL(k == 99 ? EXK_OK : EXK_ERR_ARG,
                              exk_loop_brief(&copy, k + 1, &way[k + 1], &brief));
        }
    }
    TEST_ASSERT_EQUAL(EXK_MOTION_FOLLOW, loop.motion.mode);
    TEST_ASSERT_EQUAL(EXK_OK, exk_capture_init(&capture, kept, 4));
    cfg.capture = &capture;
    start(false);
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_loop_brief(&loop, 0, &way[0], &brief));
}

static void legs_and_following_are_asked_too(void)
{
    exk_brief brief;
    const row *machine = &rows[6];
    set_up(machine);
    u_rad[EXK_ALPHA][1] = 0.8; /* within the sensor's range, beyond the joint's */
    cfg.angle_max_rad = 1.0;
    start(false);
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_brief(&loop, 0, &way[0], &brief));
    TEST_ASSERT_EQUAL(EXK_ERR_LIMIT, exk_loop_brief(&loop, 1, &way[1], &brief));
    set_up(&rows[0]);
    cfg.limits.following_rad = 1e-3;
    start(true);
    n_rad[EXK_ALPHA][1] = 2e-3;
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_brief(&loop, 0, &way[0], &brief));
    TEST_ASSERT_EQUAL(EXK_ERR_LIMIT, exk_loop_brief(&loop, 1, &way[1], &brief));
}

static exk_err hidden(void *ctx, int64_t k, const exk_drive *drive, exk_reading *out)
{
    const exk_source source = exk_twin_source(ctx);
    const exk_err err = source.exchange(source.ctx, k, drive, out);
    out->has_true = false;
    return err;
}

static void a_machine_that_hides_its_truth_is_judged_by_what_it_measures(void)
{
    exk_brief brief;
    exk_sample sample;
    set_up(&rows[4]);
    cfg.source = (exk_source){hidden, &twin};
    start(false);
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_step(&loop, 0, &sample));
    TEST_ASSERT_FALSE(sample.has_true);
    start(false);
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_brief(&loop, 0, &way[0], &brief));
    TEST_ASSERT_TRUE(same(&sample.est, &brief.tool, sizeof brief.tool));
}

static void a_plan_out_of_reach_has_no_waypoints(void)
{
    exk_hole far[] = {upright[0], upright[1]};
    exk_plan_config plan_cfg = exk_plan_default();
    static exk_waypoint some[TICKS_MAX];
    far[0].target_m[0] = 50.0;
    far[1].target_m[0] = 50.0;
    plan_cfg.dt_s = 0.01;
    set_up(&rows[0]);
    TEST_ASSERT_EQUAL(EXK_OK, exk_plan_init(&plan, &plan_cfg, far, 2, segments, SEGMENTS));
    TEST_ASSERT_TRUE(plan.n_ticks <= TICKS_MAX);
    TEST_ASSERT_EQUAL(EXK_ERR_UNREACHABLE, exk_waypoints(&plan, &kin, some));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(brief_steps_give_the_bits_of_whole_ones);
    RUN_TEST(only_a_plain_loop_is_taken);
    RUN_TEST(whatever_is_not_in_order_ends_it);
    RUN_TEST(noise_of_several_sources_is_not_lent);
    RUN_TEST(a_loan_ends);
    RUN_TEST(a_loop_that_is_behind_or_watched_is_not_plain);
    RUN_TEST(legs_and_following_are_asked_too);
    RUN_TEST(a_machine_that_hides_its_truth_is_judged_by_what_it_measures);
    RUN_TEST(a_plan_out_of_reach_has_no_waypoints);
    return UNITY_END();
}
