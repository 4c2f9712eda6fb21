/** Reference trajectory of a drilling job: a pure function of the tick k.
 *
 *  Path    first hole -> ... -> last hole (-> back over the first, when closed). At each hole:
 *          approach along the axis by clearance_m, dwell, drill stroke_m, retract to clearance.
 *          Travel runs between the retracted points. A move of no length takes no tick; a dwell
 *          lasts at least one, so that every hole has its judged sample.
 *  Motion  each straight move of length L starts and ends at rest: trapezoid in speed with the
 *          phase's feed v and accel_mps2 a,
 *            T = L/v + v/a, ramps of v/a each;  L < v^2/a: a triangle, T = 2 sqrt(L/a).
 *          a = INFINITY is allowed: constant speed, no ramp. The tool axis turns with the same
 *          fraction of the way, on the great circle (normalised linear interpolation). A turn
 *          counts as the arc of a 0.5 m arm, so L = max(distance, 0.5 m * angle).
 *  Ticks   each phase lasts a whole number of ticks (rounded up, so no feed or acceleration is
 *          exceeded, but for a fraction of 1e-9 that rounding may cost); sample j = 1 .. n of a
 *          move stands at s(j/n), so the last is its end point exactly. Sample k is at time k*dt_s.
 *  Judged  one sample a hole counts: the last of its dwell, before the stroke.
 *  Units   metres, seconds, base frame.
 *  Errors  check, init: EXK_ERR_ARG (a feed, accel or dt not > 0, a length or dwell negative, any
 *          but accel not finite, an axis that is not of unit length, axes of neighbouring holes
 *          more than 174 degrees apart, a phase of more than 2^31 - 1 ticks); EXK_ERR_SIZE
 *          (segments too few, no hole). at: cannot fail.
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
    double accel_mps2; /* INFINITY: unlimited */
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
    bool turns;   /* the axes of from and to differ */
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
exk_err exk_plan_check(const exk_plan_config *cfg);
size_t exk_plan_segments_needed(size_t n_holes);
exk_err exk_plan_init(exk_plan *plan, const exk_plan_config *cfg, const exk_hole *holes,
                      size_t n_holes, exk_segment *segments, size_t n_segments);

/** Reference at tick k; before 0 the first sample is held, past the end the last. Cannot fail. */
void exk_plan_at(const exk_plan *plan, int64_t k, exk_ref *out);

/** Between tick k and the next, fraction in [0, 1) of the way: for a plan that is slowed down. A
 *  fraction of 0 is tick k itself, bit for bit; judged is that of tick k. */
void exk_plan_between(const exk_plan *plan, int64_t k, double fraction, exk_ref *out);

/** Tool at step 1 .. n_ticks of a segment; its end from there on. */
void exk_segment_at(const exk_segment *segment, int64_t step, exk_tool *out);

/** The way from where the tool is at tick k straight back to the clearance of its hole, at retract feed
 *  and acceleration; out->n_ticks is 0 while travelling, or when it is there already.
 *  EXK_ERR_ARG when it takes more ticks than a phase may. */
exk_err exk_plan_retract(const exk_plan *plan, int64_t k, exk_segment *out);

/** The tick after which the plan goes on once that way was gone: the hole is begun anew, or left when it
 *  was being retracted from. While travelling: k. -1: the plan begins anew. */
int64_t exk_plan_resume(const exk_plan *plan, int64_t k);

const char *exk_phase_name(exk_phase phase); /* never NULL */

#endif
