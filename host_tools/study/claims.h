/** Published figures against the simulated distribution of the same statistic.
 *
 *  Predicted  the 95 % interval of the statistic at the study's own sample size: 2.5 and 97.5 % quantiles
 *             over the trials, each of which is one whole study (10 simulations, 24 or 45 holes).
 *  Inside     the published figure, a printed number, stands for its rounding interval (0.07: 0.065
 *             to 0.075); inside when the two intervals meet.
 *  References S10 and S11 are machines that the study measured: the same question, could our model of
 *             the Exechon machine have given their figures?
 *  Units      mm; rates are shares, 0 to 1.
 */
#ifndef STUDY_CLAIMS_H
#define STUDY_CLAIMS_H

#include <stdbool.h>

#include "paper.h"

typedef enum { STUDY_FITTED, STUDY_PREDICTED, STUDY_REFERENCE } study_role;

typedef struct {
    const char *id;
    const char *what;
    double published;
    double half_digit; /* half a unit of its last printed digit */
    int n_published;   /* the study's sample size */
    study_role role;
    study_paper_measure of_mean; /* whose mean is ours */
    study_paper_measure of_interval;
    double scale; /* from the measure to the claim's unit */
} study_claim;

typedef struct {
    double mean;
    exk_interval ci95;
    exk_interval prediction95;
    exk_interval rounded; /* what the published figure stands for */
    bool inside;
} study_verdict;

/** All claims, S5 to S11; *n receives how many. */
const study_claim *study_claims(size_t *n);

/** False where its experiment was left out. */
bool study_was_run(const study_claim *claim, const study_tally *tallies);

study_verdict study_judge(const study_claim *claim, const study_tally *tallies);

const char *study_role_name(study_role role);

#endif
