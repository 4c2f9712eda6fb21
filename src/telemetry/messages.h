/** What the publisher thread says of a run: each message, its seq, and when it is due.
 *
 *  Due      EXK_JOB at begin and every second, EXK_STATUS at status_Hz and on change of state,
 *           EXK_POSE as the control thread numbered it, EXK_HOLE when the judge closes a hole.
 *  Clock    the caller's: record time in a fast run, the monotonic clock otherwise.
 *  Memory   begin allocates, end releases; in between nothing is allocated.
 */
#ifndef EXK_MESSAGES_H
#define EXK_MESSAGES_H

#include "exk/telemetry.h"
#include "exk/wire.h"
#include "outlet.h"

/** One slot of the ring. Numbers of poses are given by the control thread, so that a record the ring
 *  refused leaves a gap. */
typedef struct {
    exk_record record;
    int64_t seq;          /* of this pose, -1: looked at, not sent */
    int64_t previous_k;   /* the pose before was not sent and turned out to matter; -1: no */
    int64_t previous_seq; /* its number */
} exk_slot;

typedef struct {
    exk_outlet out;
    bool fast;
    double dt_s;
    int64_t run_id;
    exk_wire_job job;
    exk_wire_scratch scratch;
    void *job_buffer;
    size_t job_bytes;
    exk_hole_result *results;
    exk_judge judge;
    int64_t status_period_us;
    int64_t next_status_us;
    int64_t next_job_us;
    int64_t n_status;
    int64_t n_jobs;
    int64_t n_holes;
    int64_t n_taken;    /* records */
    int64_t n_poses;    /* sent */
    int64_t n_numbered; /* seq of the next pose, as far as known here */
    exk_record last;    /* newest record */
    bool has_last;
    bool last_sent;
    exk_wire_status status;
    const exk_histogram *lateness;
    const exk_histogram *step_time;
} exk_messages;

bool exk_messages_init(exk_messages *m, const exk_run_info *info, char *why, size_t why_size);
void exk_messages_free(exk_messages *m);

void exk_messages_begin(exk_messages *m);
void exk_messages_take(exk_messages *m, const exk_slot *slot);
/** What the ring has to say of itself. */
typedef struct {
    int64_t n_dropped;
    int64_t deepest;
} exk_ring_figures;

/** What the status messages say of the real-time rights granted. */
void exk_messages_set_rights(exk_messages *m, const char *text);

/** Sends what is due at now_us. */
void exk_messages_tick(exk_messages *m, int64_t now_us, const exk_ring_figures *ring);

/** The last sample (tick last_k), a hole that ends with the run, the last status. n_numbered: poses
 *  numbered in all. */
void exk_messages_end(exk_messages *m, int64_t last_k, int64_t n_numbered,
                      const exk_ring_figures *ring);

#endif
