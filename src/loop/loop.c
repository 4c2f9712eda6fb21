#include "exk/loop.h"

#include <math.h>

#include "exk/ilc.h"

static exk_err check(const exk_loop_config *cfg)
{
    if (cfg->kin == NULL || cfg->plan == NULL || cfg->source.exchange == NULL) {
        return EXK_ERR_ARG;
    }
    if (!(cfg->angle_max_rad > 0.0) || !isfinite(cfg->angle_max_rad) || cfg->n_bad_max < 1) {
        return EXK_ERR_ARG;
    }
    const bool stored = cfg->u_rad[EXK_ALPHA] != NULL;
    if (stored != (cfg->u_rad[EXK_BETA] != NULL) || (stored && cfg->n_u == 0)) {
        return EXK_ERR_SIZE;
    }
    return EXK_OK;
}

exk_err exk_loop_init(exk_loop *loop, const exk_loop_config *cfg)
{
    exk_err err = check(cfg);
    if (err == EXK_OK) {
        err = exk_feedback_init(&loop->feedback, &cfg->feedback);
    }
    if (err != EXK_OK) {
        return err;
    }
    loop->cfg = *cfg;
    exk_loop_reset(loop);
    return EXK_OK;
}

void exk_loop_reset(exk_loop *loop)
{
    exk_feedback_reset(&loop->feedback);
    for (int i = 0; i < EXK_N_AXES; i++) {
        loop->c_rad[i] = 0.0;
        loop->m_rad[i] = 0.0;
    }
    loop->has_m = false;
    loop->n_bad_row = 0;
    loop->n_bad = 0;
    loop->state = EXK_STATE_IDLE;
    loop->fault = EXK_OK;
    loop->last = (exk_sample){.hole = -1, .hole_id = -1};
    loop->open = loop->last;
}

void exk_loop_fail(exk_loop *loop, exk_err why)
{
    if (loop->state != EXK_STATE_FAULT) {
        loop->state = EXK_STATE_FAULT;
        loop->fault = why;
    }
}

static int64_t tick_time_us(const exk_loop *loop, int64_t k)
{
    return llround((double)k * loop->cfg.plan->cfg.dt_s * 1e6);
}

/* plan and inverse: p_ref[k], r[k] = IK(p_ref[k]) */
static exk_err refer(const exk_loop *loop, int64_t k, exk_sample *out, exk_joints *r)
{
    exk_ref ref;
    exk_plan_at(loop->cfg.plan, k, &ref);
    out->k = k;
    out->time_us = tick_time_us(loop, k);
    out->phase = ref.phase;
    out->hole = ref.hole;
    out->hole_id = ref.hole >= 0 ? loop->cfg.plan->holes[ref.hole].id : -1;
    out->judged = ref.judged;
    out->ref = ref.tool;
    return exk_kin_inverse(loop->cfg.kin, &ref.tool, r);
}

/* command: q[k] = r[k] + c[k] + u[k]; legs from (q, h of r), wrist from r */
static exk_err command(const exk_loop *loop, const exk_joints *r, exk_sample *out)
{
    const exk_loop_config *cfg = &loop->cfg;
    exk_joints q = *r;
    for (int i = 0; i < EXK_N_AXES; i++) {
        out->r_rad[i] = r->angle_rad[i];
        out->c_rad[i] = loop->c_rad[i];
        out->u_rad[i] = cfg->u_rad[i] ? exk_ilc_at(cfg->u_rad[i], cfg->n_u, out->k) : 0.0;
        out->q_rad[i] = out->r_rad[i] + out->c_rad[i] + out->u_rad[i];
        q.angle_rad[i] = out->q_rad[i];
        out->wrist_rad[i] = r->wrist_rad[i];
    }
    out->h_m = r->h_m;
    return exk_kin_legs(cfg->kin, &q, out->legs_m);
}

static void fill_drive(const exk_sample *out, exk_drive *drive)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        drive->angle_rad[i] = out->q_rad[i];
        drive->wrist_rad[i] = out->wrist_rad[i];
    }
    for (int i = 0; i < EXK_N_LEGS; i++) {
        drive->legs_m[i] = out->legs_m[i];
    }
}

/* Written so that NaN fails. */
static bool acceptable(const exk_loop *loop, const exk_reading *reading)
{
    const double limit_rad = loop->cfg.angle_max_rad;
    return reading->fresh && fabs(reading->measured_rad[EXK_ALPHA]) <= limit_rad &&
           fabs(reading->measured_rad[EXK_BETA]) <= limit_rad;
}

/* error and feedback: e[k] = r[k] - m[k], c[k+1] = feedback(e[k]); a bad sample changes nothing */
static exk_err correct(exk_loop *loop, const exk_reading *reading, exk_sample *out)
{
    out->sensor_ok = acceptable(loop, reading);
    if (out->sensor_ok) {
        double error_rad[EXK_N_AXES];
        for (int i = 0; i < EXK_N_AXES; i++) {
            loop->m_rad[i] = reading->measured_rad[i];
            error_rad[i] = out->r_rad[i] - loop->m_rad[i];
        }
        loop->has_m = true;
        loop->n_bad_row = 0;
        exk_feedback_step(&loop->feedback, error_rad, loop->c_rad);
    } else {
        loop->n_bad++;
        loop->n_bad_row++;
    }
    for (int i = 0; i < EXK_N_AXES; i++) {
        out->m_rad[i] = loop->has_m ? loop->m_rad[i] : out->r_rad[i];
    }
    return loop->n_bad_row >= loop->cfg.n_bad_max ? EXK_ERR_SENSOR : EXK_OK;
}

static exk_err tip(const exk_loop *loop, const exk_joints *r, const double angle_rad[],
                   exk_tool *out)
{
    exk_joints joints = *r;
    joints.angle_rad[EXK_ALPHA] = angle_rad[EXK_ALPHA];
    joints.angle_rad[EXK_BETA] = angle_rad[EXK_BETA];
    return exk_kin_forward(loop->cfg.kin, &joints, out);
}

/* forward: p_est[k] = FK(m[k]); p_true[k] = FK(theta[k]) where theta is known and finite */
static exk_err forward(const exk_loop *loop, const exk_joints *r, const exk_reading *reading,
                       exk_sample *out)
{
    out->has_true = reading->has_true;
    for (int i = 0; i < EXK_N_AXES; i++) {
        out->theta_rad[i] = reading->has_true ? reading->true_rad[i] : 0.0;
    }
    if (out->has_true && tip(loop, r, out->theta_rad, &out->real) != EXK_OK) {
        out->has_true = false;
    }
    if (out->has_true && out->m_rad[EXK_ALPHA] == out->theta_rad[EXK_ALPHA] &&
        out->m_rad[EXK_BETA] == out->theta_rad[EXK_BETA]) {
        out->est = out->real; /* the same angles give the same bits */
        return EXK_OK;
    }
    return tip(loop, r, out->m_rad, &out->est);
}

static exk_err hold(const exk_loop *loop, int64_t k, exk_sample *out)
{
    *out = loop->last;
    out->k = k;
    out->time_us = tick_time_us(loop, k);
    out->judged = false;
    out->sensor_ok = false;
    return loop->fault;
}

exk_err exk_loop_command(exk_loop *loop, int64_t k, exk_drive *drive)
{
    loop->open = (exk_sample){.hole = -1, .k = k};
    if (loop->state == EXK_STATE_FAULT) {
        return loop->fault;
    }
    exk_err err = refer(loop, k, &loop->open, &loop->open_r);
    if (err == EXK_OK) {
        err = command(loop, &loop->open_r, &loop->open);
    }
    if (err != EXK_OK) {
        exk_loop_fail(loop, err);
        return err;
    }
    fill_drive(&loop->open, drive);
    return EXK_OK;
}

exk_err exk_loop_measure(exk_loop *loop, const exk_reading *reading, exk_sample *out)
{
    *out = loop->open;
    if (loop->state == EXK_STATE_FAULT) {
        return hold(loop, out->k, out);
    }
    exk_err err = correct(loop, reading, out);
    if (err == EXK_OK) {
        err = forward(loop, &loop->open_r, reading, out);
    }
    if (err != EXK_OK) {
        exk_loop_fail(loop, err);
        return hold(loop, out->k, out);
    }
    loop->last = *out;
    loop->state = out->k + 1 < loop->cfg.plan->n_ticks ? EXK_STATE_RUN : EXK_STATE_DONE;
    return EXK_OK;
}

exk_err exk_loop_step(exk_loop *loop, int64_t k, exk_sample *out)
{
    const exk_source *source = &loop->cfg.source;
    exk_drive drive;
    exk_reading reading = {.fresh = false};
    exk_err err = exk_loop_command(loop, k, &drive);
    if (err == EXK_OK) {
        err = source->exchange(source->ctx, k, &drive, &reading);
    }
    if (err != EXK_OK) {
        exk_loop_fail(loop, err);
    }
    return exk_loop_measure(loop, &reading, out);
}
