/** A small made-up run for the telemetry tests: two holes along X, ten ticks a hole.
 *
 *  Ticks    0..4 travel, 5..7 dwell (7 judged), 8..9 drill; then the same for the second hole.
 *  Error    the true tip is off the target by error_m[hole] along X, always.
 */
#ifndef EXK_TELEMETRY_SAMPLES_H
#define EXK_TELEMETRY_SAMPLES_H

#include "exk/telemetry.h"
#include "exk/wire.h"

enum { RUN_HOLES = 2, RUN_TICKS_PER_HOLE = 10, RUN_TICKS = RUN_HOLES * RUN_TICKS_PER_HOLE };

typedef struct {
    exk_profile profile;
    exk_hole holes[RUN_HOLES];
    exk_run_info info;
} made_up_run;

/** Profile, holes and info; no bus, no file, fast. */
void make_run(made_up_run *run);

/** The sample of tick k; NaN nowhere, every field set. */
exk_sample make_sample(const made_up_run *run, int64_t k);
exk_record make_record(const made_up_run *run, int64_t k);

/** An encoded pose of run_id with this seq and k; returns its bytes. */
size_t make_pose(const made_up_run *run, int64_t run_id, int64_t seq, int64_t k, void *buffer);

/** A name in a folder of this process that is removed by clean_up. */
const char *scratch_path(const char *name);
void clean_up(void);

#endif
