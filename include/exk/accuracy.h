/** Hole accuracy of a run: which sample counts, how far it is off, how many are inside.
 *
 *  Sample  the last of the dwell, before the stroke: recognised by the phase leaving DWELL, or by
 *          the dwell of another hole, so a missed tick or a decimated log still yields the last
 *          one seen. A hole dwelt on again is judged again: the last stroke counts.
 *  Error   in the plane normal to the hole axis: d = (tip - target) - ((tip - target) . a) a,
 *          radial = |d|, dx and dy its components along e1, e2 of that plane (e1 is X less its
 *          part along a, normalised; e2 = a x e1: for a = Z they are X and Y; an axis within
 *          1 mrad of X takes Y in its place).
 *  Path    the same error of every sample against its reference, axis of the reference.
 *  Inside  radial <= tolerance_m. NaN is outside; it makes mean, max and rms NaN and its hole the
 *          worst, so that it cannot hide behind the others.
 *  Units   metres, radians, base frame; axes are unit vectors.
 *  Errors  init: EXK_ERR_ARG (a pointer missing, tolerance or target not finite, tolerance not
 *          > 0, an axis further than 1e-6 from unit length), EXK_ERR_SIZE (no hole, or more than
 *          an int32_t can index). push, end, summary: cannot fail.
 *  Memory  the caller lends holes and results (one each hole, index = drilling order) and keeps
 *          both until the judge is dropped; init clears the results.
 */
#ifndef EXK_ACCURACY_H
#define EXK_ACCURACY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/axes.h"
#include "exk/err.h"
#include "exk/hole.h"

/** One hole. The figures hold only when drilled; until then they are zero. */
typedef struct {
    bool drilled;
    bool inside;
    int64_t k; /* tick of the sample that counted */
    double tip_m[3];
    double dx_m;
    double dy_m;
    double radial_m;
    double tilt_rad; /* angle between tool axis and hole axis */
} exk_hole_result;

/** What the judge needs of one sample; tip and axis are the true ones where known. */
typedef struct {
    int64_t k;
    bool dwell;
    int32_t hole; /* index in drilling order; outside the list: no hole is judged */
    exk_tool ref;
    exk_tool tool;
} exk_judged_point;

typedef struct {
    const exk_hole *holes;
    size_t n_holes;
    double tolerance_m;
    exk_hole_result *results;
    int32_t open;   /* hole whose dwell is running, -1: none */
    int64_t open_k; /* newest sample of that dwell: what counts if it is the last */
    exk_tool open_tool;
    int64_t n_points;
    double sum_sq_m2;  /* of the radial path error */
    double last_sq_m2; /* of the last sample */
} exk_judge;

/** Figures over the holes drilled so far; mean, max, rms and last point are 0 when there is none. */
typedef struct {
    size_t n_drilled;
    size_t n_inside;
    double mean_m;
    double max_m;
    int32_t worst; /* index of the largest error, -1: none */
    double rms_path_m;
    double last_point_m;
} exk_accuracy;

exk_err exk_judge_init(exk_judge *judge, const exk_hole *holes, size_t n_holes,
                       double tolerance_m, exk_hole_result *results);

/** Returns the index of the hole just completed by this point, or -1. */
int32_t exk_judge_push(exk_judge *judge, const exk_judged_point *point);

/** Closes a dwell still running at the end of a run; returns its index or -1. A run that was cut
 *  in mid-dwell has not drilled that hole: then do not call it. */
int32_t exk_judge_end(exk_judge *judge);

void exk_judge_summary(const exk_judge *judge, exk_accuracy *out);

/** Error of a tip against a target, in the plane normal to axis: d[0] = dx, d[1] = dy. */
void exk_plane_error(const double tip_m[3], const double target_m[3], const double axis[3],
                     double d_m[2]);

#endif
