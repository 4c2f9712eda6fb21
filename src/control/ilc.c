#include "exk/ilc.h"

#include <math.h>
#include <stdbool.h>

#include "exk/units.h"

exk_ilc_config exk_ilc_default(void)
{
    return (exk_ilc_config){.gain = 0.5, .u_max_rad = 0.1, .dt_s = 1e-3};
}

exk_err exk_ilc_check(const exk_ilc_config *cfg)
{
    const double slope = cfg->d_gain_s / cfg->dt_s;
    const bool finite = isfinite(cfg->dt_s) && isfinite(cfg->u_max_rad);
    const bool rate =
        cfg->dt_s > 0.0 && cfg->cutoff_Hz >= 0.0 && cfg->cutoff_Hz * cfg->dt_s < 0.25;
    const bool law = cfg->gain > 0.0 && slope >= 0.0 && cfg->gain + 2.0 * slope < 2.0;
    const bool lead = cfg->lead >= 0 && cfg->lead <= EXK_ILC_LEAD_MAX;
    return finite && rate && law && lead && cfg->u_max_rad > 0.0 ? EXK_OK : EXK_ERR_ARG;
}

static bool overlap(const double *a, const double *b, size_t n)
{
    const uintptr_t a0 = (uintptr_t)a;
    const uintptr_t b0 = (uintptr_t)b;
    return a0 < b0 + n * sizeof *b && b0 < a0 + n * sizeof *a;
}

static double clip(double x, double limit)
{
    const double below = x < limit ? x : limit;
    return below > -limit ? below : -limit;
}

enum {
    BLOCK = 32
}; /* samples of a loop of fixed length: gcc -O2 makes vectors of those only */

/* u_next = clip(u + gain (e + c), limit). Returns 0, or NaN when a value was not finite, in or
 * out: v 0 is 0 for a finite v only. */
static double learn_p(const double *restrict u, const double *restrict e,
                      const double *restrict c, size_t n, double gain, double limit,
                      double *restrict u_next)
{
    double bad[BLOCK] = {0.0};
    size_t k = 0;
    for (; k + BLOCK <= n; k += BLOCK) {
        for (size_t j = 0; j < BLOCK; j++) {
            const double v = u[k + j] + gain * (e[k + j] + c[k + j]);
            bad[j] += v * 0.0;
            u_next[k + j] = clip(v, limit);
        }
    }
    double sum = 0.0;
    for (; k < n; k++) {
        const double v = u[k] + gain * (e[k] + c[k]);
        sum += v * 0.0;
        u_next[k] = clip(v, limit);
    }
    for (size_t j = 0; j < BLOCK; j++) {
        sum += bad[j];
    }
    return sum;
}

/* The whole law of the header before Q, from sample first on; slope = d_gain/dt. */
static double learn_pd(const exk_ilc_config *cfg, const double *u, const double *e,
                       const double *c, size_t first, size_t n, double limit, double *u_next)
{
    const double slope = cfg->d_gain_s / cfg->dt_s;
    const size_t lead = (size_t)cfg->lead;
    double bad = 0.0;
    double x_before = 0.0;
    for (size_t k = first; k < n; k++) {
        const double x = e[k + lead < n ? k + lead : n - 1] + c[k];
        const double change = k > 0 ? x - x_before : 0.0;
        const double v = u[k] + cfg->gain * x + slope * change;
        bad += v * 0.0;
        u_next[k] = clip(v, limit);
        x_before = x;
    }
    return bad;
}

/* P-type: the fast loop as far as e[k + lead] reaches, then the held last sample. */
static double learn_p_lead(const exk_ilc_config *cfg, const double *u, const double *e,
                           const double *c, size_t n, double limit, double *u_next)
{
    const size_t lead = (size_t)cfg->lead;
    const size_t n_reached = lead < n ? n - lead : 0;
    double bad = 0.0;
    if (n_reached > 0) {
        bad = learn_p(u, e + lead, c, n_reached, cfg->gain, limit, u_next);
    }
    return bad + learn_pd(cfg, u, e, c, n_reached, n, limit, u_next);
}

/* Samples of e that no sample of u_next has read. */
static double check_unread(const double *e, size_t n, int lead)
{
    double bad = 0.0;
    for (size_t k = 0; k < n && k < (size_t)lead; k++) {
        bad += e[k] * 0.0;
    }
    return bad;
}

/* Butterworth low-pass of second order as two trapezoidal integrators (bilinear, prewarped) in
 * increments: it keeps its precision at low cutoffs, and its rest state on a constant is the
 * constant itself. */
typedef struct {
    double band_kept, band_gain; /* band' = band_kept band + band_gain high */
    double low_gain;             /* low' = low + band_gain band + low_gain high */
    double band, low;            /* states */
} lowpass;

static lowpass lowpass_init(double cutoff_Hz, double dt_s)
{
    const double g = tan(EXK_PI * cutoff_Hz * dt_s);
    const double a = 1.0 / (1.0 + g * (g + sqrt(2.0)));
    return (lowpass){
        .band_kept = 2.0 * a - 1.0, .band_gain = 2.0 * g * a, .low_gain = 2.0 * g * g * a};
}

static void lowpass_rest(lowpass *q, double x)
{
    q->band = 0.0;
    q->low = x;
}

static double lowpass_step(lowpass *q, double x)
{
    const double high = x - q->low;
    const double change = q->band_gain * q->band + q->low_gain * high;
    const double out = q->low + 0.5 * change;
    q->band = q->band_kept * q->band + q->band_gain * high;
    q->low += change;
    return out;
}

/* Q in place, then the limit. Returns NaN when a value was not finite. */
static double zero_phase(const exk_ilc_config *cfg, double *u, size_t n)
{
    lowpass q = lowpass_init(cfg->cutoff_Hz, cfg->dt_s);
    double bad = 0.0;
    lowpass_rest(&q, u[0]);
    for (size_t k = 0; k < n; k++) {
        u[k] = lowpass_step(&q, u[k]);
    }
    lowpass_rest(&q, u[n - 1]);
    for (size_t k = n; k-- > 0;) {
        const double v = lowpass_step(&q, u[k]);
        bad += v * 0.0;
        u[k] = clip(v, cfg->u_max_rad);
    }
    return bad;
}

exk_err exk_ilc_learn(const exk_ilc_config *cfg, const double *u_rad, const double *e_rad,
                      const double *c_rad, size_t n, double *u_next_rad)
{
    if (n == 0) {
        return EXK_ERR_SIZE;
    }
    if (exk_ilc_check(cfg) != EXK_OK || overlap(u_next_rad, u_rad, n) ||
        overlap(u_next_rad, e_rad, n) || overlap(u_next_rad, c_rad, n)) {
        return EXK_ERR_ARG;
    }
    const bool has_q = cfg->cutoff_Hz > 0.0;
    const double limit = has_q ? INFINITY : cfg->u_max_rad;
    double bad = check_unread(e_rad, n, cfg->lead);
    if (cfg->d_gain_s > 0.0) {
        bad += learn_pd(cfg, u_rad, e_rad, c_rad, 0, n, limit, u_next_rad);
    } else {
        bad += learn_p_lead(cfg, u_rad, e_rad, c_rad, n, limit, u_next_rad);
    }
    if (has_q) {
        bad += zero_phase(cfg, u_next_rad, n);
    }
    return isnan(bad) ? EXK_ERR_ARG : EXK_OK;
}
