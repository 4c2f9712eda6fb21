/** One trial of the study: every experiment of the paper once, its numbers put into the tallies.
 *
 *  The three functions of the paper's task; setup is a study_paper, a worker is on the heap.
 */
#ifndef STUDY_TRIAL_H
#define STUDY_TRIAL_H

#include "paper.h"

int study_trial_open(const void *setup, void **worker);
void study_trial_close(void *worker);
int study_trial_run(void *worker, uint32_t trial, study_tally *tallies);

#endif
