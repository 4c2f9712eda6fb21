#include "fit.h"

#include <stdio.h>
#include <stdlib.h>

double study_round4(double value)
{
    char text[32];
    snprintf(text, sizeof text, "%.4g", value);
    return strtod(text, NULL);
}

int study_mean_of(study_paper *paper, const study_work *work, study_part part,
                  study_paper_measure measure, double *mean)
{
    study_sums totals;
    const uint32_t parts = paper->parts;
    int code = study_sums_open(&totals, paper->measures, STUDY_N_PAPER);
    paper->parts = 1U << part;
    if (code == STUDY_GOOD) {
        code = study_run(&paper->task, work, &totals);
    }
    if (code == STUDY_GOOD) {
        *mean = totals.tallies[measure].moments.mean;
    }
    paper->parts = parts;
    study_sums_close(&totals);
    return code;
}

int study_fit_scale(study_paper *paper, const study_work *work, const study_fit *fit,
                    double *mean_m)
{
    *fit->sigma = fit->start;
    int code = study_mean_of(paper, work, fit->part, fit->measure, mean_m);
    if (code == STUDY_GOOD) {
        *fit->sigma = study_round4(fit->start * fit->target_m / *mean_m);
        code = study_mean_of(paper, work, fit->part, fit->measure, mean_m);
    }
    return code;
}
