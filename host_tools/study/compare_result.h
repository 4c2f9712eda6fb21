/** What comes out of a comparison of controllers, cell by cell and as JSON. */
#ifndef STUDY_COMPARE_RESULT_H
#define STUDY_COMPARE_RESULT_H

#include <jansson.h>

#include "compare.h"
#include "work.h"

/** A cell's figures, mm. */
typedef struct {
    double rms;
    double rms_half95; /* root of the mean square, and half its 95 % interval */
    double last_rms;
    double last_mean;
    study_rms floor;
    study_rms theory;
} study_figures;

/** Runs all cells into totals and opens a rig to measure them with; both are the caller's to close,
 *  the rig only when the exit code is 0. */
int study_compare_run(const study_compare *compare, const study_work *work, study_sums *totals,
                      exk_rig *rig);

/** rig: of s5_ilc.ini; the cell is applied to it. */
study_figures study_compare_figures(const study_compare *compare, int i, exk_rig *rig,
                                    const study_tally *tallies);

/** The whole table; the caller's to release. */
json_t *study_compare_json(const study_compare *compare, exk_rig *rig,
                           const study_tally *tallies, uint64_t n_trials);

#endif
