/** Reference trajectory of a drilling job: a pure function of the tick k.
 *
 *  Path    first hole -> ... -> last hole (-> back over the first, when closed). At each hole:
 *          approach along the axis by clearance_m, dwell, drill stroke_m, retract to clearance.
 *          Travel runs between the retracted points. A phase of no length takes no tick.
 *  Motion  each straight move starts and ends at rest: trapezoid in speed with the phase's feed
 *          and accel_mps2; the tool axis turns with the same fraction of the way.
 *  Ticks   each phase lasts a whole number of ticks (rounded up, so no feed is exceeded); the
 *          last sample of a move is its end point. Sample k is at time k*dt_s.
 *  Judged  one sample a hole counts: the last of its dwell, before the stroke.
 *  Units   metres, seconds, base frame.
 *  Errors  init: EXK_ERR_ARG (a feed, accel or dt not > 0, a length or dwell negative, or any not
 *          finite, an axis that is not of unit length), EXK_ERR_SIZE (segments too few, no hole).
 *  Memory  the caller lends holes and segments and keeps both alive; init fills segments.
 */
#ifndef EXK_PLAN_H
#define EXK_PLAN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/axes.h"
#include "exk/err.h"
#include "exk/hole.h"

typedef enum {
    EXK_PHASE_TRAVEL,
    EXK_PHASE_APPROACH,
    EXK_PHASE_DWELL,
    EXK_PHASE_DRILL,
    EXK_PHASE_RETRACT,
    EXK_PHASE_COUNT
} exk_phase;

typedef struct {
    double dt_s;
    double feed_mps; /* travel */
    double approach_mps;
    double drill_mps;
    double retract_mps;
    double accel_mps2;
    double clearance_m;
    double stroke_m;
    double dwell_s;
    bool closed; /* come back over the first hole at the end */
} exk_plan_config;

/** One phase of one hole; filled by exk_plan_init. */
typedef struct {
    int64_t k_begin;
    int64_t n_ticks;
    exk_phase phase;
    int32_t hole; /* index into holes: the hole gone to or worked on */
    double ramp;  /* fraction of the time spent speeding up, 0 to 0.5 */
    exk_tool from;
    exk_tool to;
} exk_segment;

typedef struct {
    exk_plan_config cfg;
    const exk_hole *holes;
    size_t n_holes;
    const exk_segment *segments;
    size_t n_segments;
    int64_t n_ticks; /* samples of a whole run, k = 0 .. n_ticks - 1 */
} exk_plan;

/** The reference at one tick. */
typedef struct {
    exk_tool tool;
    exk_phase phase;
    int32_t hole; /* index in drilling order */
    bool judged;  /* the sample on which this hole is judged */
} exk_ref;

exk_plan_config exk_plan_default(void);
size_t exk_plan_segments_needed(size_t n_holes);
exk_err exk_plan_init(exk_plan *plan, const exk_plan_config *cfg, const exk_hole *holes,
                      size_t n_holes, exk_segment *segments, size_t n_segments);

/** Reference at tick k; before 0 the first sample is held, past the end the last. Cannot fail. */
void exk_plan_at(const exk_plan *plan, int64_t k, exk_ref *out);

const char *exk_phase_name(exk_phase phase); /* never NULL */

#endif
