#include "step.h"

#include <math.h>

#include "exk/excess.h"
#include "exk/ilc.h"

int64_t exk_step_time_us(const exk_loop *loop, int64_t k)
{
    return llround((double)k * loop->cfg.plan->cfg.dt_s * 1e6);
}

/* plan and inverse: p_ref[k], r[k] = IK(p_ref[k]) */
static exk_err refer(exk_loop *loop)
{
    const exk_plan *plan = loop->cfg.plan;
    exk_sample *out = &loop->open;
    const exk_motion_wish wish = {
        .go = loop->sm.state == EXK_STATE_RUN,
        .out = loop->sm.state == EXK_STATE_FAULT,
        .wait_s = loop->cfg.wait_s,
    };
    exk_ref ref;
    exk_motion_place(&loop->motion, plan, out->k, &wish, &ref);
    out->time_us = exk_step_time_us(loop, out->k);
    out->phase = ref.phase;
    out->hole = ref.hole;
    out->hole_id = ref.hole >= 0 ? plan->holes[ref.hole].id : -1;
    out->judged = ref.judged;
    out->ref = ref.tool;
    return exk_kin_inverse(loop->cfg.kin, &ref.tool, &loop->open_r);
}

/* u[j], between two ticks of the plan where it is slowed down. */
static double stored(const exk_loop *loop, int axis)
{
    const exk_motion *m = &loop->motion;
    const double *u_rad = loop->cfg.u_rad[axis];
    if (u_rad == NULL) {
        return 0.0;
    }
    const double now = exk_ilc_at(u_rad, loop->cfg.n_u, m->j);
    if (!(m->part > 0.0)) {
        return now;
    }
    return now + m->part * (exk_ilc_at(u_rad, loop->cfg.n_u, m->j + 1) - now);
}

/* command: q[k] = r[k] + c[k] + u[k]; legs from (q, h of r), wrist from r */
static exk_err command(exk_loop *loop)
{
    const exk_joints *r = &loop->open_r;
    exk_sample *out = &loop->open;
    exk_joints q = *r;
    for (int i = 0; i < EXK_N_AXES; i++) {
        out->r_rad[i] = r->angle_rad[i];
        out->c_rad[i] = loop->c_rad[i];
        out->u_rad[i] = stored(loop, i);
        out->q_rad[i] = out->r_rad[i] + out->c_rad[i] + out->u_rad[i];
        q.angle_rad[i] = out->q_rad[i];
        out->wrist_rad[i] = r->wrist_rad[i];
    }
    out->h_m = r->h_m;
    return exk_kin_legs(loop->cfg.kin, &q, out->legs_m);
}

/* The kinematics says that a leg or an angle is beyond its limit: which one, and by how much. */
static void explain(const exk_loop *loop, exk_violation *what)
{
    const double angle_max_rad = loop->cfg.kin->geo.angle_max_rad;
    exk_joints q = loop->open_r;
    exk_excess excess;
    *what = (exk_violation){EXK_QUANTITY_POSE, 0, 0.0, 0.0};
    for (int i = 0; i < EXK_N_AXES; i++) {
        q.angle_rad[i] = loop->open.q_rad[i];
        if (!(fabs(q.angle_rad[i]) <= angle_max_rad)) {
            *what = (exk_violation){EXK_QUANTITY_ANGLE, i, q.angle_rad[i], angle_max_rad};
            return;
        }
    }
    if (exk_excess_of_joints(loop->cfg.kin, &q, &excess)) {
        *what = (exk_violation){EXK_QUANTITY_LEG, excess.index, excess.value, excess.limit};
    }
}

exk_err exk_step_command(exk_loop *loop, exk_violation *what)
{
    exk_sample *out = &loop->open;
    exk_err err = refer(loop);
    if (err != EXK_OK) {
        *what = (exk_violation){EXK_QUANTITY_POSE, 0, 0.0, 0.0};
        return err;
    }
    err = command(loop);
    if (err != EXK_OK) {
        explain(loop, what);
        return err;
    }
    const exk_limits_step step = {out->ref.tip_m, out->r_rad, out->q_rad, out->legs_m};
    return exk_limits_command(&loop->limits, out->k, &step, what) ? EXK_OK : EXK_ERR_LIMIT;
}

void exk_step_drive(const exk_sample *sample, exk_drive *drive)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        drive->angle_rad[i] = sample->q_rad[i];
        drive->wrist_rad[i] = sample->wrist_rad[i];
    }
    for (int i = 0; i < EXK_N_LEGS; i++) {
        drive->legs_m[i] = sample->legs_m[i];
    }
}

static void raise_fault(exk_loop *loop, exk_cause cause, exk_err err, const exk_violation *what,
                        exk_sample_kind kind)
{
    const exk_fault_report report = {.cause = cause,
                                     .err = err,
                                     .what = *what,
                                     .sample = kind,
                                     .k = loop->open.k,
                                     .phase = loop->open.phase,
                                     .hole_id = loop->open.hole_id};
    exk_loop_fail(loop, &report);
}

static void reject(exk_loop *loop, exk_sample_kind kind)
{
    const int n_max = loop->cfg.n_bad_max;
    loop->n_bad++;
    loop->n_bad_row += loop->n_bad_row < n_max ? 1 : 0;
    if (loop->n_bad_row >= n_max && loop->fault == EXK_OK) {
        const exk_violation what = {EXK_QUANTITY_SAMPLES, loop->guard.bad_axis,
                                    (double)loop->n_bad_row, (double)n_max};
        raise_fault(loop, EXK_CAUSE_SENSOR, EXK_ERR_SENSOR, &what, kind);
    }
}

/* e[k] = r[k] - m[k], c[k+1] = feedback(e[k]); under a fault the correction stays as it is. */
static void accept(exk_loop *loop, const exk_reading *reading)
{
    double error_rad[EXK_N_AXES];
    exk_violation what;
    for (int i = 0; i < EXK_N_AXES; i++) {
        loop->m_rad[i] = reading->measured_rad[i];
        error_rad[i] = loop->open.r_rad[i] - loop->m_rad[i];
    }
    loop->has_m = true;
    if (loop->fault != EXK_OK) {
        return;
    }
    if (loop->n_bad_row > 0) {
        exk_feedback_rejoin(&loop->feedback, error_rad);
    }
    loop->n_bad_row = 0;
    exk_feedback_step(&loop->feedback, error_rad, loop->c_rad);
    if (!exk_limits_following(&loop->limits, loop->m_rad, &what)) {
        raise_fault(loop, EXK_CAUSE_LIMIT, EXK_ERR_LIMIT, &what, EXK_SAMPLE_GOOD);
    }
}

void exk_step_correct(exk_loop *loop, const exk_reading *reading)
{
    exk_sample *out = &loop->open;
    const exk_sample_kind kind =
        exk_guard_check(&loop->guard, out->k, out->r_rad, out->q_rad, reading);
    out->sensor_ok = kind == EXK_SAMPLE_GOOD;
    if (out->sensor_ok) {
        accept(loop, reading);
    } else {
        reject(loop, kind);
    }
    for (int i = 0; i < EXK_N_AXES; i++) {
        out->m_rad[i] = loop->has_m ? loop->m_rad[i] : out->r_rad[i];
    }
}

static exk_err tip(const exk_loop *loop, const double angle_rad[], exk_tool *out)
{
    exk_joints joints = loop->open_r;
    joints.angle_rad[EXK_ALPHA] = angle_rad[EXK_ALPHA];
    joints.angle_rad[EXK_BETA] = angle_rad[EXK_BETA];
    return exk_kin_forward(loop->cfg.kin, &joints, out);
}

/* The truth passes beside the controller; what is no pose is no truth. */
static void take_truth(const exk_loop *loop, const exk_reading *reading, exk_sample *out)
{
    out->has_true = reading->has_true && tip(loop, reading->true_rad, &out->real) == EXK_OK;
    for (int i = 0; i < EXK_N_AXES; i++) {
        out->theta_rad[i] = out->has_true ? reading->true_rad[i] : 0.0;
    }
}

exk_err exk_step_forward(exk_loop *loop, const exk_reading *reading)
{
    exk_sample *out = &loop->open;
    take_truth(loop, reading, out);
    if (out->has_true && out->m_rad[EXK_ALPHA] == out->theta_rad[EXK_ALPHA] &&
        out->m_rad[EXK_BETA] == out->theta_rad[EXK_BETA]) {
        out->est = out->real; /* the same angles give the same bits */
        return EXK_OK;
    }
    return tip(loop, out->m_rad, &out->est);
}
