/** Reading runs back from LCM logs: ours, lcm-logger's, or a replay seen live.
 *
 *  Input    EXK_JOB, EXK_POSE, EXK_HOLE, EXK_STATUS; other channels are skipped and counted.
 *  Gaps     a gap in seq is loss, a gap in k alone is a missed tick or decimation: apart. Repeats
 *           and reordered messages are counted and left out.
 *  Errors   open: a message with file, reason and what to do. A log cut in the middle of a record
 *           yields all whole records and says so (truncated).
 *  Memory   exk_run_log owns growing arrays; exk_run_log_free releases them. Outside the core.
 */
#ifndef EXK_LOG_H
#define EXK_LOG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/accuracy.h"
#include "exk/loop.h"
#include "exk/profile.h"

typedef struct {
    bool has_job;
    char profile_name[EXK_NAME_MAX];
    char *profile_text;
    uint64_t job_hash;
    int64_t run_id;
    uint32_t series;
    uint32_t run;
    double dt_s;
    double tolerance_m;
    int64_t n_ticks; /* of the whole job */
    exk_hole *holes;
    size_t n_holes;
    exk_sample *samples; /* in order of k */
    size_t n_samples;
    size_t capacity;
    int64_t last_seq;
    int64_t n_lost;      /* EXK_POSE: missing seq */
    int64_t n_skipped_k; /* ticks without a sample although seq is whole */
    int64_t n_repeated;  /* seq already seen: left out */
    int64_t n_undecoded; /* a channel of ours that did not decode */
    int64_t n_other;     /* events of other channels or other runs */
    bool truncated;      /* the file ends inside a record */
    bool ended;          /* a DONE or FAULT status was seen */
} exk_run_log;

void exk_run_log_init(exk_run_log *log);
void exk_run_log_free(exk_run_log *log);

/** Feeds one message, from a file or from the bus. False when memory ran out. */
bool exk_run_log_feed(exk_run_log *log, const char *channel, const void *data, size_t bytes);

/** Reads a whole file. False: nothing usable (cannot open, not an LCM log, no EXK_POSE inside). */
bool exk_run_log_read(exk_run_log *log, const char *path, char *why, size_t why_size);

#endif
