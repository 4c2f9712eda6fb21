/** The one table of keys: parser, range checks, --print, job text and manual all read it.
 *
 *  A field lies offset bytes into exk_profile, or into its exk_disturbance_config for the keys of
 *  [disturbance.N], its exk_inject_fault for those of [fault.N]. Bounds are in the unit of the key. Constant data, no state.
 */
#ifndef EXK_CONFIG_KEYS_H
#define EXK_CONFIG_KEYS_H

#include "exk/profile.h"
#include "number.h"

typedef enum {
    EXK_KEY_NUMBER,  /* double */
    EXK_KEY_INTEGER, /* int */
    EXK_KEY_SEED,    /* uint64_t */
    EXK_KEY_WORD,    /* enum: index into words */
    EXK_KEY_FLAG,    /* bool: index into words */
    EXK_KEY_CHANNEL, /* bool[2]: alpha, beta, both */
    EXK_KEY_TEXT     /* char[EXK_PATH_MAX] */
} exk_key_type;

typedef enum {
    EXK_IN_NOTHING, /* before the first section, or in an unknown one */
    EXK_IN_MACHINE,
    EXK_IN_KINEMATICS,
    EXK_IN_JOB,
    EXK_IN_DISTURBANCE,
    EXK_IN_SENSOR,
    EXK_IN_CONTROL,
    EXK_IN_LOOP,
    EXK_IN_GUARD,
    EXK_IN_LIMITS,
    EXK_IN_FAULT,
    EXK_IN_TELEMETRY,
    EXK_IN_COMMAND,
    EXK_IN_COUNT
} exk_section_id;

typedef struct {
    exk_section_id section;
    const char *name;
    exk_key_type type;
    const exk_unit *unit;
    size_t offset;
    double min; /* in the unit of the key */
    double max; /* DBL_MAX: no bound; INFINITY: the word inf is allowed too */
    bool above; /* min itself is not allowed */
    bool required;
    const char *const *words;  /* ends with NULL */
    const char *shown_default; /* for people, where no fixed value is */
    const char *meaning;
} exk_key;

typedef struct {
    const char *name; /* with .N where there may be many */
    bool required;
    const char *meaning;
    const char *stem; /* of the name of one of many, NULL elsewhere */
} exk_section;

enum { EXK_INSTANCES_MAX = 8 }; /* of a section that may be there many times */

enum { EXK_KEYS_MAX = 128 };

size_t exk_key_count(void);
const exk_key *exk_key_at(size_t i);
const exk_section *exk_section_of(exk_section_id id);

/** Index of a key by section and exact name; exk_key_count() when there is none. */
size_t exk_key_find(exk_section_id section, const char *name);

/** Where the keys of a section lie: instance counts from 0. */
const void *exk_key_base(const exk_profile *profile, exk_section_id section, int instance);

/** How many instances of a section a profile has; 1 where there is one only. */
int exk_section_instances(const exk_profile *profile, exk_section_id section);

/** True for the keys of which a disturbance takes exactly one. */
bool exk_key_is_amplitude(const exk_key *key);

/** Name of the amplitude key that fits; NULL for a wave that takes none. */
const char *exk_amplitude_name(exk_wave wave, int order);

#endif
