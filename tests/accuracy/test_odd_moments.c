/* Commands at any moment, faults that overlap, missed ticks: whatever comes together, nothing that is not finite
 * comes out, no command passes a limit, and clear and start always lead to the end of the job.
 * EXK_LONG=1: ten times as many runs. */
#include <stdio.h>
#include <stdlib.h>

#include "faulty_rig.h"

enum { RUNS = 600, TICKS = 4000, TICKS_TO_END = 6000, N_FAULTS = 4 };

static faulty_rig rig;
static exk_sample before;
static uint64_t run_seed;
static int64_t n_drawn;

void setUp(void)
{
    faulty_set_up(&rig, 2, 2, 0.002, 0.005);
}

void tearDown(void)
{
}

static uint32_t any_below(uint32_t n)
{
    const exk_stream stream = {.seed = run_seed, .source = 78};
    uint32_t word[4];
    exk_random_block(&stream, n_drawn++, word);
    return word[0] % n;
}

static void draw_faults(exk_inject_config *out)
{
    *out = (exk_inject_config){.n_faults = any_below(N_FAULTS)};
    for (size_t i = 0; i < out->n_faults; i++) {
        exk_inject_fault *f = &out->fault[i];
        *f = exk_inject_default();
        f->kind = (exk_inject_kind)any_below(EXK_INJECT_COUNT);
        f->channel[any_below(2)] = any_below(2) == 0;
        f->at_s = 1e-3 * any_below(2000);
        f->for_s = 1e-3 * any_below(60);
        f->size_rad = any_below(3) == 0 ? 1e-4 : f->size_rad;
        f->delay_s = 1e-3 * any_below(255);
    }
}

/* While nothing was sent yet there is no command to look at. */
static void check(const exk_sample *now)
{
    const exk_limits_config *c = &rig.cfg.limits;
    const double slack_s = (double)(now->k - before.k) * rig.plan.cfg.dt_s * (1.0 + 1e-9);
    const bool had = before.legs_m[0] > 0.0;
    TEST_ASSERT_TRUE(faulty_is_finite(now));
    for (int i = 0; i < EXK_N_AXES; i++) {
        TEST_ASSERT_TRUE(fabs(now->q_rad[i]) <= c->angle_max_rad);
        TEST_ASSERT_TRUE(fabs(now->q_rad[i] - now->r_rad[i]) <= c->correction_max_rad + 1e-12);
        TEST_ASSERT_TRUE(!had ||
                         fabs(now->q_rad[i] - before.q_rad[i]) <= c->rate_max_radps * slack_s);
    }
    for (int i = 0; i < EXK_N_LEGS && now->legs_m[0] > 0.0; i++) {
        TEST_ASSERT_TRUE(now->legs_m[i] >= c->leg_min_m && now->legs_m[i] <= c->leg_max_m);
        TEST_ASSERT_TRUE(!had || fabs(now->legs_m[i] - before.legs_m[i]) <=
                                     c->leg_speed_max_mps * slack_s);
    }
    before = *now;
}

static void step(int64_t k)
{
    exk_sample now;
    exk_loop_step(&rig.loop, k, &now);
    TEST_ASSERT_EQUAL_INT64(k, now.k);
    check(&now);
}

static int64_t go_wild(void)
{
    static const exk_cause causes[] = {EXK_CAUSE_START, EXK_CAUSE_STOP, EXK_CAUSE_ABORT,
                                       EXK_CAUSE_CLEAR, EXK_CAUSE_TIMEOUT};
    const uint32_t rare = 2 + any_below(200);
    int64_t k = 0;
    while (k < TICKS && rig.loop.sm.state != EXK_STATE_DONE) {
        if (any_below(rare) == 0) {
            exk_loop_request(&rig.loop, causes[any_below(5)], k);
        }
        step(k);
        k += any_below(50) == 0 ? 1 + any_below(19) : 1; /* ticks are missed */
    }
    return k;
}

/* What an operator would do: clear what has come to rest, then start. */
static void bring_to_the_end(int64_t k)
{
    for (int64_t i = 0; i < TICKS_TO_END && rig.loop.sm.state != EXK_STATE_DONE; i++) {
        if (rig.loop.sm.state == EXK_STATE_FAULT && exk_loop_is_over(&rig.loop)) {
            TEST_ASSERT_TRUE(exk_loop_request(&rig.loop, EXK_CAUSE_CLEAR, k + i));
        }
        if (rig.loop.sm.state == EXK_STATE_IDLE || rig.loop.sm.state == EXK_STATE_HOLD) {
            TEST_ASSERT_TRUE(exk_loop_request(&rig.loop, EXK_CAUSE_START, k + i));
        }
        step(k + i);
    }
    TEST_ASSERT_EQUAL_STRING("done", exk_state_name(rig.loop.sm.state));
}

static void nothing_hangs_and_nothing_escapes(void)
{
    const uint64_t n_runs = getenv("EXK_LONG") != NULL ? 10 * RUNS : RUNS;
    int64_t n_taken = 0;
    for (run_seed = 1; run_seed <= n_runs; run_seed++) {
        exk_inject_config faults;
        n_drawn = 0;
        draw_faults(&faults);
        faulty_start(&rig, run_seed, &faults);
        rig.loop.cfg.waits = any_below(2) == 0;
        before = (exk_sample){.k = -1};
        bring_to_the_end(go_wild());
        n_taken += rig.loop.sm.n_taken;
    }
    printf("%lld runs, %lld transitions, each run brought to its end\n", (long long)n_runs,
           (long long)n_taken);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(nothing_hangs_and_nothing_escapes);
    return UNITY_END();
}
