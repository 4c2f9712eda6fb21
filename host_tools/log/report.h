/** What exk-log says in the end: counts of one run, as a table or as JSON. */
#ifndef EXK_LOG_REPORT_H
#define EXK_LOG_REPORT_H

#include <stdio.h>

#include "exk/log.h"
#include "record.h"

typedef struct {
    const exk_run_log *log;
    const char *path;            /* the log written or read */
    const record_result *result; /* NULL: read from a file */
} log_report;

void log_report_print(const log_report *report, FILE *out);

/** Notes on what is unusual, on stderr. */
void log_report_notes(const log_report *report);

/** An exit code as in out_file.h. path "-": standard output. */
int log_report_json(const log_report *report, const char *path, char *why, size_t why_size);

/** Nothing is missing of what was sent since the first sample seen, and there is one. */
bool log_report_whole(const log_report *report);

#endif
