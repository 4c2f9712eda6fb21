/** Runs the trials of a task in blocks, on threads and, under mpirun, on ranks.
 *
 *  Same     the totals are the fold of the blocks in block order, whoever ran them: the same bytes for
 *           any -j, any number of ranks, any split into parts, interrupted or not.
 *  Kept     with a folder, each finished block is a file in it, written whole (temporary name, fsync,
 *           rename); blocks found there are used, those cut, damaged or of another task are
 *           refused by name and run again.
 *  Stopped  SIGINT or SIGTERM: the blocks under way end where they are, the finished ones are kept in
 *           the folder (keep when none was given), and how to go on is said.
 *  Errors   an exit code; messages on stderr. Progress on stderr, on a terminal only.
 */
#ifndef STUDY_WORK_H
#define STUDY_WORK_H

#include <stdbool.h>
#include <stdint.h>

#include "task.h"

typedef struct {
    uint64_t n_trials; /* a multiple of STUDY_GROUP */
    int n_threads;
    const char *folder;   /* NULL: none */
    const char *keep;     /* where to leave the blocks of a stopped run, NULL: nowhere */
    const char *how_next; /* said with it: the command that goes on */
    bool quiet;           /* no progress */
    bool alone;           /* under MPI: this rank by itself, the others know nothing of it */
} study_work;

enum { STUDY_GROUP = 10 }; /* the study averages over 10 simulations */

/** All trials 0 .. n_trials - 1. Under MPI the totals are on rank 0; the others
 *  return STUDY_NOT_ROOT and have no more to do. */
int study_run(const study_task *task, const study_work *work, study_sums *totals);

/** Trials from .. to - 1 into a part file; from is the start of a block, to the end of one or of
 *  the study. */
int study_run_part(const study_task *task, const study_work *work, uint64_t from, uint64_t to,
                   const char *path);

/** Part files into totals; they must hold each trial from 0 on once. *n_trials: how many. */
int study_merge_parts(const study_task *task, char *const *paths, size_t n_paths,
                      study_sums *totals, uint64_t *n_trials);

#endif
