#include <string.h>

#include "exk/profile.h"
#include "keys.h"
#include "read.h"
#include "text.h"
#include "value.h"

static const void *field_of(const exk_profile *profile, const exk_key *key, int instance)
{
    return (const char *)exk_key_base(profile, key->section, instance) + key->offset;
}

/* A disturbance shows the one amplitude that fits, and what belongs to a sine with a sine only. */
static bool is_shown_of(const exk_disturbance_config *d, const exk_key *key)
{
    const char *fits = exk_amplitude_name(d->wave, d->order);
    const bool of_sine = key->offset == offsetof(exk_disturbance_config, freq_Hz) ||
                         key->offset == offsetof(exk_disturbance_config, phase_rad);
    if (exk_key_is_amplitude(key)) {
        return fits != NULL && strcmp(key->name, fits) == 0;
    }
    return !of_sine || d->wave == EXK_WAVE_SINE;
}

static bool is_shown(const exk_profile *profile, const exk_key *key, int instance)
{
    if (key->type == EXK_KEY_TEXT) {
        return *(const char *)field_of(profile, key, instance) != '\0';
    }
    return key->section != EXK_IN_DISTURBANCE ||
           is_shown_of(&profile->twin.disturbance[instance], key);
}

static void add_section(const exk_profile *profile, exk_section_id id, int instance,
                        exk_text *out)
{
    char name[EXK_SECTION_SIZE];
    exk_section_label(id, instance, name);
    exk_text_add(out, "%s[%s]\n", out->length > 0 ? "\n" : "", name);
    for (size_t i = 0; i < exk_key_count(); i++) {
        const exk_key *key = exk_key_at(i);
        if (key->section == id && is_shown(profile, key, instance)) {
            exk_text_add(out, "%s = ", key->name);
            exk_value_add(key, field_of(profile, key, instance), out);
            exk_text_add(out, "\n");
        }
    }
}

size_t exk_profile_print(const exk_profile *profile, char *out, size_t size)
{
    exk_text text = exk_text_start(out, size);
    for (int id = EXK_IN_NOTHING + 1; id < EXK_IN_COUNT; id++) {
        const int n = exk_section_instances(profile, (exk_section_id)id);
        for (int i = 0; i < n; i++) {
            add_section(profile, (exk_section_id)id, i, &text);
        }
    }
    return text.length;
}

static void add_hole(const exk_hole *hole, exk_text *out)
{
    char number[EXK_NUMBER_SIZE];
    exk_text_add(out, "hole = %ld", (long)hole->id);
    for (int i = 0; i < 6; i++) {
        const double value = i < 3 ? hole->target_m[i] : hole->axis[i - 3];
        exk_number_write(value, &exk_unit_none, number);
        exk_text_add(out, ", %s", number);
    }
    exk_text_add(out, "\n");
}

/* The holes stand for themselves: where their file lies does not change what was learned. */
size_t exk_profile_job_text(const exk_profile *profile, const exk_hole *holes, size_t n_holes,
                            char *out, size_t size)
{
    exk_profile job = *profile;
    char number[EXK_NUMBER_SIZE];
    exk_text text = exk_text_start(out, size);
    job.job.file[0] = '\0';
    add_section(&job, EXK_IN_MACHINE, 0, &text);
    add_section(&job, EXK_IN_KINEMATICS, 0, &text);
    add_section(&job, EXK_IN_JOB, 0, &text);
    exk_number_write(profile->timing.dt_s, &exk_unit_none, number);
    exk_text_add(&text, "\n[holes]\ndt_s = %s\n", number);
    for (size_t i = 0; i < n_holes; i++) {
        add_hole(&holes[i], &text);
    }
    return text.length;
}
