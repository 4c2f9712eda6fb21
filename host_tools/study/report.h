/** One self-contained HTML page of the study: tables, figures, how to repeat it. */
#ifndef STUDY_REPORT_H
#define STUDY_REPORT_H

#include "result.h"
#include "work.h"

/** What the page shows beyond the study: results of compare and of sensitivity, NULL: left out. */
typedef struct {
    json_t *compare;
    json_t *sensitivity;
} study_also;

/** Reads both from their JSON files, NULL: none; an exit code. Close in any case. */
int study_also_open(study_also *also, const char *compare_path, const char *sensitivity_path);

/** Runs compare here where no file gave it; sensitivity, which takes minutes, stays left out. */
int study_also_run(study_also *also, const char *profiles, const study_work *work);
void study_also_close(study_also *also);

enum { STUDY_ALSO_SEEDS = 200 }; /* of that run */

/** Writes the page to path; an exit code. result is that of study_result. */
int study_report(const study_paper *paper, const study_sums *totals, const json_t *result,
                 const study_also *also, const char *path);

#endif
