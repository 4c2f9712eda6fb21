/* A day of machine time, and beyond 2^32 ticks: a run that is held for so long goes on where it was, sample
 * for sample, and no counter, time or limit has wrapped or drifted. The held ticks are jumped, one in a
 * minute, but for the ones round 2^31, 2^32 and the 24 h, which are all run. */
#include <string.h>

#include "faulty_rig.h"

enum { TICKS_MAX = 2048, AT = 123, DENSE = 500 };
static const int64_t day = INT64_C(86400000); /* ticks of 1 ms */
static faulty_rig rig;
static exk_sample clean[TICKS_MAX];
static const exk_inject_config none = {.n_faults = 0};

void setUp(void)
{
    faulty_set_up(&rig, 2, 2, 0.002, 0.005);
    rig.twin_cfg.sensor_sigma_rad = 0.0;
    rig.twin_cfg.n_disturbances = 0;
    faulty_set_loop(&rig);
    rig.cfg.feedback.pid.ki = 0.0; /* lag and quantum leave no trace: only the plan is seen */
    rig.cfg.feedback.pid.kp = 0.0;
    faulty_start(&rig, 1, &none);
    TEST_ASSERT_TRUE(rig.plan.n_ticks <= TICKS_MAX);
    for (int64_t k = 0; k < rig.plan.n_ticks; k++) {
        TEST_ASSERT_EQUAL(EXK_OK, exk_loop_step(&rig.loop, k, &clean[k]));
    }
}

void tearDown(void)
{
}

/* The tick to step next: one minute on, but every tick within DENSE of a mark. */
static int64_t next_tick(int64_t k)
{
    const int64_t marks[] = {day, INT64_C(1) << 31, INT64_C(1) << 32};
    int64_t next = k + 60000;
    for (size_t i = 0; i < sizeof marks / sizeof marks[0]; i++) {
        const int64_t begin = marks[i] - DENSE;
        if (k < begin && next > begin) {
            next = begin;
        } else if (k >= begin && k < marks[i] + DENSE) {
            next = k + 1;
        }
    }
    return next;
}

static void check_sample(const exk_sample *s, int64_t k)
{
    TEST_ASSERT_EQUAL_INT64(k, s->k);
    TEST_ASSERT_EQUAL_INT64(1000 * k, s->time_us);
    TEST_ASSERT_TRUE(s->sensor_ok);
    TEST_ASSERT_TRUE(faulty_is_finite(s));
}

/* From rest the plan's tick j is reached again; every later sample has the clean run's reference. */
static void finish(int64_t k)
{
    exk_sample s;
    TEST_ASSERT_TRUE(exk_loop_request(&rig.loop, EXK_CAUSE_START, k));
    while (rig.loop.sm.state == EXK_STATE_RUN) {
        TEST_ASSERT_EQUAL(EXK_OK, exk_loop_step(&rig.loop, k, &s));
        check_sample(&s, k++);
        if (rig.loop.motion.mode == EXK_MOTION_FOLLOW) {
            const exk_sample *want = &clean[rig.loop.motion.j];
            TEST_ASSERT_EQUAL_DOUBLE_ARRAY(want->q_rad, s.q_rad, EXK_N_AXES);
            TEST_ASSERT_EQUAL_DOUBLE_ARRAY(want->legs_m, s.legs_m, EXK_N_LEGS);
        }
    }
    TEST_ASSERT_EQUAL(EXK_STATE_DONE, rig.loop.sm.state);
    TEST_ASSERT_EQUAL_INT64(k - 1, exk_loop_last_tick(&rig.loop));
}

static void held_for(int64_t n_ticks)
{
    exk_sample s;
    int64_t n_steps = 0;
    int64_t k = 0;
    faulty_start(&rig, 1, &none);
    for (; k < n_ticks; k = k < AT + DENSE ? k + 1 : next_tick(k)) {
        if (k == AT) {
            TEST_ASSERT_TRUE(exk_loop_request(&rig.loop, EXK_CAUSE_STOP, k));
        }
        TEST_ASSERT_EQUAL(EXK_OK, exk_loop_step(&rig.loop, k, &s));
        check_sample(&s, k);
        n_steps++;
    }
    TEST_ASSERT_EQUAL(EXK_MOTION_REST, rig.loop.motion.mode);
    TEST_ASSERT_EQUAL_INT64(s.k - rig.loop.motion.j, exk_motion_held(&rig.loop.motion));
    TEST_ASSERT_EQUAL_INT64(n_steps, rig.loop.guard.n[EXK_SAMPLE_GOOD]);
    finish(k);
    TEST_ASSERT_EQUAL_INT64(0, rig.loop.n_bad);
}

static void a_day_goes_by_without_a_trace(void)
{
    held_for(day + DENSE);
}

static void two_to_the_32_ticks_go_by_without_a_trace(void)
{
    held_for((INT64_C(1) << 32) + DENSE);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_day_goes_by_without_a_trace);
    RUN_TEST(two_to_the_32_ticks_go_by_without_a_trace);
    return UNITY_END();
}
