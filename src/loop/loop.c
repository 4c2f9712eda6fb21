#include "exk/loop.h"

#include <math.h>

#include "step.h"

static exk_err check(const exk_loop_config *cfg)
{
    if (cfg->kin == NULL || cfg->plan == NULL || cfg->source.exchange == NULL) {
        return EXK_ERR_ARG;
    }
    if (!(cfg->angle_max_rad > 0.0) || !isfinite(cfg->angle_max_rad) || cfg->n_bad_max < 1 ||
        !(cfg->wait_s >= 0.0)) {
        return EXK_ERR_ARG;
    }
    const bool stored = cfg->u_rad[EXK_ALPHA] != NULL;
    if (stored != (cfg->u_rad[EXK_BETA] != NULL) || (stored && cfg->n_u == 0)) {
        return EXK_ERR_SIZE;
    }
    return EXK_OK;
}

static exk_err init_guard(exk_loop *loop, const exk_loop_config *cfg)
{
    exk_guard_config guard = cfg->guard.dt_s > 0.0 ? cfg->guard : exk_guard_default();
    exk_limits_config limits = cfg->limits.dt_s > 0.0 ? cfg->limits : exk_limits_default();
    guard.dt_s = cfg->plan->cfg.dt_s;
    guard.angle_max_rad = cfg->angle_max_rad;
    limits.dt_s = cfg->plan->cfg.dt_s;
    const exk_err err = exk_guard_init(&loop->guard, &guard);
    return err != EXK_OK ? err : exk_limits_init(&loop->limits, &limits);
}

exk_err exk_loop_init(exk_loop *loop, const exk_loop_config *cfg)
{
    exk_err err = check(cfg);
    if (err == EXK_OK) {
        err = exk_feedback_init(&loop->feedback, &cfg->feedback);
    }
    if (err == EXK_OK) {
        err = init_guard(loop, cfg);
    }
    if (err != EXK_OK) {
        return err;
    }
    loop->cfg = *cfg;
    exk_loop_reset(loop);
    return EXK_OK;
}

static void reset_counts(exk_loop *loop)
{
    loop->n_bad_row = 0;
    loop->n_bad = 0;
    for (int i = 0; i < EXK_SAMPLE_COUNT; i++) {
        loop->guard.n[i] = 0;
    }
}

void exk_loop_reset(exk_loop *loop)
{
    exk_feedback_reset(&loop->feedback);
    exk_guard_reset(&loop->guard);
    exk_limits_reset(&loop->limits);
    exk_motion_init(&loop->motion);
    reset_counts(loop);
    for (int i = 0; i < EXK_N_AXES; i++) {
        loop->c_rad[i] = 0.0;
        loop->m_rad[i] = 0.0;
    }
    loop->has_m = false;
    loop->fault = EXK_OK;
    loop->report = (exk_fault_report){.k = -1, .hole_id = -1};
    loop->last = (exk_sample){.hole = -1, .hole_id = -1};
    loop->open = loop->last;
    loop->open.k = -1;
    loop->is_open = false;
    if (loop->cfg.capture != NULL) {
        exk_capture_reset(loop->cfg.capture);
    }
    exk_state_init(&loop->sm);
    exk_state_take(&loop->sm, EXK_CAUSE_READY, -1);
}

/* After rejected samples the way out of the part is safe; after all else the loop stays. */
static void begin_fault(exk_loop *loop, const exk_fault_report *report)
{
    loop->fault = report->err;
    loop->report = *report;
    if (report->cause == EXK_CAUSE_SENSOR) {
        exk_motion_settle(&loop->motion, loop->cfg.plan);
    } else {
        exk_motion_freeze(&loop->motion);
    }
}

void exk_loop_fail(exk_loop *loop, const exk_fault_report *report)
{
    if (loop->fault != EXK_OK) {
        exk_motion_freeze(&loop->motion); /* on the way out as well */
    } else if (exk_state_take(&loop->sm, report->cause, report->k)) {
        begin_fault(loop, report);
    }
}

static bool abort_run(exk_loop *loop, int64_t k)
{
    const exk_fault_report report = {.cause = EXK_CAUSE_ABORT,
                                     .err = EXK_ERR_ABORT,
                                     .k = k,
                                     .phase = loop->last.phase,
                                     .hole_id = loop->last.hole_id};
    const bool taken = exk_state_take(&loop->sm, EXK_CAUSE_ABORT, k);
    if (taken) {
        begin_fault(loop, &report);
    }
    return taken;
}

/* What was known of the machine before the fault is not known any more; the command stands, and the
 * correction goes on from the one in it: what broke a limit would break it again. */
static void forget_fault(exk_loop *loop)
{
    loop->fault = EXK_OK;
    exk_feedback_preset(&loop->feedback, loop->last.c_rad);
    for (int i = 0; i < EXK_N_AXES; i++) {
        loop->c_rad[i] = loop->last.c_rad[i];
    }
    loop->report = (exk_fault_report){.k = -1, .hole_id = -1};
    loop->n_bad_row = 0;
    exk_guard_forget(&loop->guard);
}

bool exk_loop_request(exk_loop *loop, exk_cause cause, int64_t k)
{
    const bool asked_for =
        (cause >= EXK_CAUSE_START && cause <= EXK_CAUSE_QUIT) || cause == EXK_CAUSE_TIMEOUT;
    const bool too_early = cause == EXK_CAUSE_CLEAR && !exk_motion_is_over(&loop->motion);
    if (!asked_for || too_early) {
        loop->sm.n_refused++;
        return false;
    }
    if (cause == EXK_CAUSE_ABORT) {
        return abort_run(loop, k);
    }
    const bool taken = exk_state_take(&loop->sm, cause, k);
    if (taken && cause == EXK_CAUSE_CLEAR) {
        forget_fault(loop);
    }
    return taken;
}

int64_t exk_loop_last_tick(const exk_loop *loop)
{
    return loop->cfg.plan->n_ticks - 1 + exk_motion_held(&loop->motion);
}

bool exk_loop_is_over(const exk_loop *loop)
{
    const exk_state state = loop->sm.state;
    return state == EXK_STATE_DONE ||
           (state == EXK_STATE_FAULT && exk_motion_is_over(&loop->motion));
}

bool exk_loop_moves(const exk_loop *loop)
{
    return loop->is_open;
}

/* The last command stands: nothing is sent, and no time passes for the plan. */
static exk_err hold(exk_loop *loop, int64_t k, exk_sample *out)
{
    loop->motion.k = k;
    exk_limits_stand(&loop->limits, k);
    if (loop->fault != EXK_OK && loop->cfg.capture != NULL) {
        exk_capture_freeze(loop->cfg.capture);
    }
    *out = loop->last;
    out->k = k;
    out->time_us = exk_step_time_us(loop, k);
    out->judged = false;
    out->sensor_ok = false;
    return loop->fault;
}

static void fail_step(exk_loop *loop, exk_cause cause, exk_err err, const exk_violation *what)
{
    const exk_fault_report report = {.cause = cause,
                                     .err = err,
                                     .what = *what,
                                     .k = loop->open.k,
                                     .phase = loop->open.phase,
                                     .hole_id = loop->open.hole_id};
    loop->is_open = false;
    exk_loop_fail(loop, &report);
}

exk_err exk_loop_command(exk_loop *loop, int64_t k, exk_drive *drive)
{
    exk_violation what = {EXK_QUANTITY_NONE, 0, 0.0, 0.0};
    loop->is_open = false;
    loop->open.k = -1;
    if (k <= loop->motion.k) {
        return EXK_ERR_ARG;
    }
    loop->open.k = k;
    if (loop->sm.cause == EXK_CAUSE_READY && !loop->cfg.waits) {
        exk_state_take(&loop->sm, EXK_CAUSE_START,
                       k); /* after clear it is for a person to say */
    }
    const bool at_rest = loop->fault != EXK_OK && exk_motion_is_over(&loop->motion);
    if (loop->sm.state == EXK_STATE_IDLE || at_rest) {
        return loop->fault;
    }
    loop->open = (exk_sample){.hole = -1, .hole_id = -1, .k = k};
    const exk_err err = exk_step_command(loop, &what);
    if (err != EXK_OK) {
        fail_step(loop, EXK_CAUSE_LIMIT, err, &what);
        return loop->fault;
    }
    exk_step_drive(&loop->open, drive);
    loop->is_open = true;
    return EXK_OK;
}

static void keep(exk_loop *loop, const exk_sample *out)
{
    exk_capture *capture = loop->cfg.capture;
    loop->last = *out;
    if (capture != NULL) {
        exk_capture_push(capture, out);
        if (loop->sm.state == EXK_STATE_FAULT) {
            exk_capture_freeze(capture);
        }
    }
}

exk_err exk_loop_measure(exk_loop *loop, const exk_reading *reading, exk_sample *out)
{
    exk_violation what = {EXK_QUANTITY_POSE, 0, 0.0, 0.0};
    const int64_t k = loop->open.k;
    if (k < 0) {
        *out = loop->last;
        return EXK_ERR_ARG;
    }
    loop->open.k = -1;
    if (!loop->is_open) {
        return hold(loop, k, out);
    }
    loop->open.k = k;
    loop->is_open = false;
    exk_step_correct(loop, reading);
    const exk_err err = exk_step_forward(loop, reading);
    if (err != EXK_OK) {
        fail_step(loop, EXK_CAUSE_LIMIT, err, &what);
        return hold(loop, k, out);
    }
    *out = loop->open;
    loop->open.k = -1;
    keep(loop, out);
    if (loop->sm.state == EXK_STATE_RUN && loop->motion.j + 1 >= loop->cfg.plan->n_ticks) {
        exk_state_take(&loop->sm, EXK_CAUSE_END, k);
    }
    return loop->fault;
}

exk_err exk_loop_step(exk_loop *loop, int64_t k, exk_sample *out)
{
    const exk_source *source = &loop->cfg.source;
    const exk_violation nothing = {EXK_QUANTITY_NONE, 0, 0.0, 0.0};
    exk_drive drive;
    exk_reading reading = {.fresh = false};
    exk_loop_command(loop, k, &drive);
    if (loop->is_open) {
        const exk_err err = source->exchange(source->ctx, k, &drive, &reading);
        if (err != EXK_OK) {
            fail_step(loop, EXK_CAUSE_SOURCE, err, &nothing);
        }
    }
    return exk_loop_measure(loop, &reading, out);
}
