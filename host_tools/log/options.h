/** Command line of exk-log. */
#ifndef EXK_LOG_OPTIONS_H
#define EXK_LOG_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "plot_list.h"

typedef struct {
    const char *log_path; /* what is recorded; NULL with from */
    const char *from;     /* an existing log, in place of the bus */
    const char *url;      /* NULL: LCM_DEFAULT_URL, then the profile's default */
    double seconds;       /* 0: no bound */
    bool until_done;
    int64_t run_id;        /* 0: the first run seen */
    const char *json_path; /* "-": standard output */
    const char *csv_path;
    exk_plot_list plots;
    bool quiet;
} log_options;

/** Exits with 2 and a message on wrong use. */
void log_options_parse(int argc, char **argv, log_options *out);

#endif
