/* Sensor guard: any configuration of a machine, any bits measured, ticks that jump. Init, and one check from
 * any state that a run can have: no run-time error, a kind of the list; of numbers and infinities
 * measured, an estimate that is finite. */
#include "exk/guard.h"
#include "any.h"

static const int64_t k_max = (int64_t)1 << 60;

static int64_t tick(int64_t least)
{
    const int64_t k = exk_any_tick;
    return k < least ? least : (k > k_max ? k_max : k);
}

/* What the header says of every field, no more: Eva knows ranges, not that P/(P+R) is at most 1. */
static void any_state(exk_guard *g)
{
    g->pole = any_in(0.0, 1.0);
    g->gain = any_in(0.1, 1.0);
    g->variance = any_in(0.0, 10.0);
    g->limit_rad = any_bits();
    g->back_limit_rad = any_bits();
    g->fixed_rad = any_in(0.0, 10.0);
    g->n_stuck = 3 + tick(0);
    g->n_stuck_rest = tick(0);
    g->k = tick(-1);
    g->newest = tick(-1);
    g->starts = any_of(2) != 0;
    for (int i = 0; i < EXK_N_AXES; i++) {
        g->axis[i] = (exk_guard_axis){.expected_rad = any_in(-2.0, 2.0),
                                      .reference_rad = any_in(-2.0, 2.0),
                                      .offset_rad = any_in(-10.0, 10.0),
                                      .before_rad = any_in(-10.0, 10.0),
                                      .last_rad = any_in(-10.0, 10.0),
                                      .raw_rad = any_bits(),
                                      .moved_from = any_in(-2.0, 2.0),
                                      .n_same = tick(0),
                                      .k_news = tick(0),
                                      .n_news = tick(0)};
        g->command_rad[i] = any_in(-2.0, 2.0);
        g->asked_rad[i] = any_in(-2.0, 2.0);
    }
}

/* Noise and quantum on either side of a threshold: Eva cannot know that noise >= quantum otherwise. */
static exk_guard_config any_config(bool noisy)
{
    return (exk_guard_config){.dt_s = any_in(1e-6, 1.0),
                              .angle_max_rad = any_in(1e-3, 2.0),
                              .servo_tau_s = any_in(0.0, 10.0),
                              .white_rad = any_in(0.0, 1.0),
                              .walk_rad = any_in(0.0, 1.0),
                              .drift_rad = any_in(0.0, 1.0),
                              .start_rad = any_bits(),
                              .noise_rad = noisy ? any_in(1e-4, 1.0) : any_in(0.0, 1e-4),
                              .quantum_rad = noisy ? any_in(0.0, 1e-4) : any_in(1e-4, 1.0),
                              .n_sigmas = any_bits(),
                              .stuck_s = any_in(0.0, 1e6)};
}

static exk_sample_kind check(exk_guard *g, double alpha, double beta)
{
    const double r[EXK_N_AXES] = {any_in(-2.0, 2.0), any_in(-2.0, 2.0)};
    const double q[EXK_N_AXES] = {any_in(-2.0, 2.0), any_in(-2.0, 2.0)};
    const exk_reading m = {
        .measured_rad = {alpha, beta}, .fresh = any_of(2) != 0, .age = exk_any_tick};
    const exk_sample_kind kind = exk_guard_check(g, tick(0), r, q, &m);
    /*@ assert kind: 0 <= kind < EXK_SAMPLE_COUNT; */
    return kind;
}

static double measured(void)
{
    const double m = any_in(-1e6, 1e6);
    return any_of(2) != 0 ? m : (any_of(2) != 0 ? INFINITY : -INFINITY);
}

/* Eva 25 takes NaN <= 1 for possible, so what is finite is asked without NaN; tests and fuzzing ask with. */
static void check_both_ways(const exk_guard *start)
{
    exk_guard g = *start;
    (void)check(&g, any_bits(), any_bits());
    g = *start;
    (void)check(&g, measured(), measured());
    for (int i = 0; i < EXK_N_AXES; i++) {
        /*@ assert expected: \is_finite(g.axis[i].expected_rad); */
        /*@ assert offset: \is_finite(g.axis[i].offset_rad); */
    }
}

int main(void)
{
    for (int noisy = 0; noisy < 2; noisy++) {
        const exk_guard_config cfg = any_config(noisy != 0);
        exk_guard g;
        if (exk_guard_init(&g, &cfg) == EXK_OK) {
            any_state(&g);
            check_both_ways(&g);
        }
    }
    return 0;
}
