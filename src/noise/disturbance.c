#include "exk/disturbance.h"

#include <math.h>
#include <stddef.h>

#include "exk/units.h"

enum { MAX_ORDER = 2 };

static const double INV_2_ROOT_3 = 0.28867513459481288225; /* 1 / (2 sqrt 3) */

exk_disturbance_config exk_disturbance_default(void)
{
    return (exk_disturbance_config){
        .wave = EXK_WAVE_NONE, .channel = {true, true}, .frozen = true};
}

static bool config_is_good(const exk_disturbance_config *cfg, double dt_s)
{
    const bool kind =
        (unsigned)cfg->wave < EXK_WAVE_COUNT && cfg->order >= 0 && cfg->order <= MAX_ORDER;
    const bool finite =
        isfinite(cfg->amplitude) && isfinite(cfg->freq_Hz) && isfinite(cfg->phase_rad);
    const bool sign =
        cfg->freq_Hz >= 0.0 && (cfg->wave != EXK_WAVE_GAUSSIAN || cfg->amplitude >= 0.0);
    return kind && finite && sign && dt_s > 0.0 && isfinite(dt_s);
}

/* (1 - cos x) / x^2 without cancellation. */
static double one_minus_cos_over_x2(double x)
{
    const double half = 0.5 * x;
    const double sinc = half == 0.0 ? 1.0 : sin(half) / half;
    return 0.5 * sinc * sinc;
}

/* (x - sin x) / x^2; below 1 by its series, whose first term left out is under 1e-16 of it. */
static double x_minus_sin_over_x2(double x)
{
    if (fabs(x) >= 1.0) {
        return (x - sin(x)) / (x * x);
    }
    const double s = x * x;
    double sum = 1.0;
    for (int n = 17; n >= 5; n -= 2) {
        sum = 1.0 - sum * s / (double)(n * (n - 1));
    }
    return sum * x / 6.0;
}

/* Sine from t = 0, with x = 2 pi f t; n and its rate are 0 there:
 *   order 1  A t [sin(phase) sin(x)/x + cos(phase) (1 - cos x)/x]
 *   order 2  A t^2 [sin(phase) (1 - cos x)/x^2 + cos(phase) (x - sin x)/x^2] */
static double sine(const exk_disturbance_config *cfg, double t)
{
    const double x = 2.0 * EXK_PI * cfg->freq_Hz * t;
    const double a = cfg->amplitude;
    if (cfg->order == 0) {
        return a * sin(x + cfg->phase_rad);
    }
    if (cfg->order == 1) {
        const double half = 0.5 * x;
        const double sinc = half == 0.0 ? 1.0 : sin(half) / half;
        return a * t * sinc * sin(half + cfg->phase_rad);
    }
    return a * t * t *
           (sin(cfg->phase_rad) * one_minus_cos_over_x2(x) +
            cos(cfg->phase_rad) * x_minus_sin_over_x2(x));
}

static double constant(const exk_disturbance_config *cfg, double t)
{
    const double power[MAX_ORDER + 1] = {1.0, t, 0.5 * t * t};
    return cfg->amplitude * power[cfg->order];
}

/* Value at the state's tick of whatever needs no history. */
static void evaluate(exk_disturbance *d)
{
    const double t = (double)d->k * d->dt_s;
    const bool white =
        d->cfg.wave == EXK_WAVE_GAUSSIAN; /* of order 0: the others have a history */
    double w = 0.0;
    if (d->cfg.wave == EXK_WAVE_CONSTANT) {
        w = constant(&d->cfg, t);
    } else if (d->cfg.wave == EXK_WAVE_SINE) {
        w = sine(&d->cfg, t);
    }
    for (int i = 0; i < EXK_N_AXES; i++) {
        if (d->cfg.channel[i]) {
            d->n_rad[i] = white ? d->cfg.amplitude * exk_normal(&d->stream[i], d->k) : w;
        }
    }
}

/* n[k+1] = n[k] + s sqrt(dt) z. */
static void walk(exk_disturbance *d, int i, int64_t k)
{
    d->n_rad[i] += d->cfg.amplitude * d->root_dt * exk_normal(&d->stream[i], k);
}

/* Integrated random walk, one step from one pair of draws:
 *   rate += g z0,  n += dt (rate before + g (z0 / 2 + z1 / (2 sqrt 3))),  g = s sqrt(dt),
 * which has the covariance s^2 [dt^3/3, dt^2/2; dt^2/2, dt]. */
static void double_walk(exk_disturbance *d, int i, int64_t k)
{
    const double g = d->cfg.amplitude * d->root_dt;
    double z[2];
    exk_normal_pair(&d->stream[i], k, z);
    d->n_rad[i] += d->dt_s * (d->rate_radps[i] + g * (0.5 * z[0] + INV_2_ROOT_3 * z[1]));
    d->rate_radps[i] += g * z[0];
}

static void integrate(exk_disturbance *d, int64_t k)
{
    for (; d->k < k; d->k++) {
        for (int i = 0; i < EXK_N_AXES; i++) {
            if (!d->cfg.channel[i]) {
                continue;
            }
            if (d->cfg.order == 1) {
                walk(d, i, d->k);
            } else {
                double_walk(d, i, d->k);
            }
        }
    }
}

static bool has_history(const exk_disturbance_config *cfg)
{
    return cfg->wave == EXK_WAVE_GAUSSIAN && cfg->order > 0;
}

exk_err exk_disturbance_init(exk_disturbance *d, const exk_disturbance_config *cfg, double dt_s,
                             exk_realisation which, uint8_t source)
{
    if (!config_is_good(cfg, dt_s)) {
        return EXK_ERR_ARG;
    }
    d->cfg = *cfg;
    d->dt_s = dt_s;
    d->root_dt = sqrt(dt_s);
    for (int i = 0; i < EXK_N_AXES; i++) {
        d->stream[i] = (exk_stream){.seed = which.seed,
                                    .series = which.series,
                                    .run = cfg->frozen ? 0 : which.run,
                                    .source = source,
                                    .channel = (uint8_t)i};
    }
    exk_disturbance_reset(d);
    return EXK_OK;
}

void exk_disturbance_reset(exk_disturbance *d)
{
    d->k = 0;
    for (int i = 0; i < EXK_N_AXES; i++) {
        d->n_rad[i] = 0.0;
        d->rate_radps[i] = 0.0;
    }
    if (!has_history(&d->cfg)) {
        evaluate(d);
    }
}

void exk_disturbance_add(exk_disturbance *d, int64_t k, double out_rad[EXK_N_AXES])
{
    if (k > d->k && has_history(&d->cfg)) {
        integrate(d, k);
    } else if (k > d->k) {
        d->k = k;
        evaluate(d);
    }
    for (int i = 0; i < EXK_N_AXES; i++) {
        out_rad[i] += d->n_rad[i];
    }
}

const char *exk_wave_name(exk_wave wave)
{
    static const char *const names[EXK_WAVE_COUNT] = {
        [EXK_WAVE_NONE] = "none",
        [EXK_WAVE_CONSTANT] = "constant",
        [EXK_WAVE_SINE] = "sine",
        [EXK_WAVE_GAUSSIAN] = "gaussian",
    };
    return (unsigned)wave < EXK_WAVE_COUNT ? names[wave] : "unknown";
}
