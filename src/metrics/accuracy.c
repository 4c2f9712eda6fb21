#include "exk/accuracy.h"

#include <math.h>
#include <string.h>

#include "exk/vec3.h"

static const double AXIS_LENGTH_SLACK = 1e-6;
static const double ALONG_X_SQ = 1e-6; /* squared sine of 1 mrad */

static bool hole_is_valid(const exk_hole *hole)
{
    return exk_finite3(hole->target_m) &&
           fabs(exk_norm3(hole->axis) - 1.0) <= AXIS_LENGTH_SLACK;
}

exk_err exk_judge_init(exk_judge *judge, const exk_hole *holes, size_t n_holes,
                       double tolerance_m, exk_hole_result *results)
{
    if (judge == NULL || holes == NULL || results == NULL ||
        !(tolerance_m > 0.0 && isfinite(tolerance_m))) {
        return EXK_ERR_ARG;
    }
    if (n_holes == 0 || n_holes > INT32_MAX) {
        return EXK_ERR_SIZE;
    }
    for (size_t i = 0; i < n_holes; i++) {
        if (!hole_is_valid(&holes[i])) {
            return EXK_ERR_ARG;
        }
    }
    memset(results, 0, n_holes * sizeof *results);
    *judge = (exk_judge){.holes = holes,
                         .n_holes = n_holes,
                         .tolerance_m = tolerance_m,
                         .results = results,
                         .open = -1};
    return EXK_OK;
}

/* e1: X less its part along the axis, normalised; Y takes the place of X for an axis along X. */
static void plane_x(const double axis[3], double e1[3])
{
    const double along_x = axis[EXK_X];
    const bool use_y = 1.0 - along_x * along_x < ALONG_X_SQ;
    double seed[3] = {use_y ? 0.0 : 1.0, use_y ? 1.0 : 0.0, 0.0};
    exk_add_scaled3(seed, -exk_dot3(seed, axis), axis, e1);
    const double length = exk_norm3(e1);
    for (int i = 0; i < 3; i++) {
        e1[i] /= length;
    }
}

void exk_plane_error(const double tip_m[3], const double target_m[3], const double axis[3],
                     double d_m[2])
{
    double e1[3];
    double e2[3];
    double off_m[3];
    plane_x(axis, e1);
    exk_cross3(axis, e1, e2);
    exk_add_scaled3(tip_m, -1.0, target_m, off_m);
    d_m[0] = exk_dot3(off_m, e1);
    d_m[1] = exk_dot3(off_m, e2);
}

static double angle_between_rad(const double a[3], const double b[3])
{
    double c[3];
    exk_cross3(a, b, c);
    return atan2(exk_norm3(c), exk_dot3(a, b));
}

static void judge_hole(const exk_judge *judge, const exk_hole *hole, exk_hole_result *result)
{
    double d_m[2];
    exk_plane_error(judge->open_tool.tip_m, hole->target_m, hole->axis, d_m);
    result->drilled = true;
    result->k = judge->open_k;
    exk_copy3(judge->open_tool.tip_m, result->tip_m);
    result->dx_m = d_m[0];
    result->dy_m = d_m[1];
    result->radial_m = sqrt(d_m[0] * d_m[0] + d_m[1] * d_m[1]);
    result->inside = result->radial_m <= judge->tolerance_m; /* false for NaN */
    result->tilt_rad = angle_between_rad(judge->open_tool.axis, hole->axis);
}

/* Squared distance from the line through target along axis: once a sample, so no basis is built. */
static double off_line_sq_m2(const double tip_m[3], const double target_m[3],
                             const double axis[3])
{
    double off_m[3];
    exk_add_scaled3(tip_m, -1.0, target_m, off_m);
    exk_add_scaled3(off_m, -exk_dot3(off_m, axis), axis, off_m);
    return exk_dot3(off_m, off_m);
}

static void count_path(exk_judge *judge, const exk_judged_point *point)
{
    judge->last_sq_m2 = off_line_sq_m2(point->tool.tip_m, point->ref.tip_m, point->ref.axis);
    judge->sum_sq_m2 += judge->last_sq_m2;
    judge->n_points++;
}

int32_t exk_judge_end(exk_judge *judge)
{
    const int32_t done = judge->open;
    if (done >= 0) {
        judge_hole(judge, &judge->holes[done], &judge->results[done]);
    }
    judge->open = -1;
    return done;
}

int32_t exk_judge_push(exk_judge *judge, const exk_judged_point *point)
{
    const bool known = point->hole >= 0 && (size_t)point->hole < judge->n_holes;
    const bool dwell = point->dwell && known;
    int32_t done = -1;
    count_path(judge, point);
    if (!dwell || point->hole != judge->open) {
        done = exk_judge_end(judge);
    }
    if (dwell) {
        judge->results[point->hole].drilled = false; /* until this dwell is closed */
        judge->results[point->hole].inside = false;
        judge->open = point->hole;
        judge->open_k = point->k;
        judge->open_tool = point->tool;
    }
    return done;
}

/* A NaN is larger than any number, and the first one stays. */
static bool is_larger(double error_m, double max_m)
{
    return !isnan(max_m) && !(error_m <= max_m);
}

static void count_hole(exk_accuracy *out, const exk_hole_result *result, int32_t index)
{
    out->n_drilled++;
    out->n_inside += result->inside ? 1 : 0;
    out->mean_m += result->radial_m; /* the sum, until summary divides it */
    if (out->worst < 0 || is_larger(result->radial_m, out->max_m)) {
        out->max_m = result->radial_m;
        out->worst = index;
    }
}

void exk_judge_summary(const exk_judge *judge, exk_accuracy *out)
{
    *out = (exk_accuracy){.worst = -1, .last_point_m = sqrt(judge->last_sq_m2)};
    for (size_t i = 0; i < judge->n_holes; i++) {
        if (judge->results[i].drilled) {
            count_hole(out, &judge->results[i], (int32_t)i);
        }
    }
    if (out->n_drilled > 0) {
        out->mean_m /= (double)out->n_drilled;
    }
    if (judge->n_points > 0) {
        out->rms_path_m = sqrt(judge->sum_sq_m2 / (double)judge->n_points);
    }
}
