#include <math.h>
#include <string.h>

#include "exk/job.h"
#include "exk/plan.h"
#include "exk/vec3.h"
#include "unity.h"

enum { MAX_HOLES = 32, MAX_SEGMENTS = 5 * MAX_HOLES };

static exk_hole holes[MAX_HOLES];
static exk_segment segments[MAX_SEGMENTS];
static exk_plan plan;

void setUp(void)
{
    memset(segments, 0, sizeof(segments));
}

void tearDown(void)
{
}

static size_t study_rectangle(void)
{
    size_t n = 0;
    const exk_pattern pattern = {0.3, 0.2, {0.0, 0.0, 0.95}, 1, 1};
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_rectangle(&pattern, holes, MAX_HOLES, &n));
    return n;
}

/* Five holes on a bent line, each axis tilted another way. */
static size_t tilted_holes(void)
{
    for (int i = 0; i < 5; i++) {
        exk_hole hole = {.id = 10 + i, .target_m = {0.03 * i, 0.002 * i * i, 1.4}};
        const double tilt_rad = 0.05 * i;
        hole.axis[0] = sin(tilt_rad);
        hole.axis[2] = cos(tilt_rad);
        holes[i] = hole;
    }
    return 5;
}

static exk_plan_config full_cycle(void)
{
    exk_plan_config cfg = exk_plan_default();
    cfg.clearance_m = 0.005;
    cfg.stroke_m = 0.012;
    cfg.dwell_s = 0.0505;
    return cfg;
}

static void build(const exk_plan_config *cfg, size_t n_holes)
{
    TEST_ASSERT_EQUAL(EXK_OK,
                      exk_plan_init(&plan, cfg, holes, n_holes, segments, MAX_SEGMENTS));
}

static exk_ref at(int64_t k)
{
    exk_ref ref;
    exk_plan_at(&plan, k, &ref);
    return ref;
}

static double distance_m(const exk_tool *a, const exk_tool *b)
{
    double delta[3];
    exk_add_scaled3(a->tip_m, -1.0, b->tip_m, delta);
    return exk_norm3(delta);
}

static double feed_of(exk_phase phase)
{
    const double feeds[EXK_PHASE_COUNT] = {plan.cfg.feed_mps, plan.cfg.approach_mps, 0.0,
                                           plan.cfg.drill_mps, plan.cfg.retract_mps};
    return feeds[phase];
}

static void the_study_rectangle_takes_12_seconds_exactly(void)
{
    exk_plan_config cfg = exk_plan_default();
    cfg.accel_mps2 = (double)INFINITY;
    build(&cfg, study_rectangle());
    TEST_ASSERT_EQUAL_INT64(12000, plan.n_ticks);
    const exk_ref middle = at(499 + 1500); /* half way along the first side */
    TEST_ASSERT_EQUAL(EXK_PHASE_TRAVEL, middle.phase);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.0, middle.tool.tip_m[EXK_X]);
    TEST_ASSERT_TRUE(-0.1 == middle.tool.tip_m[EXK_Y]);
    const exk_ref last = at(11999);
    TEST_ASSERT_EQUAL_MEMORY(holes[0].target_m, last.tool.tip_m, sizeof(last.tool.tip_m));
}

static void an_open_job_ends_at_its_last_hole(void)
{
    exk_plan_config cfg = exk_plan_default();
    cfg.accel_mps2 = (double)INFINITY;
    cfg.closed = false;
    build(&cfg, study_rectangle());
    TEST_ASSERT_EQUAL_INT64(10000, plan.n_ticks);
    TEST_ASSERT_TRUE(at(9999).judged);
    TEST_ASSERT_FALSE(at(10000).judged); /* held, not drilled again */
    TEST_ASSERT_EQUAL_MEMORY(holes[3].target_m, at(10000).tool.tip_m, 3 * sizeof(double));
}

static void phases_come_in_the_order_of_the_header(void)
{
    const exk_plan_config cfg = full_cycle();
    build(&cfg, tilted_holes());
    TEST_ASSERT_EQUAL_UINT(25, plan.n_segments);
    const exk_phase cycle[] = {EXK_PHASE_APPROACH, EXK_PHASE_DWELL, EXK_PHASE_DRILL,
                               EXK_PHASE_RETRACT, EXK_PHASE_TRAVEL};
    int64_t k = 0;
    for (size_t i = 0; i < plan.n_segments; i++) {
        TEST_ASSERT_EQUAL(cycle[i % 5], segments[i].phase);
        TEST_ASSERT_EQUAL_INT32((int32_t)((i + 1) / 5 % 5), segments[i].hole);
        TEST_ASSERT_EQUAL_INT64(k, segments[i].k_begin);
        TEST_ASSERT_TRUE(segments[i].n_ticks > 0);
        k += segments[i].n_ticks;
    }
    TEST_ASSERT_EQUAL_INT64(k, plan.n_ticks);
}

static void the_last_sample_of_a_move_is_its_end_exactly(void)
{
    const exk_plan_config cfg = full_cycle();
    build(&cfg, tilted_holes());
    for (size_t i = 0; i < plan.n_segments; i++) {
        const exk_ref ref = at(segments[i].k_begin + segments[i].n_ticks - 1);
        TEST_ASSERT_EQUAL(segments[i].phase, ref.phase);
        TEST_ASSERT_EQUAL_MEMORY(&segments[i].to, &ref.tool, sizeof(ref.tool));
        if (i + 1 < plan.n_segments) {
            TEST_ASSERT_EQUAL_MEMORY(&segments[i].to, &segments[i + 1].from, sizeof(exk_tool));
        }
    }
}

/* Slack of 1e-9 of the step, as the header says, and of the rounding of a coordinate near 1 m. */
static void no_step_exceeds_its_feed(void)
{
    const double accels[] = {0.05, 1.0, 30.0, (double)INFINITY};
    for (size_t i = 0; i < sizeof(accels) / sizeof(accels[0]); i++) {
        exk_plan_config cfg = full_cycle();
        cfg.accel_mps2 = accels[i];
        build(&cfg, tilted_holes());
        for (int64_t k = 1; k < plan.n_ticks; k++) {
            const exk_ref before = at(k - 1);
            const exk_ref now = at(k);
            const double limit_m = feed_of(now.phase) * cfg.dt_s * (1.0 + 1e-9) + 1e-15;
            TEST_ASSERT_TRUE(distance_m(&now.tool, &before.tool) <= limit_m);
        }
    }
}

/* Second differences within a move and at rest before and after it; a rounding of 2e-16 m in each
 * of the three samples is the slack. */
static void acceleration_stays_within_its_limit(void)
{
    const double accels[] = {0.05, 1.0, 30.0};
    for (size_t i = 0; i < sizeof(accels) / sizeof(accels[0]); i++) {
        exk_plan_config cfg = full_cycle();
        cfg.accel_mps2 = accels[i];
        build(&cfg, tilted_holes());
        const double limit_m = cfg.accel_mps2 * cfg.dt_s * cfg.dt_s * (1.0 + 1e-9) + 2e-15;
        double worst_m = 0.0;
        for (int64_t k = 1; k + 1 < plan.n_ticks; k++) {
            const exk_ref refs[3] = {at(k - 1), at(k), at(k + 1)};
            double bend[3];
            for (int axis = 0; axis < 3; axis++) {
                bend[axis] = refs[0].tool.tip_m[axis] - 2.0 * refs[1].tool.tip_m[axis] +
                             refs[2].tool.tip_m[axis];
            }
            worst_m = fmax(worst_m, exk_norm3(bend));
        }
        TEST_ASSERT_TRUE(worst_m <= limit_m);
        TEST_ASSERT_TRUE(worst_m >= 0.5 * cfg.accel_mps2 * cfg.dt_s * cfg.dt_s);
    }
}

static void a_long_move_reaches_its_feed(void)
{
    exk_plan_config cfg = exk_plan_default();
    build(&cfg, study_rectangle());
    const exk_ref before = at(499 + 1500);
    const exk_ref now = at(499 + 1501);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, cfg.feed_mps * cfg.dt_s,
                              distance_m(&now.tool, &before.tool));
    TEST_ASSERT_EQUAL_INT64(4 * 500 + 2 * 3100 + 2 * 2100, plan.n_ticks); /* T = L/v + v/a */
}

static void a_short_move_is_a_triangle(void)
{
    exk_plan_config cfg = exk_plan_default();
    cfg.closed = false;
    cfg.dwell_s = 0.0;
    holes[0] = (exk_hole){1, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}};
    holes[1] = (exk_hole){2, {0.0025, 0.0, 1.0}, {0.0, 0.0, 1.0}};
    build(&cfg, 2);
    TEST_ASSERT_EQUAL_UINT(3, plan.n_segments);
    TEST_ASSERT_EQUAL_INT64(100, segments[1].n_ticks); /* 2 sqrt(L/a) = 0.1 s */
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.00125, at(50).tool.tip_m[EXK_X]);
}

static void one_judged_sample_a_hole_at_the_target(void)
{
    const double dwells[] = {0.0, 0.0505, 0.5};
    for (size_t i = 0; i < sizeof(dwells) / sizeof(dwells[0]); i++) {
        exk_plan_config cfg = full_cycle();
        cfg.dwell_s = dwells[i];
        build(&cfg, tilted_holes());
        int judged[MAX_HOLES] = {0};
        for (int64_t k = -5; k < plan.n_ticks + 5; k++) {
            const exk_ref ref = at(k);
            if (ref.judged) {
                judged[ref.hole]++;
                TEST_ASSERT_EQUAL_MEMORY(holes[ref.hole].target_m, ref.tool.tip_m,
                                         sizeof(ref.tool.tip_m));
            }
        }
        for (int hole = 0; hole < 5; hole++) {
            TEST_ASSERT_EQUAL_INT(1, judged[hole]);
        }
    }
}

static void the_stroke_goes_along_the_axis_of_the_hole(void)
{
    const exk_plan_config cfg = full_cycle();
    build(&cfg, tilted_holes());
    for (size_t i = 0; i < plan.n_segments; i++) {
        if (segments[i].phase == EXK_PHASE_DRILL) {
            const exk_hole *hole = &holes[segments[i].hole];
            double delta[3];
            exk_add_scaled3(segments[i].to.tip_m, -1.0, hole->target_m, delta);
            TEST_ASSERT_DOUBLE_WITHIN(1e-15, cfg.stroke_m, exk_dot3(delta, hole->axis));
            TEST_ASSERT_DOUBLE_WITHIN(1e-15, cfg.stroke_m, exk_norm3(delta));
        }
    }
}

static void axes_stay_of_unit_length_and_turn_steadily(void)
{
    const exk_plan_config cfg = full_cycle();
    build(&cfg, tilted_holes());
    for (int64_t k = 1; k < plan.n_ticks; k++) {
        const exk_ref before = at(k - 1);
        const exk_ref now = at(k);
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1.0, exk_norm3(now.tool.axis));
        /* the header's 0.5 m arm; 1 % for the chord that the axis is blended on */
        const double turn = acos(fmin(1.0, exk_dot3(now.tool.axis, before.tool.axis)));
        TEST_ASSERT_TRUE(turn <= 1.01 * feed_of(now.phase) * cfg.dt_s / 0.5 + 1e-7);
    }
}

static void a_turn_on_the_spot_takes_time(void)
{
    exk_plan_config cfg = exk_plan_default();
    cfg.accel_mps2 = (double)INFINITY;
    cfg.closed = false;
    holes[0] = (exk_hole){1, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}};
    holes[1] = (exk_hole){2, {0.0, 0.0, 1.0}, {sin(0.2), 0.0, cos(0.2)}};
    build(&cfg, 2);
    TEST_ASSERT_EQUAL_UINT(3, plan.n_segments);
    TEST_ASSERT_EQUAL_INT64(1000, segments[1].n_ticks); /* 0.5 m * 0.2 rad at 0.1 m/s */
    const exk_ref middle = at(segments[1].k_begin + 499);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, sin(0.1), middle.tool.axis[0]);
}

static void a_sample_depends_on_k_alone(void)
{
    const exk_plan_config cfg = full_cycle();
    build(&cfg, tilted_holes());
    const int64_t n = plan.n_ticks;
    static exk_ref forward[20000];
    TEST_ASSERT_TRUE(n <= 20000 && n % 7919 != 0);
    memset(forward, 0, sizeof(forward));
    for (int64_t k = 0; k < n; k++) {
        exk_plan_at(&plan, k, &forward[k]);
    }
    for (int64_t i = 0; i < n; i++) { /* 7919 is prime and no factor of n: each tick once */
        const int64_t k = (i * 7919) % n;
        exk_ref again;
        memset(&again, 0, sizeof(again));
        exk_plan_at(&plan, k, &again);
        TEST_ASSERT_EQUAL_MEMORY(&forward[k].tool, &again.tool, sizeof(again.tool));
        TEST_ASSERT_EQUAL(forward[k].phase, again.phase);
        TEST_ASSERT_EQUAL_INT32(forward[k].hole, again.hole);
    }
}

static void before_and_after_the_run_the_ends_are_held(void)
{
    const exk_plan_config cfg = full_cycle();
    build(&cfg, tilted_holes());
    const exk_ref first = at(0);
    const exk_ref last = at(plan.n_ticks - 1);
    const exk_ref early = at(INT64_MIN);
    const exk_ref late = at(INT64_MAX);
    TEST_ASSERT_EQUAL_MEMORY(&first.tool, &early.tool, sizeof(first.tool));
    TEST_ASSERT_EQUAL_MEMORY(&last.tool, &late.tool, sizeof(last.tool));
}

typedef struct {
    const char *name;
    size_t offset;
    double value;
} bad_row;

static void a_bad_setting_is_refused(void)
{
    const double nan_value = (double)NAN;
    const double infinite = (double)INFINITY;
    const bad_row rows[] = {
        {"dt 0", offsetof(exk_plan_config, dt_s), 0.0},
        {"dt infinite", offsetof(exk_plan_config, dt_s), infinite},
        {"feed negative", offsetof(exk_plan_config, feed_mps), -0.1},
        {"feed NaN", offsetof(exk_plan_config, feed_mps), nan_value},
        {"approach 0", offsetof(exk_plan_config, approach_mps), 0.0},
        {"drill NaN", offsetof(exk_plan_config, drill_mps), nan_value},
        {"retract infinite", offsetof(exk_plan_config, retract_mps), infinite},
        {"acceleration 0", offsetof(exk_plan_config, accel_mps2), 0.0},
        {"acceleration NaN", offsetof(exk_plan_config, accel_mps2), nan_value},
        {"clearance negative", offsetof(exk_plan_config, clearance_m), -1e-9},
        {"stroke infinite", offsetof(exk_plan_config, stroke_m), infinite},
        {"dwell NaN", offsetof(exk_plan_config, dwell_s), nan_value},
        {"dwell of a century", offsetof(exk_plan_config, dwell_s), 3.2e9},
        {"feed of a snail", offsetof(exk_plan_config, feed_mps), 1e-12},
    };
    const size_t n = study_rectangle();
    for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
        exk_plan_config cfg = exk_plan_default();
        memcpy((char *)&cfg + rows[i].offset, &rows[i].value, sizeof(double));
        TEST_ASSERT_EQUAL_MESSAGE(EXK_ERR_ARG,
                                  exk_plan_init(&plan, &cfg, holes, n, segments, MAX_SEGMENTS),
                                  rows[i].name);
    }
}

static void a_bad_hole_is_refused(void)
{
    const exk_plan_config cfg = full_cycle();
    const exk_hole bad[] = {
        {1, {(double)NAN, 0.0, 1.0}, {0.0, 0.0, 1.0}},
        {2, {0.0, 0.0, (double)INFINITY}, {0.0, 0.0, 1.0}},
        {3, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0001}},
        {4, {0.0, 0.0, 1.0}, {0.0, (double)NAN, 1.0}},
        {5, {0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}}, /* opposite to its neighbour */
    };
    for (size_t i = 0; i < sizeof(bad) / sizeof(bad[0]); i++) {
        tilted_holes();
        holes[1] = bad[i];
        TEST_ASSERT_EQUAL(EXK_ERR_ARG,
                          exk_plan_init(&plan, &cfg, holes, 5, segments, MAX_SEGMENTS));
    }
}

static void a_lent_array_too_short_is_refused(void)
{
    const exk_plan_config cfg = full_cycle();
    const size_t n = tilted_holes();
    const size_t needed = exk_plan_segments_needed(n);
    TEST_ASSERT_EQUAL(EXK_ERR_SIZE, exk_plan_init(&plan, &cfg, holes, n, segments, needed - 1));
    TEST_ASSERT_EQUAL(EXK_ERR_SIZE, exk_plan_init(&plan, &cfg, holes, 0, segments, needed));
    TEST_ASSERT_EQUAL(EXK_OK, exk_plan_init(&plan, &cfg, holes, n, segments, needed));
}

static void every_phase_has_a_name(void)
{
    for (int i = 0; i < EXK_PHASE_COUNT; i++) {
        TEST_ASSERT_NOT_EQUAL(0, strcmp("unknown", exk_phase_name((exk_phase)i)));
    }
    TEST_ASSERT_EQUAL_STRING("unknown", exk_phase_name(EXK_PHASE_COUNT));
}

static void more_holes_than_can_be_counted_are_refused(void)
{
    const exk_plan_config cfg = exk_plan_default();
    TEST_ASSERT_EQUAL(EXK_ERR_SIZE, exk_plan_init(&plan, &cfg, holes, (size_t)INT32_MAX + 1,
                                                  segments, SIZE_MAX));
}

/* So fast that the time of it is below the least number: the dwells follow each other. */
static void a_move_of_no_time_takes_no_tick(void)
{
    exk_plan_config cfg = exk_plan_default();
    cfg.accel_mps2 = (double)INFINITY;
    cfg.feed_mps = 1e300;
    cfg.dt_s = 1e20;
    cfg.closed = false;
    holes[0] = (exk_hole){1, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}};
    holes[1] = (exk_hole){2, {1e-10, 0.0, 1.0}, {0.0, 0.0, 1.0}};
    build(&cfg, 2);
    TEST_ASSERT_EQUAL_UINT(2, plan.n_segments);
    TEST_ASSERT_EQUAL_INT64(2, plan.n_ticks);
}

/* Axes may be off unit length by 1e-9, so they may differ in z alone. */
static void a_turn_of_the_last_digit_is_a_turn(void)
{
    exk_plan_config cfg = exk_plan_default();
    cfg.closed = false;
    holes[0] = (exk_hole){1, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}};
    holes[1] = (exk_hole){2, {0.1, 0.0, 1.0}, {0.0, 0.0, 1.0 - 5e-10}};
    build(&cfg, 2);
    TEST_ASSERT_TRUE(segments[1].turns);
    TEST_ASSERT_TRUE(at(plan.n_ticks - 1).tool.axis[2] == holes[1].axis[2]);
}

/* From every tick: before the hole that is worked on, after a retract, in place while travelling. */
static void it_goes_on_where_a_hole_begins(void)
{
    const exk_plan_config cfg = full_cycle();
    build(&cfg, tilted_holes());
    for (size_t i = 0; i < plan.n_segments; i++) {
        const exk_segment *s = &segments[i];
        const int64_t last = s->k_begin + s->n_ticks - 1;
        const size_t first =
            i - i % 5; /* approach of its cycle, as of "phases come in order" */
        for (int64_t k = s->k_begin; k <= last; k += s->n_ticks > 1 ? s->n_ticks - 1 : 1) {
            const int64_t want = s->phase == EXK_PHASE_TRAVEL    ? k
                                 : s->phase == EXK_PHASE_RETRACT ? last
                                                                 : segments[first].k_begin - 1;
            TEST_ASSERT_EQUAL_INT64(want, exk_plan_resume(&plan, k));
        }
    }
    TEST_ASSERT_EQUAL_INT64(-1, exk_plan_resume(&plan, -5));
    TEST_ASSERT_EQUAL_INT64(plan.n_ticks + 5, exk_plan_resume(&plan, plan.n_ticks + 5));
}

/* Without strokes a hole is a dwell, and two dwells may follow each other: each is a hole of its own. */
static void a_hole_at_the_place_of_another_is_begun_alone(void)
{
    exk_plan_config cfg = exk_plan_default();
    cfg.closed = false;
    holes[0] = (exk_hole){1, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}};
    holes[1] = (exk_hole){2, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}};
    build(&cfg, 2);
    TEST_ASSERT_EQUAL_UINT(2, plan.n_segments);
    TEST_ASSERT_EQUAL_INT64(segments[1].k_begin - 1,
                            exk_plan_resume(&plan, segments[1].k_begin + 3));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_study_rectangle_takes_12_seconds_exactly);
    RUN_TEST(an_open_job_ends_at_its_last_hole);
    RUN_TEST(phases_come_in_the_order_of_the_header);
    RUN_TEST(the_last_sample_of_a_move_is_its_end_exactly);
    RUN_TEST(no_step_exceeds_its_feed);
    RUN_TEST(acceleration_stays_within_its_limit);
    RUN_TEST(a_long_move_reaches_its_feed);
    RUN_TEST(a_short_move_is_a_triangle);
    RUN_TEST(one_judged_sample_a_hole_at_the_target);
    RUN_TEST(the_stroke_goes_along_the_axis_of_the_hole);
    RUN_TEST(axes_stay_of_unit_length_and_turn_steadily);
    RUN_TEST(a_turn_on_the_spot_takes_time);
    RUN_TEST(a_sample_depends_on_k_alone);
    RUN_TEST(before_and_after_the_run_the_ends_are_held);
    RUN_TEST(a_bad_setting_is_refused);
    RUN_TEST(a_bad_hole_is_refused);
    RUN_TEST(a_lent_array_too_short_is_refused);
    RUN_TEST(every_phase_has_a_name);
    RUN_TEST(more_holes_than_can_be_counted_are_refused);
    RUN_TEST(a_move_of_no_time_takes_no_tick);
    RUN_TEST(a_turn_of_the_last_digit_is_a_turn);
    RUN_TEST(it_goes_on_where_a_hole_begins);
    RUN_TEST(a_hole_at_the_place_of_another_is_begun_alone);
    return UNITY_END();
}
