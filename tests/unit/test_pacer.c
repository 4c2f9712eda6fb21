/* The grid and the miss policy under an injected clock: no wall time here. */
#include "exk/realtime.h"
#include "unity.h"

typedef struct {
    int64_t t_ns;
    int n_sleeps;
    int64_t overslept_ns; /* added to the next sleep */
    bool keeps;           /* and to all after it */
    bool stands;
} fake_clock;

static int64_t fake_now(void *ctx)
{
    return ((fake_clock *)ctx)->t_ns;
}

static void fake_sleep(void *ctx, int64_t t_ns)
{
    fake_clock *clock = ctx;
    clock->n_sleeps++;
    if (clock->stands) {
        return;
    }
    clock->t_ns = t_ns + clock->overslept_ns;
    clock->overslept_ns = clock->keeps ? clock->overslept_ns : 0;
}

enum { PERIOD = 1000 };
static fake_clock wall;
static exk_pacer pacer;

void setUp(void)
{
    wall = (fake_clock){.t_ns = 5000};
    exk_pacer_start(&pacer, (exk_clock){fake_now, fake_sleep, &wall}, PERIOD, 0);
}

void tearDown(void)
{
}

static void ticks_follow_each_other_on_the_grid(void)
{
    for (int64_t k = 0; k < 1000; k++) {
        TEST_ASSERT_EQUAL_INT64(k, exk_pacer_next(&pacer));
        TEST_ASSERT_EQUAL_INT64(6000 + k * PERIOD, wall.t_ns);
        wall.t_ns += 300; /* the step's own time */
    }
    TEST_ASSERT_EQUAL_INT64(0, pacer.n_missed);
}

static void a_step_that_ends_late_in_the_next_period_runs_that_tick_late(void)
{
    exk_pacer_next(&pacer);
    wall.t_ns += 1400; /* 400 ns into tick 1 */
    TEST_ASSERT_EQUAL_INT64(1, exk_pacer_next(&pacer));
    TEST_ASSERT_EQUAL_INT64(400, pacer.lateness_ns);
    TEST_ASSERT_EQUAL_INT64(0, pacer.n_missed);
    TEST_ASSERT_EQUAL_INT64(2, exk_pacer_next(&pacer));
    TEST_ASSERT_EQUAL_INT64(0, pacer.lateness_ns);
}

/* Late by 1 to 100 whole periods and a bit: each counted, one wait, no burst. */
static void whole_periods_gone_by_are_skipped_and_counted(void)
{
    int64_t k = exk_pacer_next(&pacer);
    int64_t n_missed = 0;
    for (int64_t late = 1; late <= 100; late++) {
        const int n_sleeps = wall.n_sleeps;
        wall.t_ns += (late + 1) * PERIOD + 7;
        const int64_t next = exk_pacer_next(&pacer);
        TEST_ASSERT_EQUAL_INT64(k + late + 2, next);
        TEST_ASSERT_EQUAL_INT64(late + 1, pacer.n_missed_row);
        TEST_ASSERT_EQUAL_INT(n_sleeps + 1, wall.n_sleeps);
        TEST_ASSERT_EQUAL_INT64(pacer.t0_ns + next * PERIOD, wall.t_ns);
        n_missed += late + 1;
        TEST_ASSERT_EQUAL_INT64(n_missed, pacer.n_missed);
        k = exk_pacer_next(&pacer);
        TEST_ASSERT_EQUAL_INT64(0, pacer.n_missed_row);
        TEST_ASSERT_EQUAL_INT64(next + 1, k);
    }
}

static void a_clock_that_stands_still_or_runs_back_only_waits(void)
{
    TEST_ASSERT_EQUAL_INT64(0, exk_pacer_next(&pacer));
    TEST_ASSERT_EQUAL_INT64(1, exk_pacer_next(&pacer));
    wall.t_ns -= 50 * PERIOD;
    TEST_ASSERT_EQUAL_INT64(2, exk_pacer_next(&pacer));
    TEST_ASSERT_EQUAL_INT64(pacer.t0_ns + 2 * PERIOD, wall.t_ns);
    TEST_ASSERT_EQUAL_INT64(0, pacer.n_missed);
}

/* Overslept within the period: run late. Beyond it: missed, and the next one that can be met. */
static void a_tick_that_was_overslept_is_missed(void)
{
    exk_pacer_next(&pacer);
    wall.overslept_ns = PERIOD - 1;
    TEST_ASSERT_EQUAL_INT64(1, exk_pacer_next(&pacer));
    TEST_ASSERT_EQUAL_INT64(PERIOD - 1, pacer.lateness_ns);
    TEST_ASSERT_EQUAL_INT64(0, pacer.n_missed);
    wall.overslept_ns = PERIOD;
    TEST_ASSERT_EQUAL_INT64(3, exk_pacer_next(&pacer));
    TEST_ASSERT_EQUAL_INT64(0, pacer.lateness_ns);
    TEST_ASSERT_EQUAL_INT64(1, pacer.n_missed);
    wall.overslept_ns = 7 * PERIOD + 10;
    TEST_ASSERT_EQUAL_INT64(12, exk_pacer_next(&pacer));
    TEST_ASSERT_EQUAL_INT64(1 + 8, pacer.n_missed);
    TEST_ASSERT_EQUAL_INT64(9, pacer.n_missed_row);
    TEST_ASSERT_EQUAL_INT64(0, pacer.lateness_ns);
}

static void a_clock_that_does_not_get_there_is_said_to_stand(void)
{
    exk_pacer_next(&pacer);
    TEST_ASSERT_FALSE(pacer.unmet);
    wall.stands = true;
    exk_pacer_next(&pacer);
    TEST_ASSERT_TRUE(pacer.unmet);
    TEST_ASSERT_EQUAL_INT(1 + EXK_PACER_TRIES, wall.n_sleeps);
    wall.stands = false;
    exk_pacer_next(&pacer);
    TEST_ASSERT_FALSE(pacer.unmet);
}

/* A period that the host's timers cannot keep: every tick tried is overslept. */
static void ticks_that_are_all_overslept_end_the_search(void)
{
    exk_pacer_next(&pacer);
    wall.overslept_ns = 2 * PERIOD + 10;
    wall.keeps = true;
    const int64_t k = exk_pacer_next(&pacer);
    TEST_ASSERT_TRUE(pacer.unmet);
    TEST_ASSERT_EQUAL_INT(1 + EXK_PACER_TRIES, wall.n_sleeps);
    TEST_ASSERT_EQUAL_INT64(1 + 3 * (EXK_PACER_TRIES - 1), k);
    TEST_ASSERT_EQUAL_INT64(k - 1, pacer.n_missed_row);
    wall.overslept_ns = 0;
    exk_pacer_next(&pacer);
    TEST_ASSERT_FALSE(pacer.unmet);
}

/* Slept to the last part, then a clock that no longer moves: the spin comes back. */
static void a_spin_on_a_clock_that_stands_ends(void)
{
    pacer.spin_ns = 100;
    exk_pacer_next(&pacer);
    TEST_ASSERT_TRUE(pacer.unmet);
    TEST_ASSERT_EQUAL_INT64(-100, pacer.lateness_ns);
}

static void years_of_ticks_do_not_wrap(void)
{
    const int64_t k = INT64_C(5000000000);
    pacer.k = k - 1;
    wall.t_ns = pacer.t0_ns + (k - 1) * PERIOD + 10;
    TEST_ASSERT_EQUAL_INT64(k, exk_pacer_next(&pacer));
    TEST_ASSERT_EQUAL_INT64(0, pacer.n_missed);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(ticks_follow_each_other_on_the_grid);
    RUN_TEST(a_step_that_ends_late_in_the_next_period_runs_that_tick_late);
    RUN_TEST(whole_periods_gone_by_are_skipped_and_counted);
    RUN_TEST(a_clock_that_stands_still_or_runs_back_only_waits);
    RUN_TEST(a_tick_that_was_overslept_is_missed);
    RUN_TEST(a_clock_that_does_not_get_there_is_said_to_stand);
    RUN_TEST(ticks_that_are_all_overslept_end_the_search);
    RUN_TEST(a_spin_on_a_clock_that_stands_ends);
    RUN_TEST(years_of_ticks_do_not_wrap);
    return UNITY_END();
}
