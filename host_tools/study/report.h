/** One self-contained HTML page of the study: tables, figures, how to repeat it. */
#ifndef STUDY_REPORT_H
#define STUDY_REPORT_H

#include "result.h"

/** Writes the page to path; an exit code. result is that of study_result. */
int study_report(const study_paper *paper, const study_sums *totals, const json_t *result,
                 const char *path);

#endif
