/** Fitting a number of the profiles to a published figure, on common random numbers. */
#ifndef STUDY_FIT_H
#define STUDY_FIT_H

#include "paper.h"
#include "work.h"

/** The mean that is to come out at target_m by the choice of *sigma, which it is proportional to. */
typedef struct {
    study_part part;
    study_paper_measure measure;
    double target_m;
    double start; /* sigma of the first run */
    double *sigma;
} study_fit;

/** Mean of a measure with the paper's present variant, running that part alone; an exit code. */
int study_mean_of(study_paper *paper, const study_work *work, study_part part,
                  study_paper_measure measure, double *mean);

/** One run at start, one scaling, one run that verifies: its mean in *mean_m. */
int study_fit_scale(study_paper *paper, const study_work *work, const study_fit *fit,
                    double *mean_m);

/** To four significant digits. */
double study_round4(double value);

#endif
