/** The study's results as JSON and CSV: what people and the report read.
 *
 *  Bytes    depend on the totals alone: not on time, threads, host names or where files lie.
 *  JSON     noise first, so that an earlier result is known by it; fitted, claims, references, words,
 *           curves (means a run, a hole), statistics (Wilson, Rayleigh, Rician, Ppk, sizes), measures.
 *  Errors   an exit code after a message on stderr.
 */
#ifndef STUDY_RESULT_H
#define STUDY_RESULT_H

#include <jansson.h>

#include "claims.h"
#include "words.h"

/** The fitted numbers as the profiles have them. */
typedef struct {
    const char *name;
    const char *unit;
    const char *to; /* claim */
    double value;
} study_fitted;

enum { STUDY_N_FITTED = 3 };

void study_fitted_of(const exk_profile *profiles, study_fitted fitted[STUDY_N_FITTED]);

/** The whole result; the caller's to release. */
json_t *study_result(const study_paper *paper, const study_sums *totals, uint64_t n_trials);

/** Hole scatter of S9 and what the published figures imply, as JSON; the caller's to release. */
json_t *study_statistics(const study_tally *tallies);

int study_write_json(const json_t *root, const char *path);
int study_write_csv(const study_sums *totals, const study_measure *measures, const char *path);

/** Claims and words as tables on stdout. */
int study_print(const study_sums *totals, uint64_t n_trials, const char *noise);

#endif
