/** Command line of exk-holes. */
#ifndef EXK_HOLES_OPTIONS_H
#define EXK_HOLES_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>

#include "plot_list.h"

typedef struct {
    const char *log_path; /* NULL when live */
    bool live;
    const char *url;       /* NULL: LCM_DEFAULT_URL, then the profile's default */
    double seconds;        /* 0: until the run is done */
    const char *json_path; /* "-": standard output */
    const char *csv_path;
    exk_plot_list plots;
    double tolerance_m; /* 0: the job's */
    bool report_only;
    bool quiet;
} holes_options;

/** Exits with 2 and a message on wrong use. */
void holes_options_parse(int argc, char **argv, holes_options *out);

#endif
