/** Command line of exk-twin. */
#ifndef EXK_TWIN_OPTIONS_H
#define EXK_TWIN_OPTIONS_H

#include <stdbool.h>

typedef struct {
    const char *profile_path;
    const char *url; /* NULL: the profile's */
    bool once;
    bool quiet;
} twin_options;

/** Exits with 2 on wrong use, with 0 after --help and --version. */
void twin_options_parse(int argc, char **argv, twin_options *out);

#endif
