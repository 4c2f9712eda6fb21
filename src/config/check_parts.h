/** The rules of a profile, a file each for those of the machine, the control and the disturbances, and the
 *  words they share. Each adds what it finds to the faults of the reader. */
#ifndef EXK_CONFIG_CHECK_PARTS_H
#define EXK_CONFIG_CHECK_PARTS_H

#include <stdbool.h>

#include "number.h"
#include "read.h"

/* A number for a message, rounded to three places of its unit. */
typedef struct {
    char text[EXK_NUMBER_SIZE];
} exk_shown_number;

exk_shown_number exk_check_show(double value);

/** The line of a key, or of its section where the key is not given. */
int exk_check_line(const exk_profile_reader *r, exk_section_id section, int instance,
                   const char *name);
bool exk_check_given(const exk_profile_reader *r, exk_section_id section, int instance,
                     const char *name);

/** Whether a key was found bad by itself: it has its fault then. */
bool exk_check_refused(const exk_profile_reader *r, exk_section_id section, const char *name);

void exk_check_geometry(exk_profile_reader *r);
void exk_check_feedback(exk_profile_reader *r);
void exk_check_learning(exk_profile_reader *r);
void exk_check_disturbance(exk_profile_reader *r, int instance);

#endif
