#include <string.h>

#include "check_parts.h"
#include "value.h"

/* Says what is wrong with one amplitude key that was given; wanted is the one that fits. */
static void say_amplitude(exk_profile_reader *r, int instance, const exk_key *key,
                          const char *wanted)
{
    const exk_disturbance_config *d = &r->profile.twin.disturbance[instance];
    const int line = exk_line_of_key(r, EXK_IN_DISTURBANCE, instance, key->name);
    if (wanted == NULL) {
        exk_faults_add(&r->faults, line,
                       "[disturbance.%d] %s: wave = none takes none; remove it", instance + 1,
                       key->name);
    } else {
        exk_faults_add(&r->faults, line,
                       "[disturbance.%d] %s: does not fit wave = %s with order = %d; write %s",
                       instance + 1, key->name, exk_wave_name(d->wave), d->order, wanted);
    }
}

static bool check_amplitudes(exk_profile_reader *r, int instance, const char *wanted)
{
    bool good = true;
    for (size_t i = 0; i < exk_key_count(); i++) {
        const exk_key *key = exk_key_at(i);
        const bool fits = wanted != NULL && strcmp(key->name, wanted) == 0;
        if (exk_key_is_amplitude(key) && r->key_line[instance][i] != 0 && !fits) {
            say_amplitude(r, instance, key, wanted);
            good = false;
        }
    }
    return good;
}

static void say_missing_number(exk_profile_reader *r, int instance, const char *name)
{
    const exk_disturbance_config *d = &r->profile.twin.disturbance[instance];
    exk_faults_add(&r->faults, r->section_line[instance][EXK_IN_DISTURBANCE],
                   "[disturbance.%d]: missing key %s; wave = %s with order = %d needs it",
                   instance + 1, name, exk_wave_name(d->wave), d->order);
}

void exk_check_disturbance(exk_profile_reader *r, int instance)
{
    const exk_disturbance_config *d = &r->profile.twin.disturbance[instance];
    const char *wanted = exk_amplitude_name(d->wave, d->order);
    if (check_amplitudes(r, instance, wanted) && wanted != NULL &&
        !exk_check_given(r, EXK_IN_DISTURBANCE, instance, wanted)) {
        say_missing_number(r, instance, wanted);
    }
    if (d->wave == EXK_WAVE_SINE &&
        !exk_check_given(r, EXK_IN_DISTURBANCE, instance, "freq_Hz")) {
        say_missing_number(r, instance, "freq_Hz");
    }
}
