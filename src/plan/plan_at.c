#include <math.h>

#include "exk/plan.h"
#include "exk/vec3.h"

/* The segment that holds tick k, 0 <= k < n_ticks. */
static const exk_segment *find_segment(const exk_plan *plan, int64_t k)
{
    const exk_segment *base = plan->segments;
    for (size_t n = plan->n_segments; n > 1;) {
        const size_t half = n / 2;
        base += base[half].k_begin <= k ? half : 0;
        n -= half;
    }
    return base;
}

/* Way done at the fraction t of the time: speed rises for the fraction r, holds, falls for r. */
static double trapezoid(double t, double r)
{
    const double peak = 1.0 / (1.0 - r);
    if (t < r) {
        return peak * t * t / (2.0 * r);
    }
    if (t > 1.0 - r) {
        return 1.0 - peak * (1.0 - t) * (1.0 - t) / (2.0 * r);
    }
    return peak * (t - 0.5 * r);
}

static void blend3(const double a[3], const double b[3], double s, double out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = a[i] + s * (b[i] - a[i]);
    }
}

static void move_along(const exk_segment *segment, double s, exk_tool *out)
{
    blend3(segment->from.tip_m, segment->to.tip_m, s, out->tip_m);
    if (!segment->turns) {
        exk_copy3(segment->to.axis, out->axis);
        return;
    }
    double axis[3];
    blend3(segment->from.axis, segment->to.axis, s, axis);
    const double scale = 1.0 / exk_norm3(axis);
    for (int i = 0; i < 3; i++) {
        out->axis[i] = scale * axis[i];
    }
}

void exk_segment_at(const exk_segment *segment, int64_t step, exk_tool *out)
{
    if (step >= segment->n_ticks || segment->phase == EXK_PHASE_DWELL) {
        *out = segment->to;
    } else {
        move_along(segment, trapezoid((double)step / (double)segment->n_ticks, segment->ramp),
                   out);
    }
}

void exk_plan_at(const exk_plan *plan, int64_t k, exk_ref *out)
{
    const int64_t last = plan->n_ticks - 1;
    const int64_t held = k < 0 ? 0 : (k > last ? last : k);
    const exk_segment *segment = find_segment(plan, held);
    const int64_t step = held - segment->k_begin + 1; /* 1 .. n_ticks: the end is sampled */
    const bool ends = step == segment->n_ticks;
    out->phase = segment->phase;
    out->hole = segment->hole;
    out->judged = ends && segment->phase == EXK_PHASE_DWELL && k == held;
    exk_segment_at(segment, step, &out->tool);
}

void exk_plan_between(const exk_plan *plan, int64_t k, double fraction, exk_ref *out)
{
    exk_ref next;
    exk_plan_at(plan, k, out);
    if (!(fraction > 0.0)) {
        return;
    }
    exk_plan_at(plan, k + 1, &next);
    const exk_segment way = {.from = out->tool, .to = next.tool, .turns = true};
    move_along(&way, fraction, &out->tool);
}

int64_t exk_plan_resume(const exk_plan *plan, int64_t k)
{
    const int64_t last = plan->n_ticks - 1;
    const exk_segment *segment = find_segment(plan, k < 0 ? 0 : (k > last ? last : k));
    if (segment->phase == EXK_PHASE_RETRACT) {
        return segment->k_begin + segment->n_ticks - 1;
    }
    while (segment > plan->segments && segment[-1].hole == segment->hole &&
           segment[-1].phase != EXK_PHASE_TRAVEL && segment->phase != EXK_PHASE_TRAVEL) {
        segment--;
    }
    return segment->phase == EXK_PHASE_TRAVEL ? k : segment->k_begin - 1;
}

const char *exk_phase_name(exk_phase phase)
{
    static const char *const names[EXK_PHASE_COUNT] = {
        [EXK_PHASE_TRAVEL] = "travel",   [EXK_PHASE_APPROACH] = "approach",
        [EXK_PHASE_DWELL] = "dwell",     [EXK_PHASE_DRILL] = "drill",
        [EXK_PHASE_RETRACT] = "retract",
    };
    return (unsigned)phase < EXK_PHASE_COUNT ? names[phase] : "unknown";
}
