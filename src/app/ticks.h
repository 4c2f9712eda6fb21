/** The ticks of one run: fast, paced, and paced with a machine on the bus.
 *
 *  Bus      tick k sends q[k] and, when tick k + 1 begins, takes the answer: the same equations as with
 *           a machine in the process, and one sleep a tick.
 *  Control  everything here runs on the control thread: no allocation, no system call but the sleep.
 */
#ifndef EXK_LOOP_TICKS_H
#define EXK_LOOP_TICKS_H

#include <stdatomic.h>

#include "exk/command.h"
#include "exk/link.h"
#include "exk/realtime.h"
#include "exk/rig.h"
#include "exk/telemetry.h"
#include "progress.h"

/** Who has the capture ring: the loop fills it, a fault lends it to be written, clear takes it back. */
typedef enum { LOOP_RING_FILLS, LOOP_RING_LENT, LOOP_RING_WRITTEN } loop_ring;

typedef struct {
    exk_rig *rig;
    exk_publisher *publisher;
    exk_link *link;   /* NULL: the machine is in the process, or a log */
    exk_inbox *inbox; /* NULL: no commands */
    exk_clock clock;  /* of the ticks; none given: CLOCK_MONOTONIC */
    exk_pacer pacer;
    exk_histogram lateness;
    exk_histogram step_time;
    loop_progress progress;
    exk_record record;
    int64_t k_fault;   /* tick of the fault, -1: none */
    int64_t k_rest;    /* tick on which nothing moved any more, -1: none */
    int64_t k_command; /* tick of the last valid command */
    bool fast;
    _Atomic int ring;        /* loop_ring */
    exk_record fault_record; /* of the tick at which the ring was lent */
} loop_ticks;

/** Runs to the end of the job, a fault that came to rest, or a signal. */
void loop_ticks_run(loop_ticks *t);

#endif
