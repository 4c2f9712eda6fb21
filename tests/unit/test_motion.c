/* Holding, going on, backing out of the part: where the reference is, tick by tick. */
#include "exk/motion.h"

#include <math.h>
#include <string.h>

#include "exk/vec3.h"
#include "unity.h"

enum { N_HOLES = 3, SEGMENTS = 5 * N_HOLES };

static exk_hole holes[N_HOLES];
static exk_segment segments[SEGMENTS];
static exk_plan plan;
static exk_motion motion;
static exk_ref ref;
static const exk_motion_wish go = {.go = true};
static const exk_motion_wish rest = {.go = false, .out = false};
static const exk_motion_wish out = {.go = false, .out = true, .wait_s = 0.01};

static void plan_of(double accel_mps2, double dwell_s)
{
    exk_plan_config cfg = exk_plan_default();
    cfg.accel_mps2 = accel_mps2;
    cfg.clearance_m = 0.005;
    cfg.stroke_m = 0.012;
    cfg.dwell_s = dwell_s;
    cfg.closed = false;
    TEST_ASSERT_EQUAL(EXK_OK, exk_plan_init(&plan, &cfg, holes, N_HOLES, segments, SEGMENTS));
    exk_motion_init(&motion);
}

static void plan_with(double accel_mps2)
{
    plan_of(accel_mps2, 0.05);
}

void setUp(void)
{
    for (int i = 0; i < N_HOLES; i++) {
        const double tilt_rad = 0.05 * i;
        holes[i] =
            (exk_hole){i + 1, {0.02 * i, 0.001 * i, 1.4}, {sin(tilt_rad), 0.0, cos(tilt_rad)}};
    }
    plan_with(1.0);
}

void tearDown(void)
{
}

static void place(int64_t k, const exk_motion_wish *wish)
{
    exk_motion_place(&motion, &plan, k, wish, &ref);
}

static void follow_to(int64_t k)
{
    for (int64_t i = motion.k + 1; i <= k; i++) {
        place(i, &go);
    }
}

/* Goes on with a wish until a mode is reached; the ticks it took. */
static int64_t until(const exk_motion_wish *wish, exk_motion_mode mode)
{
    const int64_t k0 = motion.k;
    while (motion.mode != mode && motion.k - k0 < 20000) {
        place(motion.k + 1, wish);
    }
    TEST_ASSERT_EQUAL_STRING(exk_motion_name(mode), exk_motion_name(motion.mode));
    return motion.k - k0;
}

static double away_m(const exk_tool *a, const exk_tool *b)
{
    double delta[3];
    exk_add_scaled3(a->tip_m, -1.0, b->tip_m, delta);
    return exk_norm3(delta);
}

static const exk_segment *segment_of(int32_t hole, exk_phase phase)
{
    for (size_t i = 0; i < plan.n_segments; i++) {
        if (segments[i].hole == hole && segments[i].phase == phase) {
            return &segments[i];
        }
    }
    TEST_FAIL_MESSAGE("no such segment");
    return NULL;
}

static int64_t middle_of(int32_t hole, exk_phase phase)
{
    const exk_segment *s = segment_of(hole, phase);
    return s->k_begin + s->n_ticks / 2;
}

static bool is_plan_at(int64_t j)
{
    exk_ref want;
    exk_plan_at(&plan, j, &want);
    return want.phase == ref.phase && want.hole == ref.hole && want.judged == ref.judged &&
           memcmp(&want.tool, &ref.tool, sizeof want.tool) == 0;
}

static void following_is_the_plan_bit_for_bit(void)
{
    for (int64_t k = 0; k < plan.n_ticks + 5; k++) {
        place(k, &go);
        TEST_ASSERT_TRUE(is_plan_at(k));
        TEST_ASSERT_EQUAL_INT64(0, exk_motion_held(&motion));
    }
    exk_motion_init(&motion);
    place(17, &go); /* ticks may be skipped */
    TEST_ASSERT_TRUE(is_plan_at(17));
}

/* Slower and slower by 1/n a tick: the way is (n-1)/2 ticks, and speed never rises again. */
static void a_hold_slows_down_and_rests_on_a_whole_tick(void)
{
    static const exk_phase phases[] = {EXK_PHASE_TRAVEL, EXK_PHASE_APPROACH, EXK_PHASE_DWELL,
                                       EXK_PHASE_DRILL, EXK_PHASE_RETRACT};
    for (size_t i = 0; i < sizeof phases / sizeof phases[0]; i++) {
        setUp();
        const int64_t k = middle_of(1, phases[i]);
        follow_to(k);
        double last_way = 1.0;
        double was = (double)k;
        place(k + 1, &rest);
        const int64_t n = motion.n;
        TEST_ASSERT_EQUAL_INT64(1, n % 2);
        for (int64_t j = 1; j <= n; j++) {
            const double now = (double)motion.j + motion.part;
            TEST_ASSERT_TRUE(now - was <= last_way);
            last_way = now - was;
            was = now;
            place(motion.k + 1, &rest);
        }
        TEST_ASSERT_EQUAL(EXK_MOTION_REST, motion.mode);
        TEST_ASSERT_EQUAL_INT64(k + (n - 1) / 2, motion.j);
        TEST_ASSERT_TRUE(motion.part == 0.0);
        place(motion.k + 50, &rest);
        TEST_ASSERT_EQUAL_INT64(k + (n - 1) / 2, motion.j);
    }
}

/* feed/accel = 0.1 s of travel are 100 ticks, then odd: 101; a dwell needs one. */
static void ramps_are_as_long_as_the_feed_takes(void)
{
    follow_to(middle_of(1, EXK_PHASE_TRAVEL));
    place(motion.k + 1, &rest);
    TEST_ASSERT_EQUAL_INT64(101, motion.n);
    setUp();
    follow_to(middle_of(1, EXK_PHASE_DWELL));
    TEST_ASSERT_EQUAL_INT64(1, until(&rest, EXK_MOTION_REST));
    plan_with((double)INFINITY);
    follow_to(middle_of(1, EXK_PHASE_TRAVEL));
    TEST_ASSERT_EQUAL_INT64(1, until(&rest, EXK_MOTION_REST));
    plan_with(1e-12);
    follow_to(5);
    place(6, &rest);
    TEST_ASSERT_EQUAL_INT64(2000000001, motion.n); /* no ramp is longer */
}

/* Every hole is judged once, the path is the plan's and ends where the plan ends. */
static void a_run_held_again_and_again_is_the_same_path(void)
{
    int n_judged = 0;
    double longest_m = 0.0;
    exk_tool before = segments[0].from;
    for (int64_t k = 0; motion.j < plan.n_ticks && k < 200000; k++) {
        place(k, k / 400 % 2 == 0 ? &go : &rest);
        n_judged += ref.judged ? 1 : 0;
        longest_m = fmax(longest_m, away_m(&ref.tool, &before));
        before = ref.tool;
    }
    TEST_ASSERT_EQUAL_INT(N_HOLES, n_judged);
    TEST_ASSERT_TRUE(longest_m <= plan.cfg.feed_mps * plan.cfg.dt_s * (1.0 + 1e-9));
    TEST_ASSERT_TRUE(memcmp(&before, &segments[plan.n_segments - 1].to, sizeof before) == 0);
}

/* Without a dwell a ramp passes the judged tick between two samples: it counts when it is passed. */
static void a_hold_anywhere_loses_no_hole(void)
{
    plan_of(1.0, 0.0);
    for (int64_t stop = 1; stop < plan.n_ticks; stop++) {
        int n_judged = 0;
        exk_motion_init(&motion);
        for (int64_t k = 0; motion.j < plan.n_ticks && k < 200000; k++) {
            place(k, k >= stop && k < stop + 300 ? &rest : &go);
            n_judged += ref.judged ? 1 : 0;
        }
        TEST_ASSERT_EQUAL_INT(N_HOLES, n_judged);
    }
}

/* Whole ticks again after going on, so the rest of the run is the plan's, later. */
static void going_on_ends_on_a_whole_tick(void)
{
    follow_to(middle_of(1, EXK_PHASE_TRAVEL));
    until(&rest, EXK_MOTION_REST);
    const int64_t j = motion.j;
    TEST_ASSERT_EQUAL_INT64(motion.k - j, exk_motion_held(&motion));
    place(motion.k + 1, &go);
    TEST_ASSERT_EQUAL(EXK_MOTION_SPEED, motion.mode);
    const int64_t n = motion.n;
    until(&go, EXK_MOTION_FOLLOW);
    TEST_ASSERT_EQUAL_INT64(j + (n + 1) / 2, motion.j);
    TEST_ASSERT_TRUE(is_plan_at(motion.j));
    const int64_t held = exk_motion_held(&motion);
    follow_to(motion.k + 10);
    TEST_ASSERT_EQUAL_INT64(held, exk_motion_held(&motion));
    TEST_ASSERT_TRUE(is_plan_at(motion.k - held));
}

/* A ramp once begun is ended before another wish is looked at. */
static void wishes_wait_for_the_end_of_a_ramp(void)
{
    follow_to(middle_of(1, EXK_PHASE_TRAVEL));
    place(motion.k + 1, &rest);
    place(motion.k + 1, &go);
    TEST_ASSERT_EQUAL(EXK_MOTION_SLOW, motion.mode);
    until(&go, EXK_MOTION_REST);
    place(motion.k + 1, &go);
    place(motion.k + 1, &rest);
    TEST_ASSERT_EQUAL(EXK_MOTION_SPEED, motion.mode);
    until(&rest, EXK_MOTION_FOLLOW);
    place(motion.k + 1, &rest);
    TEST_ASSERT_EQUAL(EXK_MOTION_SLOW, motion.mode);
}

/* A tick is a tick, seen or not: skipping leads where not skipping leads. */
static void skipped_ticks_count_as_gone(void)
{
    exk_motion_mode modes[] = {EXK_MOTION_REST, EXK_MOTION_FOLLOW};
    const exk_motion_wish *wishes[] = {&rest, &go};
    follow_to(middle_of(1, EXK_PHASE_TRAVEL));
    for (int i = 0; i < 2; i++) {
        const exk_motion before = motion;
        for (int j = 0; j < 300; j++) {
            place(motion.k + 1, wishes[i]);
        }
        const exk_motion slow = motion;
        motion = before;
        place(motion.k + 1, wishes[i]);
        place(motion.k + 299, wishes[i]);
        TEST_ASSERT_EQUAL(modes[i], motion.mode);
        TEST_ASSERT_EQUAL_INT64(slow.j, motion.j);
        TEST_ASSERT_EQUAL_INT64(slow.k, motion.k);
    }
}

/* From the bottom of the hole straight back, no faster than the retract feed, to the clearance. */
static void a_fault_backs_out_of_the_part(void)
{
    follow_to(middle_of(1, EXK_PHASE_DRILL));
    until(&rest, EXK_MOTION_REST);
    const exk_tool deep = ref.tool;
    TEST_ASSERT_EQUAL_INT64(11, until(&out, EXK_MOTION_RETRACT)); /* waits 10 ms and a tick */
    exk_tool before = deep;
    while (motion.mode == EXK_MOTION_RETRACT) {
        place(motion.k + 1, &out);
        TEST_ASSERT_EQUAL(EXK_PHASE_RETRACT, ref.phase);
        TEST_ASSERT_FALSE(ref.judged);
        TEST_ASSERT_TRUE(away_m(&ref.tool, &before) <=
                         plan.cfg.retract_mps * plan.cfg.dt_s * (1.0 + 1e-9));
        before = ref.tool;
    }
    TEST_ASSERT_EQUAL(EXK_MOTION_OUT, motion.mode);
    TEST_ASSERT_TRUE(exk_motion_is_over(&motion));
    const exk_tool *clear = &segment_of(1, EXK_PHASE_APPROACH)->from;
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.0, away_m(&ref.tool, clear));
    place(motion.k + 100, &out);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.0, away_m(&ref.tool, clear));
    place(motion.k + 1, &go); /* the hole is begun anew */
    TEST_ASSERT_EQUAL(EXK_MOTION_SPEED, motion.mode);
    TEST_ASSERT_FALSE(motion.retracts);
    TEST_ASSERT_EQUAL_INT64(segment_of(1, EXK_PHASE_APPROACH)->k_begin - 1, motion.j0);
}

/* Frozen on the way out: going on ends that way first, from where it was. */
static void a_way_out_that_was_broken_off_is_ended_first(void)
{
    follow_to(middle_of(1, EXK_PHASE_DRILL));
    until(&rest, EXK_MOTION_REST);
    until(&out, EXK_MOTION_RETRACT);
    for (int i = 0; i < 60; i++) {
        place(motion.k + 1, &out);
    }
    const exk_tool there = ref.tool;
    const int64_t step = motion.step;
    TEST_ASSERT_TRUE(step > 0 && step < motion.way.n_ticks);
    exk_motion_freeze(&motion);
    place(motion.k + 500, &out);
    TEST_ASSERT_TRUE(memcmp(&there, &ref.tool, sizeof there) == 0);
    place(motion.k + 1, &go);
    TEST_ASSERT_EQUAL(EXK_MOTION_RETRACT, motion.mode);
    TEST_ASSERT_EQUAL_INT64(step + 1, motion.step);
    until(&go, EXK_MOTION_OUT);
    place(motion.k + 1, &go);
    TEST_ASSERT_EQUAL(EXK_MOTION_SPEED, motion.mode);
}

static void while_travelling_there_is_no_way_out_to_go(void)
{
    follow_to(middle_of(1, EXK_PHASE_TRAVEL));
    until(&rest, EXK_MOTION_REST);
    const int64_t j = motion.j;
    TEST_ASSERT_EQUAL_INT64(11, until(&out, EXK_MOTION_OUT));
    TEST_ASSERT_EQUAL_INT64(j, motion.j);
    place(motion.k + 1, &go); /* on from there */
    TEST_ASSERT_EQUAL_INT64(j, motion.j0);
}

/* A hold never backs out; a time to wait that is no number never ends. */
static void without_the_wish_it_stays(void)
{
    const exk_motion_wish never = {.go = false, .out = true, .wait_s = (double)NAN};
    follow_to(middle_of(1, EXK_PHASE_DRILL));
    until(&rest, EXK_MOTION_REST);
    place(motion.k + 100000, &rest);
    TEST_ASSERT_EQUAL(EXK_MOTION_REST, motion.mode);
    place(motion.k + 100000, &never);
    TEST_ASSERT_EQUAL(EXK_MOTION_REST, motion.mode);
    TEST_ASSERT_FALSE(exk_motion_is_over(&motion));
}

/* Settled at once: at rest, or in a dwell, with the tool clear of the part already. */
static void settling_freezes_where_there_is_no_way_to_go(void)
{
    exk_plan_config cfg = plan.cfg;
    const int64_t drilling = middle_of(1, EXK_PHASE_DRILL);
    const int64_t dwelling = middle_of(1, EXK_PHASE_DWELL);
    follow_to(dwelling);
    exk_motion_settle(&motion, &plan); /* 5 mm to go */
    TEST_ASSERT_EQUAL(EXK_MOTION_FOLLOW, motion.mode);
    follow_to(drilling);
    exk_motion_settle(&motion, &plan); /* not at rest */
    TEST_ASSERT_EQUAL(EXK_MOTION_FOLLOW, motion.mode);
    until(&rest, EXK_MOTION_REST);
    exk_motion_settle(&motion, &plan);
    TEST_ASSERT_EQUAL(EXK_MOTION_REST, motion.mode);
    cfg.clearance_m = 0.0;
    TEST_ASSERT_EQUAL(EXK_OK, exk_plan_init(&plan, &cfg, holes, N_HOLES, segments, SEGMENTS));
    exk_motion_init(&motion);
    follow_to(middle_of(1, EXK_PHASE_DWELL));
    exk_motion_settle(&motion, &plan);
    TEST_ASSERT_EQUAL(EXK_MOTION_OUT, motion.mode);
    exk_motion_init(&motion);
    follow_to(middle_of(1, EXK_PHASE_TRAVEL));
    until(&rest, EXK_MOTION_REST);
    exk_motion_settle(&motion, &plan);
    TEST_ASSERT_EQUAL(EXK_MOTION_OUT, motion.mode);
}

/* A way back of more ticks than a phase may have cannot be planned: none is gone. */
static void a_way_back_too_long_is_not_gone(void)
{
    follow_to(middle_of(1, EXK_PHASE_DWELL));
    plan.cfg.retract_mps = 1e-12;
    exk_motion_settle(&motion, &plan);
    TEST_ASSERT_EQUAL(EXK_MOTION_FOLLOW, motion.mode);
    until(&rest, EXK_MOTION_REST);
    until(&out, EXK_MOTION_OUT);
    TEST_ASSERT_FALSE(motion.retracts);
}

static void modes_have_names(void)
{
    for (int i = -1; i <= EXK_MOTION_COUNT; i++) {
        TEST_ASSERT_NOT_NULL(exk_motion_name((exk_motion_mode)i));
    }
    TEST_ASSERT_EQUAL_STRING("at rest", exk_motion_name(EXK_MOTION_REST));
    TEST_ASSERT_EQUAL_STRING("unknown", exk_motion_name(EXK_MOTION_COUNT));
}

/* Held on the judged tick it is not judged again; reached while going on it is. */
static void a_judged_sample_counts_when_it_is_reached(void)
{
    const exk_segment *dwell = segment_of(1, EXK_PHASE_DWELL);
    const int64_t judged = dwell->k_begin + dwell->n_ticks - 1;
    follow_to(judged);
    TEST_ASSERT_TRUE(ref.judged);
    place(motion.k + 1, &rest);
    TEST_ASSERT_FALSE(ref.judged);
    TEST_ASSERT_EQUAL_INT64(judged, motion.j);
    setUp();
    follow_to(judged - 1);
    until(&rest, EXK_MOTION_REST);
    TEST_ASSERT_EQUAL_INT64(judged - 1, motion.j);
    place(motion.k + 1, &go);
    TEST_ASSERT_EQUAL_INT64(judged, motion.j);
    TEST_ASSERT_TRUE(ref.judged);
}

static void settling_waits_for_the_end_of_a_ramp(void)
{
    follow_to(middle_of(1, EXK_PHASE_TRAVEL));
    place(motion.k + 1, &rest);
    exk_motion_settle(&motion, &plan);
    TEST_ASSERT_EQUAL(EXK_MOTION_SLOW, motion.mode);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(following_is_the_plan_bit_for_bit);
    RUN_TEST(a_hold_slows_down_and_rests_on_a_whole_tick);
    RUN_TEST(ramps_are_as_long_as_the_feed_takes);
    RUN_TEST(a_run_held_again_and_again_is_the_same_path);
    RUN_TEST(a_hold_anywhere_loses_no_hole);
    RUN_TEST(going_on_ends_on_a_whole_tick);
    RUN_TEST(wishes_wait_for_the_end_of_a_ramp);
    RUN_TEST(skipped_ticks_count_as_gone);
    RUN_TEST(a_fault_backs_out_of_the_part);
    RUN_TEST(a_way_out_that_was_broken_off_is_ended_first);
    RUN_TEST(while_travelling_there_is_no_way_out_to_go);
    RUN_TEST(without_the_wish_it_stays);
    RUN_TEST(settling_freezes_where_there_is_no_way_to_go);
    RUN_TEST(a_way_back_too_long_is_not_gone);
    RUN_TEST(modes_have_names);
    RUN_TEST(a_judged_sample_counts_when_it_is_reached);
    RUN_TEST(settling_waits_for_the_end_of_a_ramp);
    return UNITY_END();
}
