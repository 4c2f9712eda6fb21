/** Reads an INI text into a profile under construction, line by line through inih.
 *
 *  inih splits lines; the reader lent to it counts them, cuts what would start a continuation line,
 *  knows the section headers (inih does not report them) and sees which line gave no value.
 *  Memory  everything is in the caller's exk_profile_reader; text must outlive it.
 */
#ifndef EXK_CONFIG_READ_H
#define EXK_CONFIG_READ_H

#include "faults.h"
#include "keys.h"

enum { EXK_LINE_START = 48 };

typedef struct {
    exk_profile profile;
    exk_faults faults;
    int key_line[EXK_INSTANCES_MAX][EXK_KEYS_MAX]; /* 0: not given */
    int section_line[EXK_INSTANCES_MAX][EXK_IN_COUNT];
    bool refused[EXK_INSTANCES_MAX][EXK_KEYS_MAX]; /* given, but no good value */
    bool has_unknown[EXK_INSTANCES_MAX];           /* a disturbance with an unknown key */

    const char *next; /* what inih has not seen yet */
    int line;
    bool expects_value;         /* the line must give a key and a value */
    char start[EXK_LINE_START]; /* of the line, for messages */
    exk_section_id section;
    int instance; /* N - 1 of [disturbance.N], else 0 */
    bool skips;   /* inside an unknown section */
} exk_profile_reader;

void exk_read_profile(exk_profile_reader *reading, const char *text);

/** Line of a key; 0 when it was not given. */
int exk_line_of_key(const exk_profile_reader *reading, exk_section_id section, int instance,
                    const char *name);

/** Where a key of a section would be found: base of its offset. */
void *exk_key_field(exk_profile *profile, const exk_key *key, int instance);

/** "job", "disturbance.2" */
enum { EXK_SECTION_SIZE = 24 };
void exk_section_label(exk_section_id section, int instance, char out[EXK_SECTION_SIZE]);

#endif
