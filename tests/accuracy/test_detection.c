/* Detection and false alarms over a thousand seeds of a 25-hole job, on the machine model with sensor noise,
 * quantum, walk, servo lag and PI feedback. One run a seed: first clean, then with one fault at a tick that
 * the seed chooses. Figures go to stdout.
 * EXK_LONG=1: holes 60 mm apart and dwells of 0.2 s instead of 2 mm and 5 ms. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "faulty_rig.h"

enum { SEEDS = 1000, N_SIZES = 6, WITHIN = 5, WARM_UP = 100 };
static const double sizes[N_SIZES] = {6.0,  7.0,  8.0,
                                      10.0, 20.0, 1000.0}; /* sigmas of the innovation */

static faulty_rig rig;
static const exk_inject_config none = {.n_faults = 0};

void setUp(void)
{
    const bool wide = getenv("EXK_LONG") != NULL;
    faulty_set_up(&rig, 5, 5, wide ? 0.06 : 0.002, wide ? 0.2 : 0.005);
}

void tearDown(void)
{
}

/* A tick inside the run, not before the guard has grown up: a pure function of the seed. */
static int64_t tick_of(uint64_t seed)
{
    const exk_stream stream = {.seed = seed, .source = 77};
    uint32_t word[4];
    exk_random_block(&stream, 0, word);
    return WARM_UP + (int64_t)(word[0] % (uint32_t)(rig.plan.n_ticks - WARM_UP - 50));
}

static void clean_samples_are_believed(void)
{
    int64_t n = 0;
    int64_t n_false = 0;
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        exk_sample s;
        faulty_start(&rig, seed, &none);
        for (int64_t k = 0; k < rig.plan.n_ticks; k++) {
            exk_loop_step(&rig.loop, k, &s);
        }
        TEST_ASSERT_EQUAL(EXK_STATE_DONE, rig.loop.sm.state);
        n += rig.plan.n_ticks;
        n_false += rig.loop.n_bad;
    }
    printf("false alarms: %lld in %lld clean samples of %d runs\n", (long long)n_false,
           (long long)n, SEEDS);
    TEST_ASSERT_TRUE(n >= 1000000);
    TEST_ASSERT_TRUE((double)n_false <= 1e-6 * (double)n);
}

/* A fault of n samples: from its begin to the first rejected sample, 1 for the first; 0: none was, of
 * most samples. The run begins WARM_UP ticks before: the ticks skipped are integrated by the twin. */
static int64_t samples_until_seen(uint64_t seed, const exk_inject_fault *fault, int64_t n,
                                  int64_t most)
{
    exk_inject_config cfg = {.n_faults = 1, .fault = {*fault}};
    exk_sample s;
    const int64_t begin = tick_of(seed);
    cfg.fault[0].at_s = (double)begin * rig.plan.cfg.dt_s;
    cfg.fault[0].for_s = (double)n * rig.plan.cfg.dt_s;
    faulty_start(&rig, seed, &cfg);
    for (int64_t k = begin - WARM_UP; k < begin + most; k++) {
        exk_loop_step(&rig.loop, k, &s);
        if (k >= begin && !s.sensor_ok) {
            return k - begin + 1;
        }
    }
    return 0;
}

/* Of spikes of S sigma, those whose noise brings them back inside may pass: the sample after shows the
 * spike as S sqrt(1 + K^2) of the limit's sigmas (guard.h). 0.1 sigma for the quantum, 4 standard errors. */
static double passed_most(double size, double n_sigmas, double more)
{
    const double p = 0.5 * erfc((size * more - n_sigmas - 0.1) / sqrt(2.0));
    return SEEDS * p + 4.0 * sqrt(SEEDS * p * (1.0 - p));
}

/* Spikes of n samples that nobody saw within five, of a thousand. */
static int spikes_missed(double size, int64_t n, int64_t *latest)
{
    int n_missed = 0;
    *latest = 0;
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        exk_inject_fault fault = exk_inject_default();
        fault.kind = EXK_INJECT_SPIKE;
        fault.channel[seed % 2] = false;
        fault.size_rad = (seed % 3 == 0 ? -1.0 : 1.0) * size * sqrt(rig.loop.guard.variance);
        const int64_t seen = samples_until_seen(seed, &fault, n, WITHIN);
        n_missed += seen == 0;
        *latest = seen > *latest ? seen : *latest;
    }
    return n_missed;
}

static void spikes_are_seen_within_five_samples(void)
{
    for (int i = 0; i < N_SIZES; i++) {
        int64_t latest;
        const int n_missed = spikes_missed(sizes[i], 1, &latest);
        const double K = rig.loop.guard.gain;
        printf("spikes of %g sigma: %d of %d not seen, the latest seen in sample %lld\n",
               sizes[i], n_missed, SEEDS, (long long)latest);
        TEST_ASSERT_TRUE((double)n_missed <=
                         passed_most(sizes[i], rig.loop.guard.cfg.n_sigmas, sqrt(1.0 + K * K)));
        TEST_ASSERT_TRUE(sizes[i] < 8.0 || n_missed == 0);
    }
}

/* An offset that stays for five samples looks like a step of the walk but in its first one. */
static void offsets_are_seen_in_their_first_sample(void)
{
    for (int i = 0; i < N_SIZES; i++) {
        int64_t latest;
        const int n_missed = spikes_missed(sizes[i], WITHIN, &latest);
        printf("offsets of %g sigma for %d samples: %d of %d not seen, the latest in sample "
               "%lld\n",
               sizes[i], WITHIN, n_missed, SEEDS, (long long)latest);
        TEST_ASSERT_TRUE((double)n_missed <=
                         passed_most(sizes[i], rig.loop.guard.cfg.n_sigmas, 1.0));
        TEST_ASSERT_TRUE(sizes[i] < 20.0 || n_missed == 0);
    }
}

static void stuck_and_silence_are_seen_within_20_ms(void)
{
    static const exk_inject_kind kinds[] = {EXK_INJECT_STUCK, EXK_INJECT_DROPOUT,
                                            EXK_INJECT_DELAY};
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        int64_t latest = 0;
        for (uint64_t seed = 1; seed <= SEEDS; seed++) {
            exk_inject_fault fault = exk_inject_default();
            fault.kind = kinds[i];
            fault.channel[seed % 2] = false;
            const int64_t seen = samples_until_seen(seed, &fault, 40, 40);
            TEST_ASSERT_TRUE_MESSAGE(seen > 0, exk_inject_name(kinds[i]));
            latest = seen > latest ? seen : latest;
        }
        printf("%s: all of %d seen, the latest in sample %lld\n", exk_inject_name(kinds[i]),
               SEEDS, (long long)latest);
        TEST_ASSERT_TRUE((double)latest * rig.plan.cfg.dt_s <= 0.020);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(clean_samples_are_believed);
    RUN_TEST(spikes_are_seen_within_five_samples);
    RUN_TEST(offsets_are_seen_in_their_first_sample);
    RUN_TEST(stuck_and_silence_are_seen_within_20_ms);
    return UNITY_END();
}
