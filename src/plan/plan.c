#include "exk/plan.h"

#include <math.h>

#include "exk/vec3.h"

/* A length that is a whole number of ticks but for rounding must not cost a tick more: the feed may
 * be exceeded by this fraction, no further. */
static const double tick_slack = 1e-9;

/* The tip-to-plate arm that a turn of the axis is timed with: a turn counts as the arc of this arm,
 * so that a move which turns on the spot takes its time too. */
static const double turn_arm_m = 0.5;

static const double unit_tolerance = 1e-9;
static const double ticks_max = 2147483647.0; /* of one phase: 24 days at 1 kHz */

/* Axes further apart than about 174 degrees have no safe way between them. */
static const double opposite_cos = -0.9945;

exk_plan_config exk_plan_default(void)
{
    return (exk_plan_config){
        .dt_s = 0.001,
        .feed_mps = 0.1,
        .approach_mps = 0.02,
        .drill_mps = 0.005,
        .retract_mps = 0.05,
        .accel_mps2 = 1.0,
        .clearance_m = 0.0,
        .stroke_m = 0.0,
        .dwell_s = 0.5,
        .closed = true,
    };
}

size_t exk_plan_segments_needed(size_t n_holes)
{
    return EXK_PHASE_COUNT * n_holes;
}

static bool positive(double value)
{
    return value > 0.0 && isfinite(value);
}

static bool not_negative(double value)
{
    return value >= 0.0 && isfinite(value);
}

exk_err exk_plan_check(const exk_plan_config *cfg)
{
    const bool good = positive(cfg->dt_s) && positive(cfg->feed_mps) &&
                      positive(cfg->approach_mps) && positive(cfg->drill_mps) &&
                      positive(cfg->retract_mps) && cfg->accel_mps2 > 0.0 &&
                      not_negative(cfg->clearance_m) && not_negative(cfg->stroke_m) &&
                      not_negative(cfg->dwell_s);
    return good ? EXK_OK : EXK_ERR_ARG;
}

static exk_err check_hole(const exk_hole *hole)
{
    const bool good = exk_finite3(hole->target_m) && exk_finite3(hole->axis) &&
                      fabs(exk_norm3(hole->axis) - 1.0) <= unit_tolerance;
    return good ? EXK_OK : EXK_ERR_ARG;
}

/* The tool at a hole, depth_m into the part; a negative depth stands clear of it. */
static exk_tool tool_at(const exk_hole *hole, double depth_m)
{
    exk_tool tool;
    exk_add_scaled3(hole->target_m, depth_m, hole->axis, tool.tip_m);
    exk_copy3(hole->axis, tool.axis);
    return tool;
}

static double turn_rad(const double a[3], const double b[3])
{
    double normal[3];
    exk_cross3(a, b, normal);
    return atan2(exk_norm3(normal), exk_dot3(a, b));
}

static double way_m(const exk_tool *from, const exk_tool *to)
{
    double delta[3];
    exk_add_scaled3(to->tip_m, -1.0, from->tip_m, delta);
    return fmax(exk_norm3(delta), turn_arm_m * turn_rad(from->axis, to->axis));
}

static double whole_ticks(double time_s, double dt_s)
{
    return ceil(time_s / dt_s * (1.0 - tick_slack));
}

/* Segments under construction; the first error stays and makes the rest do nothing. */
typedef struct {
    const exk_plan_config *cfg;
    exk_segment *segments;
    size_t n;
    int64_t k;
    exk_err err;
} builder;

static void append(builder *b, exk_segment segment, double n_ticks)
{
    if (!(n_ticks <= ticks_max)) {
        b->err = EXK_ERR_ARG;
    }
    if (b->err != EXK_OK || n_ticks < 1.0) {
        return;
    }
    segment.k_begin = b->k;
    segment.n_ticks = (int64_t)n_ticks;
    segment.turns = segment.from.axis[0] != segment.to.axis[0] ||
                    segment.from.axis[1] != segment.to.axis[1] ||
                    segment.from.axis[2] != segment.to.axis[2];
    b->segments[b->n++] = segment;
    b->k += segment.n_ticks;
}

/* Trapezoid over length L with feed v and acceleration a: T = L/v + v/a, speeding up for v/a; below
 * L = v^2/a a triangle, T = 2 sqrt(L/a). Stretching to whole ticks lowers both speed and slope. */
static void append_move(builder *b, exk_segment segment, double feed_mps)
{
    const double length_m = way_m(&segment.from, &segment.to);
    if (length_m == 0.0) {
        return;
    }
    if (exk_dot3(segment.from.axis, segment.to.axis) < opposite_cos) {
        b->err = EXK_ERR_ARG;
    }
    const double accel_mps2 = b->cfg->accel_mps2;
    const double ramp_s = fmin(feed_mps / accel_mps2, sqrt(length_m / accel_mps2));
    const double speed_mps = fmin(feed_mps, sqrt(length_m * accel_mps2));
    const double time_s = length_m / speed_mps + ramp_s;
    segment.ramp = ramp_s / time_s;
    append(b, segment, whole_ticks(time_s, b->cfg->dt_s));
}

static void append_travel(builder *b, const exk_hole *from, const exk_hole *to, int32_t hole)
{
    const exk_segment segment = {
        .phase = EXK_PHASE_TRAVEL,
        .hole = hole,
        .from = tool_at(from, -b->cfg->clearance_m),
        .to = tool_at(to, -b->cfg->clearance_m),
    };
    append_move(b, segment, b->cfg->feed_mps);
}

static void append_stroke(builder *b, const exk_hole *at, exk_segment segment, double from_m,
                          double to_m, double feed_mps)
{
    segment.from = tool_at(at, from_m);
    segment.to = tool_at(at, to_m);
    append_move(b, segment, feed_mps);
}

static void append_dwell(builder *b, const exk_hole *at, exk_segment segment)
{
    segment.from = tool_at(at, 0.0);
    segment.to = segment.from;
    append(b, segment, fmax(1.0, whole_ticks(b->cfg->dwell_s, b->cfg->dt_s)));
}

static void append_hole(builder *b, const exk_hole *at, int32_t hole)
{
    const exk_plan_config *cfg = b->cfg;
    const exk_segment approach = {.phase = EXK_PHASE_APPROACH, .hole = hole};
    const exk_segment dwell = {.phase = EXK_PHASE_DWELL, .hole = hole};
    const exk_segment drill = {.phase = EXK_PHASE_DRILL, .hole = hole};
    const exk_segment retract = {.phase = EXK_PHASE_RETRACT, .hole = hole};
    append_stroke(b, at, approach, -cfg->clearance_m, 0.0, cfg->approach_mps);
    append_dwell(b, at, dwell);
    append_stroke(b, at, drill, 0.0, cfg->stroke_m, cfg->drill_mps);
    append_stroke(b, at, retract, cfg->stroke_m, -cfg->clearance_m, cfg->retract_mps);
}

exk_err exk_plan_init(exk_plan *plan, const exk_plan_config *cfg, const exk_hole *holes,
                      size_t n_holes, exk_segment *segments, size_t n_segments)
{
    builder b = {.cfg = cfg, .segments = segments, .err = exk_plan_check(cfg)};
    if (n_holes == 0 || n_holes > INT32_MAX || n_segments < exk_plan_segments_needed(n_holes)) {
        return EXK_ERR_SIZE;
    }
    for (size_t i = 0; i < n_holes && b.err == EXK_OK; i++) {
        b.err = check_hole(&holes[i]);
        if (i > 0 && b.err == EXK_OK) {
            append_travel(&b, &holes[i - 1], &holes[i], (int32_t)i);
        }
        if (b.err == EXK_OK) {
            append_hole(&b, &holes[i], (int32_t)i);
        }
    }
    if (b.err == EXK_OK && cfg->closed) {
        append_travel(&b, &holes[n_holes - 1], &holes[0], 0);
    }
    if (b.err == EXK_OK) {
        *plan = (exk_plan){*cfg, holes, n_holes, segments, b.n, b.k};
    }
    return b.err;
}

/* Where the tool is at tick k: its hole and how deep it is. */
exk_err exk_plan_retract(const exk_plan *plan, int64_t k, exk_segment *out)
{
    builder b = {.cfg = &plan->cfg, .segments = out};
    exk_ref ref;
    exk_plan_at(plan, k, &ref);
    *out = (exk_segment){.phase = EXK_PHASE_RETRACT, .hole = ref.hole};
    out->from = ref.tool;
    out->to = ref.tool;
    if (ref.phase == EXK_PHASE_TRAVEL) {
        return EXK_OK;
    }
    exk_segment way = *out;
    way.to = tool_at(&plan->holes[ref.hole], -plan->cfg.clearance_m);
    append_move(&b, way, plan->cfg.retract_mps);
    return b.err;
}
