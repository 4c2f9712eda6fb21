/** A line on a terminal while a run lasts, from a thread of its own. */
#ifndef EXK_LOOP_PROGRESS_H
#define EXK_LOOP_PROGRESS_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

typedef struct {
    _Atomic int64_t k; /* written by the control thread */
    _Atomic int64_t n_missed;
    _Atomic int32_t hole; /* index, -1: none */
    int64_t n_ticks;
    int32_t n_holes;
    _Atomic bool stop;
    bool shown;
    pthread_t thread;
} loop_progress;

/** Starts the line when stderr is a terminal and show is true. */
void loop_progress_start(loop_progress *progress, bool show);
void loop_progress_stop(loop_progress *progress);

#endif
