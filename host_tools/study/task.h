/** A task: many independent trials, each putting numbers into the same list of measures.
 *
 *  Trial    number i of a task is series i of the counter-based random numbers, so it gives the same
 *           numbers on any thread, rank or host.
 *  Worker   what one thread needs to run trials (rigs, arrays); made by open, never shared.
 *  Hash     of everything that decides the numbers: profiles, version, list of measures. Blocks of
 *           another hash are not ours.
 *  Errors   open returns an exit code (0, 2, 3) after saying why on stderr; run returns 0, or 1
 *           after saying which trial of what failed.
 */
#ifndef STUDY_TASK_H
#define STUDY_TASK_H

#include <stddef.h>
#include <stdint.h>

#include "tally.h"

enum { STUDY_GOOD, STUDY_MISS, STUDY_INPUT, STUDY_IO };

typedef struct {
    const char *name; /* for messages and progress */
    const study_measure *measures;
    size_t n_measures;
    uint64_t hash;
    const void *setup; /* read by every worker, never written while they run */
    int (*open)(const void *setup, void **worker);
    void (*close)(void *worker);
    int (*run)(void *worker, uint32_t trial, study_tally *tallies);
} study_task;

/** One tally a measure with its bins, on the heap. */
typedef struct {
    study_tally *tallies;
    uint32_t *bins;
    size_t n;
} study_sums;

int study_sums_open(study_sums *sums, const study_measure *measures, size_t n);
void study_sums_close(study_sums *sums);

/** Hash of the measures and further texts, joined. */
uint64_t study_hash(const study_measure *measures, size_t n, const char *text);

#endif
