#include <math.h>

#include "exk/guard.h"
#include "exk/units.h"

/* What one disturbance does from one sample to the next: squares of white and walk, and drift; and where
 * it may begin. */
typedef struct {
    double white2;
    double walk2;
    double drift;
    double start;
} steps;

static const double rate_sigmas = 5.0; /* of the drift that an integrated walk reaches */

static void add_gaussian(const exk_disturbance_config *d, double dt_s, double duration_s,
                         steps *out)
{
    const double s2 = d->amplitude * d->amplitude;
    if (d->order == 0) {
        out->white2 += s2;
    } else if (d->order == 1) {
        out->walk2 += s2 * dt_s;
    } else {
        out->walk2 += s2 * dt_s * dt_s * dt_s / 3.0;
        out->drift += rate_sigmas * d->amplitude * sqrt(duration_s) * dt_s;
    }
}

/* Largest slope: order 0 A w, order 1 A, order 2 the rate A/w (1 - cos), at most A T. */
static void add_sine(const exk_disturbance_config *d, double dt_s, double duration_s,
                     steps *out)
{
    const double size = fabs(d->amplitude);
    const double w_radps = 2.0 * EXK_PI * d->freq_Hz;
    const double rate = w_radps * duration_s > 2.0 ? 2.0 * size / w_radps : size * duration_s;
    const double slope[] = {size * w_radps, size, rate};
    out->drift += slope[d->order] * dt_s;
    out->start += d->order == 0 ? size : 0.0;
}

static void add_constant(const exk_disturbance_config *d, double dt_s, double duration_s,
                         steps *out)
{
    const double slope[] = {0.0, 1.0, duration_s};
    out->drift += fabs(d->amplitude) * slope[d->order] * dt_s;
    out->start += d->order == 0 ? fabs(d->amplitude) : 0.0;
}

static void add_steps(const exk_disturbance_config *d, double dt_s, double duration_s,
                      steps *out)
{
    switch (d->wave) {
    case EXK_WAVE_GAUSSIAN:
        add_gaussian(d, dt_s, duration_s, out);
        break;
    case EXK_WAVE_SINE:
        add_sine(d, dt_s, duration_s, out);
        break;
    case EXK_WAVE_CONSTANT:
        add_constant(d, dt_s, duration_s, out);
        break;
    case EXK_WAVE_NONE:
    case EXK_WAVE_COUNT:
        break;
    }
}

void exk_guard_expect(const exk_twin_config *twin, double duration_s, exk_guard_config *cfg)
{
    steps sum = {twin->sensor_sigma_rad * twin->sensor_sigma_rad, 0.0, 0.0, 0.0};
    for (size_t i = 0; i < twin->n_disturbances && i < EXK_MAX_DISTURBANCES; i++) {
        add_steps(&twin->disturbance[i], twin->dt_s, duration_s, &sum);
    }
    cfg->dt_s = twin->dt_s;
    cfg->servo_tau_s = twin->servo_tau_s;
    cfg->white_rad = sqrt(sum.white2);
    cfg->walk_rad = sqrt(sum.walk2);
    cfg->drift_rad = sum.drift;
    cfg->start_rad = sum.start;
    cfg->noise_rad = twin->sensor_sigma_rad;
    cfg->quantum_rad = twin->sensor_quantum_rad;
}
