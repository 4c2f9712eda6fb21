/** Command line of exk-kin. Wrong use ends the program with 2 and a message. */
#ifndef EXK_KIN_OPTIONS_H
#define EXK_KIN_OPTIONS_H

#include <stdbool.h>

#include "sums.h"

typedef struct {
    kin_direction direction;
    kin_model model;
    bool has_model; /* else the profile's */
    exk_wrist_kind wrist;
    bool has_wrist;      /* else the profile's, else AB */
    const char *profile; /* NULL: the default geometry */
} kin_options;

void kin_options_parse(int argc, char **argv, kin_options *out);

#endif
