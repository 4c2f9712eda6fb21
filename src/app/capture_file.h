/** The samples before a fault, at full rate, as a log of their own beside the record.
 *
 *  Hand-over  the control thread lends the ring at a fault, with the record of that tick, and takes it back
 *             when it was written and the fault was cleared (ticks.h, ring): each fault has its file.
 *  When       where commands are allowed a run outlives its faults: a thread of its own writes while the loop
 *             goes on. Else at the end of the run.
 */
#ifndef EXK_LOOP_CAPTURE_FILE_H
#define EXK_LOOP_CAPTURE_FILE_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>

#include "ticks.h"

/** Seconds that are kept. */
extern const double loop_capture_s;

typedef struct {
    loop_ticks *ticks;
    const exk_run_info *info;
    pthread_t thread;
    bool has_thread;
    atomic_bool stop;
    int n_files;
    bool failed;
} loop_keeper;

/** Both are lent until stop. Nothing is done where nothing is recorded. */
void loop_keeper_start(loop_keeper *keeper, loop_ticks *ticks, const exk_run_info *info);

/** Writes what was not written yet: NAME.fault.lcm beside NAME.lcm, then NAME.fault2.lcm, ... and says so on
 *  stderr. False: one could not be written; the reason was said. */
bool loop_keeper_stop(loop_keeper *keeper);

#endif
