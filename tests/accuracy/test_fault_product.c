/* Every kind of fault, on every angle, at every tick of a four-hole job: nothing that is not finite comes
 * out, no command passes a limit, the fault is seen in time, and after a short one the run comes back to
 * the clean one. The limits are computed here again, from the commands alone.
 * EXK_LONG=1: three lengths of burst at every tick instead of one by turns. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "faulty_rig.h"

enum { TICKS_MAX = 2048, TAIL = 130, N_LENGTHS = 3, N_MAX = 20 };
static const int lengths[N_LENGTHS] = {1, 5, 19}; /* bursts shorter than n = 20 */
static const int stuck_most =
    15; /* a clean value may repeat the stuck one: p = 0.035 a sample */
static const double settling_s = 0.1;   /* ten time constants of the PI, ki = 100 /s */
static const double settled_rad = 2e-7; /* below the quantum of the encoder */
static const double stuck_s = 0.020;

static faulty_rig rig;
static exk_sample clean[TICKS_MAX];
static int64_t n_run; /* ticks of one run */
static exk_inject_config faults;

static struct {
    int64_t n_runs;
    int64_t n_steps;
    int64_t n_spoilt;
    int64_t n_late; /* spoilt samples that were not rejected in their own tick */
    double worst_rad;
} figures;

void setUp(void)
{
    const exk_inject_config none = {.n_faults = 0};
    faulty_set_up(&rig, 2, 2, 0.002, 0.005);
    faulty_start(&rig, 1, &none);
    n_run = rig.plan.n_ticks + TAIL;
    TEST_ASSERT_TRUE(n_run <= TICKS_MAX);
    for (int64_t k = 0; k < n_run; k++) {
        TEST_ASSERT_EQUAL(EXK_OK, exk_loop_step(&rig.loop, k, &clean[k]));
        TEST_ASSERT_TRUE(clean[k].sensor_ok);
    }
    memset(&figures, 0, sizeof figures);
}

void tearDown(void)
{
}

static const char *name_of(const exk_inject_fault *f)
{
    static char name[96];
    snprintf(name, sizeof name, "%s on %s at %.3f s for %.3f s", exk_inject_name(f->kind),
             f->channel[0] ? (f->channel[1] ? "both" : "alpha") : "beta", f->at_s, f->for_s);
    return name;
}

static void check_command(const exk_sample *before, const exk_sample *now, const char *name)
{
    const exk_limits_config *c = &rig.cfg.limits;
    const double dt_s = rig.plan.cfg.dt_s;
    const double slack = 1.0 + 1e-9;
    for (int i = 0; i < EXK_N_AXES; i++) {
        TEST_ASSERT_TRUE_MESSAGE(fabs(now->q_rad[i]) <= c->angle_max_rad, name);
        TEST_ASSERT_TRUE_MESSAGE(
            fabs(now->q_rad[i] - now->r_rad[i]) <= c->correction_max_rad * slack, name);
        TEST_ASSERT_TRUE_MESSAGE(before == NULL || fabs(now->q_rad[i] - before->q_rad[i]) <=
                                                       c->rate_max_radps * dt_s * slack,
                                 name);
    }
    for (int i = 0; i < EXK_N_LEGS; i++) {
        TEST_ASSERT_TRUE_MESSAGE(
            now->legs_m[i] >= c->leg_min_m && now->legs_m[i] <= c->leg_max_m, name);
        TEST_ASSERT_TRUE_MESSAGE(before == NULL || fabs(now->legs_m[i] - before->legs_m[i]) <=
                                                       c->leg_speed_max_mps * dt_s * slack,
                                 name);
    }
}

/* Kinds whose every sample must be rejected in its own tick. A spike of 5 mrad is 1000 sigma. */
static bool seen_at_once(exk_inject_kind kind)
{
    return kind != EXK_INJECT_STUCK && kind != EXK_INJECT_GARBAGE;
}

static void check_seen(const exk_inject_fault *f, int64_t k, const exk_sample *s)
{
    const bool spoilt = k >= rig.inject.begin[0] && k < rig.inject.end[0];
    const double since_s = (double)(k - rig.inject.begin[0]) * rig.plan.cfg.dt_s;
    figures.n_spoilt += spoilt;
    figures.n_late += spoilt && s->sensor_ok;
    if (spoilt && seen_at_once(f->kind)) {
        TEST_ASSERT_FALSE_MESSAGE(s->sensor_ok, name_of(f));
    }
    if (spoilt && f->kind == EXK_INJECT_STUCK && since_s >= stuck_s) {
        TEST_ASSERT_FALSE_MESSAGE(s->sensor_ok, name_of(f));
    }
}

static void check_back(const exk_inject_fault *f, int64_t k, const exk_sample *s)
{
    const double since_s = (double)(k - rig.inject.end[0]) * rig.plan.cfg.dt_s;
    for (int i = 0; i < EXK_N_AXES && since_s >= settling_s; i++) {
        const double off_rad = fabs(s->q_rad[i] - clean[k].q_rad[i]);
        figures.worst_rad = fmax(figures.worst_rad, off_rad);
        TEST_ASSERT_TRUE_MESSAGE(off_rad <= settled_rad, name_of(f));
    }
}

static void run_one(const exk_inject_fault *fault)
{
    exk_sample before;
    exk_sample now;
    faults.n_faults = 1;
    faults.fault[0] = *fault;
    faulty_start(&rig, 1, &faults);
    for (int64_t k = 0; k < n_run; k++) {
        exk_loop_step(&rig.loop, k, &now);
        TEST_ASSERT_TRUE_MESSAGE(faulty_is_finite(&now), name_of(fault));
        check_command(k > 0 ? &before : NULL, &now, name_of(fault));
        check_seen(fault, k, &now);
        if (rig.loop.fault == EXK_OK) {
            check_back(fault, k, &now);
        }
        before = now;
    }
    figures.n_runs++;
    figures.n_steps += n_run;
}

static exk_inject_fault fault_of(int kind, int channel, int64_t k, int n_ticks)
{
    exk_inject_fault fault = exk_inject_default();
    fault.kind = (exk_inject_kind)kind;
    fault.channel[EXK_ALPHA] = channel != 1;
    fault.channel[EXK_BETA] = channel != 0;
    fault.at_s = (double)k * rig.plan.cfg.dt_s;
    fault.for_s = n_ticks * rig.plan.cfg.dt_s;
    return fault;
}

static void print_figures(const char *what)
{
    printf("%s: %lld runs, %lld steps, %lld spoilt samples, %lld believed; "
           "farthest from the clean run after settling: %.2g rad\n",
           what, (long long)figures.n_runs, (long long)figures.n_steps,
           (long long)figures.n_spoilt, (long long)figures.n_late, figures.worst_rad);
}

static void short_bursts_at_every_tick_do_no_harm(void)
{
    const bool all = getenv("EXK_LONG") != NULL;
    const char *stride = getenv("EXK_STRIDE"); /* instrumented builds: every n-th tick */
    const int64_t step = stride != NULL && atoi(stride) > 0 ? atoi(stride) : 1;
    for (int64_t k = 0; k < rig.plan.n_ticks; k += step) {
        for (int kind = EXK_INJECT_NAN; kind < EXK_INJECT_COUNT; kind++) {
            for (int channel = 0; channel < 3; channel++) {
                const int first = (int)((k + kind + channel) % N_LENGTHS);
                for (int i = 0; i < (all ? N_LENGTHS : 1); i++) {
                    const int wanted = lengths[(first + i) % N_LENGTHS];
                    const int n =
                        kind == EXK_INJECT_STUCK && wanted > stuck_most ? stuck_most : wanted;
                    const exk_inject_fault fault = fault_of(kind, channel, k, n);
                    run_one(&fault);
                    TEST_ASSERT_EQUAL_MESSAGE(EXK_OK, rig.loop.fault, name_of(&fault));
                    TEST_ASSERT_EQUAL_MESSAGE(EXK_STATE_DONE, rig.loop.sm.state,
                                              name_of(&fault));
                }
            }
        }
    }
    print_figures("bursts of 1, 5, 19");
}

/* What goes on for longer than n samples ends in a fault, the tool out of the part and at rest. */
static void long_faults_end_at_the_clearance(void)
{
    for (int64_t k = 0; k < rig.plan.n_ticks - N_MAX; k += 3) {
        for (int kind = EXK_INJECT_NAN; kind < EXK_INJECT_COUNT; kind++) {
            const exk_inject_fault fault = fault_of(kind, (int)(k % 3), k, 4000);
            const char *name = name_of(&fault);
            run_one(&fault);
            if (kind == EXK_INJECT_GARBAGE || kind == EXK_INJECT_STUCK) {
                continue; /* may be right by chance, or at rest by right */
            }
            TEST_ASSERT_EQUAL_MESSAGE(EXK_STATE_FAULT, rig.loop.sm.state, name);
            TEST_ASSERT_EQUAL_MESSAGE(EXK_ERR_SENSOR, rig.loop.fault, name);
            TEST_ASSERT_EQUAL_INT64_MESSAGE(k + N_MAX - 1, rig.loop.report.k, name);
            TEST_ASSERT_EQUAL_DOUBLE(N_MAX, rig.loop.report.what.value);
            TEST_ASSERT_TRUE_MESSAGE(exk_loop_is_over(&rig.loop), name);
            const exk_hole *hole = &rig.holes[0];
            TEST_ASSERT_DOUBLE_WITHIN(1e-9, hole->target_m[EXK_Z] - 0.0005,
                                      rig.loop.last.ref.tip_m[EXK_Z]);
        }
    }
    print_figures("faults of 4 s");
}

static exk_err broken_exchange(void *ctx, int64_t k, const exk_drive *drive, exk_reading *out)
{
    const int *input = ctx;
    exk_source twin = exk_twin_source(&rig.twin);
    const exk_err err = twin.exchange(twin.ctx, k, drive, out);
    const bool now = k >= 100 && k < 105;
    out->true_rad[*input % 2] = now && *input < 2   ? (double)NAN
                                : now && *input < 4 ? (double)INFINITY
                                                    : out->true_rad[*input % 2];
    out->age = now && *input == 4 ? INT64_MIN : now && *input == 5 ? INT64_MAX : out->age;
    return now && *input == 6 ? EXK_ERR_END : err;
}

/* The other inputs of a step: the truth (for the record only), the age, the source's own failure. */
static void the_other_inputs_do_no_harm(void)
{
    for (int input = 0; input < 7; input++) {
        const exk_inject_config none = {.n_faults = 0};
        exk_sample s;
        exk_sample before;
        faulty_start(&rig, 1, &none);
        rig.loop.cfg.source = (exk_source){.exchange = broken_exchange, .ctx = &input};
        for (int64_t k = 0; k < n_run; k++) {
            exk_loop_step(&rig.loop, k, &s);
            TEST_ASSERT_TRUE(faulty_is_finite(&s));
            check_command(k > 0 ? &before : NULL, &s, "other input");
            before = s;
            if (input < 4) {
                TEST_ASSERT_EQUAL_DOUBLE_ARRAY(clean[k].q_rad, s.q_rad, EXK_N_AXES);
                TEST_ASSERT_EQUAL(k < 100 || k >= 105, s.has_true);
            }
        }
        TEST_ASSERT_EQUAL(input == 6 ? EXK_ERR_END : EXK_OK, rig.loop.fault);
        TEST_ASSERT_EQUAL_INT64(input == 4 || input == 5 ? 5 : 0, rig.loop.n_bad);
    }
}

/* A stored correction that is not finite, or jumps: the command never leaves. */
static void a_bad_store_is_stopped_before_the_command(void)
{
    static double u_rad[EXK_N_AXES][TICKS_MAX];
    const double bad[] = {(double)NAN, (double)INFINITY, 1e300, 0.01, 0.0015};
    const exk_quantity want[] = {EXK_QUANTITY_POSE, EXK_QUANTITY_POSE, EXK_QUANTITY_POSE,
                                 EXK_QUANTITY_CORRECTION, EXK_QUANTITY_RATE};
    const exk_inject_config none = {.n_faults = 0};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        exk_sample s;
        exk_sample before;
        memset(u_rad, 0, sizeof u_rad);
        u_rad[EXK_BETA][77] = bad[i];
        rig.cfg.u_rad[EXK_ALPHA] = u_rad[EXK_ALPHA];
        rig.cfg.u_rad[EXK_BETA] = u_rad[EXK_BETA];
        rig.cfg.n_u = TICKS_MAX;
        faulty_start(&rig, 1, &none);
        for (int64_t k = 0; k < 200; k++) {
            exk_loop_step(&rig.loop, k, &s);
            TEST_ASSERT_TRUE(faulty_is_finite(&s));
            check_command(k > 0 ? &before : NULL, &s, "store");
            before = s;
        }
        TEST_ASSERT_EQUAL(EXK_STATE_FAULT, rig.loop.sm.state);
        TEST_ASSERT_EQUAL(EXK_CAUSE_LIMIT, rig.loop.report.cause);
        TEST_ASSERT_EQUAL_INT64(77, rig.loop.report.k);
        TEST_ASSERT_TRUE(rig.loop.report.what.quantity == want[i] ||
                         rig.loop.report.what.quantity == EXK_QUANTITY_ANGLE);
        TEST_ASSERT_EQUAL_DOUBLE_ARRAY(clean[76].q_rad, s.q_rad, EXK_N_AXES);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(short_bursts_at_every_tick_do_no_harm);
    RUN_TEST(long_faults_end_at_the_clearance);
    RUN_TEST(the_other_inputs_do_no_harm);
    RUN_TEST(a_bad_store_is_stopped_before_the_command);
    return UNITY_END();
}
