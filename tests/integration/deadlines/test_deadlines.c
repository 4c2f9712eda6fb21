/* Deadlines under an injected clock: late by 1 to 100 ticks, running backwards, standing still. What is
 * counted, what is commanded, and that a missed tick is never made up for in a burst. */
#include <string.h>

#include "ticks.h"
#include "unity.h"

enum { PERIOD_NS = 1000000, SEEN_MAX = 8192 };

static const char profile_text[] = "[kinematics]\nmodel = machine\n"
                                   "[job]\nkind = rectangle\nwidth_mm = 20\nheight_mm = 20\n"
                                   "dwell_s = 0.02\naccel_mmps2 = 5000\n"
                                   "[control]\nfeedback = pid\nki_per_s = 20\n"
                                   "[loop]\nmissed_max = 20\n";

/* A clock that does what the row of a test says at one tick. */
static struct {
    int64_t t_ns;
    int64_t k_trouble; /* the sleep before which the trouble is met; -1: none */
    int64_t late_ns;   /* added to it; negative: backwards */
    bool stands;       /* from there on */
    bool keeps;        /* late by as much at every sleep from there on */
    int64_t n_sleeps;
} wall;

static struct {
    int64_t k[SEEN_MAX];
    int64_t t_ns[SEEN_MAX];
    int n;
} seen; /* what was driven, and when */

static loop_ticks ticks;
static exk_rig rig;

static int64_t fake_now(void *ctx)
{
    (void)ctx;
    return wall.t_ns;
}

static void fake_sleep(void *ctx, int64_t t_ns)
{
    (void)ctx;
    const bool trouble = wall.k_trouble >= 0 && wall.n_sleeps >= wall.k_trouble;
    wall.n_sleeps++;
    if (trouble && wall.stands) {
        return;
    }
    wall.t_ns = t_ns > wall.t_ns ? t_ns : wall.t_ns;
    if (trouble) {
        wall.t_ns += wall.late_ns;
        wall.k_trouble = wall.keeps ? wall.k_trouble : -1;
    }
}

static exk_err watch(void *ctx, int64_t k, const exk_drive *drive, exk_reading *out)
{
    const exk_source *twin = ctx;
    if (seen.n < SEEN_MAX) {
        seen.k[seen.n] = k;
        seen.t_ns[seen.n++] = wall.t_ns;
    }
    return twin->exchange(twin->ctx, k, drive, out);
}

static exk_source twin;

void setUp(void)
{
    static exk_profile profile;
    size_t n = 0;
    exk_fault faults[4];
    exk_hole holes[8];
    size_t n_holes = 0;
    TEST_ASSERT_EQUAL(EXK_OK, exk_profile_parse(profile_text, &profile, faults, 4, &n));
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_rectangle(&profile.job.pattern, holes, 8, &n_holes));
    TEST_ASSERT_EQUAL_INT(0, exk_rig_open_text(&rig, "test", profile_text, holes, n_holes));
    memset(&wall, 0, sizeof wall);
    memset(&seen, 0, sizeof seen);
    wall.k_trouble = -1;
}

void tearDown(void)
{
    exk_rig_close(&rig);
}

static void run(void)
{
    char why[256];
    exk_publish_summary summary;
    const exk_realisation which = {.seed = 1, .run = 1};
    const exk_run_info info = {.profile = &rig.profile,
                               .profile_text = profile_text,
                               .run_id = 1,
                               .holes = rig.holes,
                               .n_holes = rig.n_holes,
                               .n_ticks = rig.plan.n_ticks};
    TEST_ASSERT_EQUAL(EXK_OK, exk_rig_start(&rig, which, NULL, 0));
    twin = rig.loop.cfg.source;
    rig.loop.cfg.source = (exk_source){.exchange = watch, .ctx = &twin};
    ticks =
        (loop_ticks){.rig = &rig, .clock = {.now_ns = fake_now, .sleep_until_ns = fake_sleep}};
    ticks.publisher = exk_publisher_start(&info, why, sizeof why);
    TEST_ASSERT_NOT_NULL_MESSAGE(ticks.publisher, why);
    loop_ticks_run(&ticks);
    exk_publisher_stop(ticks.publisher, &summary);
}

/* Ticks rise, and each is driven within its own period: never two in one, no burst. */
static void check_no_burst(void)
{
    for (int i = 0; i < seen.n; i++) {
        const int64_t late_ns = seen.t_ns[i] - (seen.k[i] + 1) * PERIOD_NS;
        TEST_ASSERT_TRUE(late_ns >= 0 && late_ns < PERIOD_NS);
        TEST_ASSERT_TRUE(i == 0 || seen.k[i] > seen.k[i - 1]);
    }
}

static void on_time_nothing_is_missed(void)
{
    run();
    TEST_ASSERT_EQUAL(EXK_STATE_DONE, rig.loop.sm.state);
    TEST_ASSERT_EQUAL_INT64(rig.plan.n_ticks, seen.n);
    TEST_ASSERT_EQUAL_INT64(0, ticks.record.n_overruns);
    check_no_burst();
}

/* Overslept by n ticks and a half: tick 50 is missed; with n = 1 the next is run half a period late, else
 * all up to the first still to come are missed too. From 20 in a row on it is a fault that stays where it
 * is. */
static void late_by_any_number_of_ticks_is_counted_exactly(void)
{
    for (int64_t late = 1; late <= 100; late++) {
        const int64_t missed = late == 1 ? 1 : late + 1;
        tearDown();
        setUp();
        wall.k_trouble = 50;
        wall.late_ns = late * PERIOD_NS + PERIOD_NS / 2;
        run();
        check_no_burst();
        TEST_ASSERT_EQUAL_INT64(missed, ticks.record.n_overruns);
        if (missed < 20) {
            TEST_ASSERT_EQUAL(EXK_STATE_DONE, rig.loop.sm.state);
            TEST_ASSERT_EQUAL_INT64(rig.plan.n_ticks - missed, seen.n);
            continue;
        }
        TEST_ASSERT_EQUAL(EXK_STATE_FAULT, rig.loop.sm.state);
        TEST_ASSERT_EQUAL(EXK_CAUSE_OVERRUN, rig.loop.report.cause);
        TEST_ASSERT_EQUAL(EXK_ERR_OVERRUN, rig.loop.fault);
        TEST_ASSERT_EQUAL_DOUBLE((double)missed, rig.loop.report.what.value);
        TEST_ASSERT_EQUAL_DOUBLE(20.0, rig.loop.report.what.limit);
        TEST_ASSERT_EQUAL_INT(50, seen.n); /* nothing was driven after it */
    }
}

static void a_clock_that_runs_backwards_only_waits(void)
{
    wall.k_trouble = 50;
    wall.late_ns = -30 * PERIOD_NS;
    run();
    TEST_ASSERT_EQUAL_INT64(0, ticks.record.n_overruns);
    TEST_ASSERT_EQUAL(EXK_STATE_DONE, rig.loop.sm.state);
    TEST_ASSERT_EQUAL_INT64(rig.plan.n_ticks, seen.n);
    for (int i = 1; i < seen.n; i++) {
        TEST_ASSERT_TRUE(seen.k[i] == seen.k[i - 1] + 1);
    }
}

/* No tick is run on a clock that does not get there, let alone many at once. */
static void a_clock_that_stands_stops_the_run(void)
{
    wall.k_trouble = 50;
    wall.stands = true;
    run();
    TEST_ASSERT_EQUAL(EXK_STATE_FAULT, rig.loop.sm.state);
    TEST_ASSERT_EQUAL(EXK_CAUSE_OVERRUN, rig.loop.report.cause);
    TEST_ASSERT_EQUAL(EXK_QUANTITY_CLOCK, rig.loop.report.what.quantity);
    TEST_ASSERT_EQUAL_INT(50, seen.n);
    check_no_burst();
}

/* Every wait too long, and however many missed ticks the profile allows: it ends. (Too long by one tick, every
 * other tick is run.) */
static void waits_that_are_always_too_long_stop_the_run(void)
{
    for (int64_t late = 2; late <= 100; late++) {
        for (int many = 0; many < 2; many++) {
            tearDown();
            setUp();
            rig.profile.timing.n_missed_max = many ? 1000000 : 20;
            wall.k_trouble = 50;
            wall.keeps = true;
            wall.late_ns = late * PERIOD_NS;
            run();
            TEST_ASSERT_EQUAL(EXK_STATE_FAULT, rig.loop.sm.state);
            TEST_ASSERT_EQUAL(EXK_CAUSE_OVERRUN, rig.loop.report.cause);
            TEST_ASSERT_EQUAL(many ? EXK_QUANTITY_CLOCK : EXK_QUANTITY_DEADLINES,
                              rig.loop.report.what.quantity);
            TEST_ASSERT_EQUAL_INT(50, seen.n);
            check_no_burst();
        }
    }
}

/* A clock that stops while the tool backs out of the part: no rush of ticks to its end. */
static void a_clock_that_stands_stops_the_way_out(void)
{
    rig.profile.inject.n_faults = 1;
    rig.profile.inject.fault[0] = exk_inject_default();
    rig.profile.inject.fault[0].kind = EXK_INJECT_DROPOUT;
    rig.profile.inject.fault[0].at_s = 0.05;
    rig.profile.inject.fault[0].for_s = 1.0;
    wall.k_trouble = 50 + 20 + 10; /* 10 ticks into slowing down */
    wall.stands = true;
    run();
    TEST_ASSERT_EQUAL(EXK_CAUSE_SENSOR, rig.loop.report.cause);
    TEST_ASSERT_EQUAL_INT(80, seen.n);
    TEST_ASSERT_TRUE(exk_loop_is_over(&rig.loop));
    check_no_burst();
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(on_time_nothing_is_missed);
    RUN_TEST(late_by_any_number_of_ticks_is_counted_exactly);
    RUN_TEST(a_clock_that_runs_backwards_only_waits);
    RUN_TEST(a_clock_that_stands_stops_the_run);
    RUN_TEST(waits_that_are_always_too_long_stop_the_run);
    RUN_TEST(a_clock_that_stands_stops_the_way_out);
    return UNITY_END();
}
