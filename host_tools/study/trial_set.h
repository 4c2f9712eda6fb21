/** What one worker holds while it runs trials, and the parts of a trial.
 *
 *  Each part runs its experiments for trial i, adds to the tallies and leaves what later parts compare
 *  with in the set. They return 0, or 1 after a message.
 */
#ifndef STUDY_TRIAL_SET_H
#define STUDY_TRIAL_SET_H

#include "paper.h"

/* The path of one run against its reference. */
typedef struct {
    int64_t n_all;
    int64_t n_half[2];
    double sum_sq_m2[2]; /* first and second half */
    int64_t n_first;     /* samples in the first and in the third quadrant */
    int64_t n_third;
    double last_m[2];
} study_path;

typedef struct {
    uint32_t parts; /* which are run, bit by bit */
    study_lab lab[STUDY_N_EXPERIMENTS];
    study_path path;
    double s1_m; /* rms of this trial, noise on both angles */
    double s2_m;
    double s7_m;       /* mean of the holes */
    double s5_group_m; /* sums over the trials of a group */
    double s6_group_m;
    bool edge[STUDY_GRID25];
    bool turn[STUDY_GRID25];
} study_set;

static inline void study_add(study_tally *tallies, int measure, double value)
{
    study_tally_add(&tallies[measure], value);
}

int study_trial_s1(study_set *set, uint32_t trial, study_tally *tallies);
int study_trial_s2(study_set *set, uint32_t trial, study_tally *tallies);
int study_trial_s3(study_set *set, uint32_t trial, study_tally *tallies);
int study_trial_s4(study_set *set, uint32_t trial, study_tally *tallies);

#endif
