#include "noise_word.h"

static bool acts(const exk_disturbance_config *d)
{
    return d->wave != EXK_WAVE_NONE && d->amplitude != 0.0 &&
           (d->channel[EXK_ALPHA] || d->channel[EXK_BETA]);
}

const char *exk_noise_word(const exk_profile *profile)
{
    const exk_twin_config *twin = &profile->twin;
    bool frozen = twin->sensor_sigma_rad > 0.0 && twin->sensor_frozen;
    bool fresh = twin->sensor_sigma_rad > 0.0 && !twin->sensor_frozen;
    if (profile->timing.from == EXK_FROM_REPLAY) {
        return "replay";
    }
    for (size_t i = 0; i < twin->n_disturbances; i++) {
        const exk_disturbance_config *d = &twin->disturbance[i];
        const bool repeats = d->wave != EXK_WAVE_GAUSSIAN || d->frozen;
        frozen = frozen || (acts(d) && repeats);
        fresh = fresh || (acts(d) && !repeats);
    }
    if (frozen && fresh) {
        return "mixed";
    }
    return frozen ? "frozen" : (fresh ? "fresh" : "none");
}
