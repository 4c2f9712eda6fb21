/** Reading runs back from LCM logs: ours, lcm-logger's, or a replay seen live.
 *
 *  Input    EXK_JOB, EXK_POSE, EXK_HOLE, EXK_STATUS; other channels are skipped and counted.
 *  Run      one run_id: that of the first message, or only_run_id when it was set before. Messages
 *           of other runs are counted (n_other_run) and left out.
 *  Gaps     a gap in seq is loss; a gap in k alone is a missed tick or decimation (every > 1): the
 *           two are counted apart. Poses sent before the first one seen are n_before. When the run's
 *           last status is there, poses lost at the end count too. Repeats and reordered messages
 *           are counted and left out (so what came late stays counted as lost).
 *  Errors   read: a message with file, reason and what to do. A log cut in the middle of a record
 *           yields all whole records and says so (truncated).
 *  Memory   exk_run_log owns growing arrays; exk_run_log_free releases them. With keep_none
 *           the poses go to on_pose alone, so that a run of any length fits. Outside the core.
 */
#ifndef EXK_LOG_H
#define EXK_LOG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/accuracy.h"
#include "exk/loop.h"
#include "exk/profile.h"
#include "exk/wire.h"

/** A pose that counts: of this run, next in seq and k. */
typedef void (*exk_run_pose_fn)(void *ctx, const exk_wire_pose *pose);

typedef struct {
    bool has_job;
    char profile_name[EXK_NAME_MAX];
    char kinematics[EXK_NAME_MAX];
    char controller[EXK_NAME_MAX];
    char *profile_text;
    uint64_t job_hash;
    int64_t run_id;
    uint32_t series;
    uint32_t run;
    uint64_t seed;
    double dt_s;
    double tolerance_m;
    int64_t n_ticks; /* of the whole job */
    int32_t every;   /* every n-th sample was published, 1: all */
    exk_hole *holes;
    size_t n_holes;
    exk_sample *samples; /* in order of k */
    size_t n_samples;
    size_t capacity;
    int64_t n_poses; /* poses that counted, kept or handed over */
    int64_t last_seq;
    int64_t first_k;
    int64_t last_k;
    int64_t n_before;    /* EXK_POSE: sent before the first one seen */
    int64_t n_lost;      /* EXK_POSE: missing seq */
    int64_t n_skipped_k; /* ticks without a sample although seq is whole */
    int64_t n_repeated;  /* seq or k already seen: left out */
    int64_t n_undecoded; /* a channel of ours that did not decode */
    int64_t n_other;     /* events of other channels or other runs */
    int64_t n_other_run; /* of these: of other runs */
    int64_t n_damaged;   /* places of a file that were skipped */
    bool truncated;      /* the file ends inside a record */
    bool ended;          /* a DONE, FAULT or last status was seen */
    bool closed;         /* the last status was seen: nothing follows */

    bool has_run; /* run_id is known */
    bool has_status;
    exk_wire_status status;  /* the newest */
    int64_t only_run_id;     /* set after init: keep this run; 0: the first seen */
    exk_run_pose_fn on_pose; /* set after init: called for every pose that counts, */
    void *ctx;               /* with this; */
    bool keep_none;          /* set after init: do not store samples */
} exk_run_log;

void exk_run_log_init(exk_run_log *log);
void exk_run_log_free(exk_run_log *log);

/** Feeds one message, from a file or from the bus. False when memory ran out. */
bool exk_run_log_feed(exk_run_log *log, const char *channel, const void *data, size_t bytes);

/** Reads a whole file. False: nothing usable (cannot open, not an LCM log, no EXK_POSE inside). */
bool exk_run_log_read(exk_run_log *log, const char *path, char *why, size_t why_size);

#endif
