#include "exk/motion.h"

#include <math.h>

static const double ramp_max = 1e9; /* ticks; squares of it fit */

static const char *const names[EXK_MOTION_COUNT] = {
    [EXK_MOTION_FOLLOW] = "following",   [EXK_MOTION_SLOW] = "slowing",
    [EXK_MOTION_REST] = "at rest",       [EXK_MOTION_SPEED] = "speeding up",
    [EXK_MOTION_RETRACT] = "retracting", [EXK_MOTION_OUT] = "out",
};

const char *exk_motion_name(exk_motion_mode mode)
{
    return (unsigned)mode < EXK_MOTION_COUNT ? names[mode] : "unknown";
}

void exk_motion_init(exk_motion *m)
{
    *m = (exk_motion){.mode = EXK_MOTION_FOLLOW, .k = -1, .j = -1};
}

static void enter(exk_motion *m, exk_motion_mode mode)
{
    m->mode = mode;
    m->k0 = m->k;
    m->j0 = m->j;
}

static double feed_of(const exk_plan_config *cfg, exk_phase phase)
{
    switch (phase) {
    case EXK_PHASE_APPROACH:
        return cfg->approach_mps;
    case EXK_PHASE_DRILL:
        return cfg->drill_mps;
    case EXK_PHASE_RETRACT:
        return cfg->retract_mps;
    case EXK_PHASE_DWELL:
        return 0.0;
    case EXK_PHASE_TRAVEL:
    case EXK_PHASE_COUNT:
        break;
    }
    return cfg->feed_mps;
}

/* Odd, and no shorter than the feed of this phase takes at the plan's acceleration. */
static int64_t ramp_ticks(const exk_plan *plan, int64_t j)
{
    exk_ref ref;
    exk_plan_at(plan, j, &ref);
    const double time_s = feed_of(&plan->cfg, ref.phase) / plan->cfg.accel_mps2;
    const double half = ceil(0.5 * time_s / plan->cfg.dt_s);
    return 2 * (int64_t)(half < ramp_max ? half : ramp_max) + 1;
}

static void enter_ramp(exk_motion *m, const exk_plan *plan, exk_motion_mode mode)
{
    m->n = ramp_ticks(plan, m->j);
    enter(m, mode);
}

static void set_way(exk_motion *m, int64_t twice)
{
    m->j = m->j0 + twice / (2 * m->n);
    m->part = (double)(twice % (2 * m->n)) / (double)(2 * m->n);
}

static void slow(exk_motion *m, int64_t k)
{
    const int64_t i = k - m->k0 < m->n ? k - m->k0 : m->n;
    set_way(m, i * (2 * m->n - i - 1));
    m->k = k;
    if (i == m->n) {
        enter(m, EXK_MOTION_REST);
    }
}

static void speed_up(exk_motion *m, int64_t k)
{
    const int64_t i = k - m->k0 < m->n ? k - m->k0 : m->n;
    const int64_t over = k - m->k0 - i;
    set_way(m, i * (i + 1));
    m->k = k;
    if (i == m->n) {
        m->j += over;
        enter(m, EXK_MOTION_FOLLOW);
    }
}

static void leave_part(exk_motion *m, const exk_plan *plan)
{
    m->retracts = exk_plan_retract(plan, m->j, &m->way) == EXK_OK && m->way.n_ticks > 0;
    m->step = 0;
    enter(m, m->retracts ? EXK_MOTION_RETRACT : EXK_MOTION_OUT);
}

static void go_on(exk_motion *m, const exk_plan *plan)
{
    if (m->retracts && m->step < m->way.n_ticks) {
        enter(m, EXK_MOTION_RETRACT);
        m->k0 -= m->step;
        return;
    }
    m->j = m->retracts ? exk_plan_resume(plan, m->j) : m->j;
    m->retracts = false;
    enter_ramp(m, plan, EXK_MOTION_SPEED);
}

/* Changes of mode that the wish brings, before tick k is placed. */
static void choose(exk_motion *m, const exk_plan *plan, int64_t k, const exk_motion_wish *wish)
{
    const bool rests = m->mode == EXK_MOTION_REST;
    if (m->mode == EXK_MOTION_FOLLOW) { /* and not to go on, else nobody asks */
        enter_ramp(m, plan, EXK_MOTION_SLOW);
    } else if (wish->go && (rests || m->mode == EXK_MOTION_OUT)) {
        go_on(m, plan);
    } else if (rests && wish->out && (double)(k - m->k0) * plan->cfg.dt_s > wish->wait_s) {
        leave_part(m, plan);
    }
}

static void advance(exk_motion *m, int64_t k)
{
    switch (m->mode) {
    case EXK_MOTION_SLOW:
        slow(m, k);
        break;
    case EXK_MOTION_SPEED:
        speed_up(m, k);
        break;
    case EXK_MOTION_FOLLOW:
    case EXK_MOTION_REST:
    case EXK_MOTION_RETRACT:
    case EXK_MOTION_OUT:
    case EXK_MOTION_COUNT:
        break;
    }
    m->k = k;
}

/* The reference while j moves or rests; a sample is judged once, when its tick is reached. */
static void place_on_plan(const exk_motion *m, const exk_plan *plan, int64_t j_before,
                          exk_ref *out)
{
    exk_plan_between(plan, m->j, m->part, out);
    out->judged = out->judged && m->j > j_before;
}

static void place_on_way(exk_motion *m, const exk_plan *plan, exk_ref *out)
{
    if (m->mode == EXK_MOTION_RETRACT) {
        m->step = m->k - m->k0 < m->way.n_ticks ? m->k - m->k0 : m->way.n_ticks;
    }
    exk_plan_at(plan, m->j, out);
    out->phase = EXK_PHASE_RETRACT;
    out->judged = false;
    exk_segment_at(&m->way, m->step, &out->tool);
    if (m->mode == EXK_MOTION_RETRACT && m->step >= m->way.n_ticks) {
        enter(m, EXK_MOTION_OUT);
    }
}

void exk_motion_place(exk_motion *m, const exk_plan *plan, int64_t k,
                      const exk_motion_wish *wish, exk_ref *out)
{
    if (m->mode == EXK_MOTION_FOLLOW && wish->go) {
        m->j += k - m->k;
        m->k = k;
        exk_plan_at(plan, m->j, out);
        return;
    }
    const int64_t j_before = m->j;
    choose(m, plan, k, wish);
    advance(m, k);
    if (m->mode == EXK_MOTION_RETRACT || (m->mode == EXK_MOTION_OUT && m->retracts)) {
        place_on_way(m, plan, out);
    } else {
        place_on_plan(m, plan, j_before, out);
    }
}

void exk_motion_freeze(exk_motion *m)
{
    m->part = 0.0;
    enter(m, EXK_MOTION_OUT);
}

void exk_motion_settle(exk_motion *m, const exk_plan *plan)
{
    exk_ref ref;
    exk_segment way;
    exk_plan_at(plan, m->j, &ref);
    const bool rests = m->mode == EXK_MOTION_REST ||
                       (m->mode == EXK_MOTION_FOLLOW && ref.phase == EXK_PHASE_DWELL);
    if (rests && exk_plan_retract(plan, m->j, &way) == EXK_OK && way.n_ticks == 0) {
        exk_motion_freeze(m);
    }
}

bool exk_motion_is_over(const exk_motion *m)
{
    return m->mode == EXK_MOTION_OUT;
}
