/* Learning. Any bits in: no run-time error, nothing read or written beside the arrays. Numbers of a machine
 * in: u_next is finite. Lengths around the block of the fast loop, leads up to beyond the length. */
#include "exk/ilc.h"
#include "any.h"

enum { N = 34 };

static double u[N], e[N], c[N], next[N];

static const size_t lengths[] = {0, 1, 32, 33, N};
static const int leads[] = {-1, 0, 4, N, EXK_ILC_LEAD_MAX + 1};

static void learn_any(size_t n, int lead)
{
    const exk_ilc_config cfg = {.gain = any_bits(),
                                .d_gain_s = any_bits(),
                                .lead = lead,
                                .cutoff_Hz = any_bits(),
                                .u_max_rad = any_bits(),
                                .dt_s = any_bits()};
    (void)exk_ilc_learn(&cfg, u, e, c, n, next);
    (void)exk_ilc_at(next, n, exk_any_tick);
}

static void learn_real(size_t n, int lead)
{
    const exk_ilc_config cfg = {.gain = any_in(0.0, 2.0),
                                .d_gain_s = any_in(0.0, 1e-3),
                                .lead = lead,
                                .cutoff_Hz = any_in(0.0, 249.0),
                                .u_max_rad = any_in(1e-6, 1.0),
                                .dt_s = 1e-3};
    if (exk_ilc_learn(&cfg, u, e, c, n, next) != EXK_OK) {
        return;
    }
    for (size_t i = 0; i < n; i++) {
        /*@ assert finite: \is_finite(next[i]); */
    }
}

static void each_case(void (*learn)(size_t n, int lead))
{
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        for (size_t j = 0; j < sizeof leads / sizeof leads[0]; j++) {
            learn(lengths[i], leads[j]);
        }
    }
}

int main(void)
{
    for (int i = 0; i < N; i++) {
        u[i] = any_in(-10.0, 10.0);
        e[i] = any_in(-10.0, 10.0);
        c[i] = any_in(-10.0, 10.0);
    }
    each_case(learn_real);
    for (int i = 0; i < N; i++) {
        u[i] = any_bits();
        e[i] = any_bits();
        c[i] = any_bits();
    }
    each_case(learn_any);
    return 0;
}
