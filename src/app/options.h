/** Command line of exk-loop. */
#ifndef EXK_LOOP_OPTIONS_H
#define EXK_LOOP_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    const char *profile_path;
    const char *record_path; /* NULL: no log file */
    const char *ilc_path;    /* NULL: no stored correction */
    const char *url;         /* NULL: the profile's */
    const char *source;      /* "twin" or "bus"; NULL: the profile's */
    uint32_t run;            /* p = 1, 2, ...; 0: the store's own, or 1 */
    uint32_t series;
    bool fast;
    bool check;
    bool print;
    bool on_bus;  /* --bus: on the bus in --fast as well */
    bool off_bus; /* --no-bus */
    bool quiet;
} loop_options;

/** Exits with 2 on wrong use, with 0 after --help and --version. */
void loop_options_parse(int argc, char **argv, loop_options *out);

#endif
