#include <stdio.h>

#include "report_figures.h"

static const char *const orders[] = {"added to the angle (zero order)",
                                     "integrated once (first order)",
                                     "integrated twice (second order)"};
static const char *const gaussian_units[] = {"rad a sample", "rad/√s", "rad/s^1.5"};
static const char *const units[] = {"rad", "rad/s", "rad/s²"};

static const char *channel_text(const bool channel[EXK_N_AXES])
{
    if (channel[EXK_ALPHA] && channel[EXK_BETA]) {
        return "on both angles";
    }
    return channel[EXK_ALPHA] ? "on α" : "on β";
}

static int describe(const exk_disturbance_config *d, char *out, size_t size)
{
    switch (d->wave) {
    case EXK_WAVE_SINE:
        return snprintf(out, size, "sine of %.4g %s at %g Hz, %s, %s", d->amplitude,
                        units[d->order], d->freq_Hz, orders[d->order],
                        channel_text(d->channel));
    case EXK_WAVE_CONSTANT:
        return snprintf(out, size, "constant %.4g %s, %s, %s", d->amplitude, units[d->order],
                        orders[d->order], channel_text(d->channel));
    case EXK_WAVE_GAUSSIAN:
        return snprintf(out, size, "white Gaussian, σ = %.4g %s, %s, %s", d->amplitude,
                        gaussian_units[d->order], orders[d->order], channel_text(d->channel));
    case EXK_WAVE_NONE:
    case EXK_WAVE_COUNT:
        break;
    }
    return snprintf(out, size, "none");
}

void report_noise_text(const exk_profile *profile, char *out, size_t size)
{
    const exk_twin_config *twin = &profile->twin;
    size_t used = 0;
    snprintf(out, size, "none");
    for (size_t i = 0; i < twin->n_disturbances && used < size; i++) {
        if (i > 0) {
            used += (size_t)snprintf(out + used, size - used, " plus ");
        }
        if (used < size) {
            used += (size_t)describe(&twin->disturbance[i], out + used, size - used);
        }
    }
}
