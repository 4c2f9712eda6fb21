/** Telemetry: samples to the bus and to a log file, from a thread of its own.
 *
 *  Flow     control thread --exk_ring--> publisher thread --LCM--> bus and --record--> log file.
 *  Records  exk_record: the loop's sample with the timing of its tick.
 *  Messages EXK_JOB at start and every second, EXK_POSE every n-th step and every judged sample,
 *           EXK_HOLE when a hole is drilled, EXK_STATUS at status_Hz and on change of state.
 *           run_id and a per-channel seq, counted before the ring, in each.
 *  Fast     virtual: stamps are time_us, wall-clock fields 0, the ring is waited for: same profile
 *           and seed give the same bytes.
 *  Errors   start: false, with a message that says what to do. Later faults (disk full, no route) are
 *           said once, counted, and returned by stop; the control thread is never held up.
 *  Memory   the publisher owns its buffers; everything is allocated by start.
 */
#ifndef EXK_TELEMETRY_H
#define EXK_TELEMETRY_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/accuracy.h"
#include "exk/bus_counts.h"
#include "exk/loop.h"
#include "exk/loop_report.h"
#include "exk/profile.h"
#include "exk/realtime.h"
#include "exk/ring.h"

/** What travels through the ring: one step and how its tick went. */
typedef struct {
    exk_sample sample;
    int64_t lateness_ns; /* wake-up after the tick's own time; 0 in fast mode */
    int64_t step_ns;     /* execution time of the step before; 0 in fast mode */
    int64_t n_overruns;  /* missed ticks so far */
    int64_t n_bad;       /* rejected sensor samples so far */
    int32_t state;       /* exk_state */
    int32_t fault;       /* exk_err, EXK_OK without a fault */
    exk_bus_counts bus;  /* 0 in fast mode */
    exk_loop_report loop;
    exk_transition note[EXK_STATE_NOTES]; /* since the record before: each becomes a status */
    int32_t n_notes;
} exk_record;

/** Fills what the loop knows: n_bad, state, fault, loop, and the notes, which are taken from it. */
void exk_record_loop(exk_record *record, exk_loop *loop);

/** Fixed for a run; the strings are copied by start. */
typedef struct {
    const exk_profile *profile;
    const char
        *profile_text; /* effective profile, carried in EXK_JOB: a log needs nothing else */
    uint64_t job_hash;
    int64_t run_id; /* fast: derived from hash, seed, series and run; else random */
    uint32_t series;
    uint32_t run;
    const exk_hole *holes;
    size_t n_holes;
    int64_t n_ticks;
    int64_t start_utime_us; /* wall clock of tick 0; 0 in fast mode */
    bool fast;
    const char *url;         /* NULL: no bus */
    const char *record_path; /* NULL: no file; refused when it exists and is not an LCM log */
    const exk_histogram *lateness;  /* written by the control thread; NULL in fast mode */
    const exk_histogram *step_time; /* the same */
} exk_run_info;

typedef struct exk_publisher exk_publisher;

/** Starts the thread. On failure returns NULL and why says what failed and what to do. */
exk_publisher *exk_publisher_start(const exk_run_info *info, char *why, size_t why_size);

/** Tells the status messages which real-time rights were granted. Rights are asked after start, so
 *  that the thread is an ordinary one and memory is locked when all of it is there. Once, before
 *  the first push; text of up to 127 characters is copied. */
void exk_publisher_set_rights(exk_publisher *pub, const char *text);

/** Control thread: hands over one record; real time: never waits; fast: waits for room. */
void exk_publisher_push(exk_publisher *pub, const exk_record *record);

typedef struct {
    int64_t n_poses;   /* EXK_POSE messages sent */
    int64_t n_dropped; /* records refused by the ring */
    bool bus_ok;
    bool file_ok;
    exk_accuracy accuracy; /* of this run, judged like exk-holes does */
    char why[512];         /* first fault, empty when none */
} exk_publish_summary;

/** Drains the ring, sends the last status, closes the log (complete), joins the thread. */
void exk_publisher_stop(exk_publisher *pub, exk_publish_summary *out);

#endif
