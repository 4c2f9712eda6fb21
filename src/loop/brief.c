#include "exk/brief.h"

#include <math.h>

#include "exk/ilc.h"

exk_err exk_waypoints(const exk_plan *plan, const exk_kin *kin, exk_waypoint *out)
{
    exk_err err = EXK_OK;
    for (int64_t k = 0; k < plan->n_ticks && err == EXK_OK; k++) {
        exk_plan_at(plan, k, &out[k].ref);
        err = exk_kin_inverse(kin, &out[k].ref.tool, &out[k].r);
    }
    return err;
}

static bool is_plain(exk_loop *loop, int64_t k)
{
    const exk_motion *m = &loop->motion;
    if (loop->sm.cause == EXK_CAUSE_READY && !loop->cfg.waits) {
        exk_state_take(&loop->sm, EXK_CAUSE_START, k);
    }
    return loop->sm.state == EXK_STATE_RUN && loop->fault == EXK_OK &&
           m->mode == EXK_MOTION_FOLLOW && m->k == k - 1 && m->j == k - 1 &&
           loop->cfg.capture == NULL;
}

/* q[k] = r[k] + c[k] + u[k], as in step.c. */
static void command(const exk_loop *loop, int64_t k, const exk_joints *r, exk_drive *drive,
                    exk_brief *out)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        const double *u_rad = loop->cfg.u_rad[i];
        const double u = u_rad == NULL ? 0.0 : exk_ilc_at(u_rad, loop->cfg.n_u, k);
        out->c_rad[i] = loop->c_rad[i];
        drive->angle_rad[i] = r->angle_rad[i] + out->c_rad[i] + u;
        drive->wrist_rad[i] = r->wrist_rad[i];
    }
}

/* Legs where they can be beyond something, then every limit there is. */
static exk_err ask_limits(exk_loop *loop, int64_t k, const exk_waypoint *at, exk_drive *drive)
{
    const exk_kin *kin = loop->cfg.kin;
    exk_violation what;
    for (int i = 0; i < EXK_N_AXES; i++) {
        if (!(fabs(drive->angle_rad[i]) <= loop->cfg.angle_max_rad)) {
            return EXK_ERR_LIMIT;
        }
    }
    if (kin->model == EXK_KIN_MACHINE || exk_limits_ask_legs(&loop->limits)) {
        exk_joints q = at->r;
        q.angle_rad[EXK_ALPHA] = drive->angle_rad[EXK_ALPHA];
        q.angle_rad[EXK_BETA] = drive->angle_rad[EXK_BETA];
        const exk_err err = exk_kin_legs(kin, &q, drive->legs_m);
        if (err != EXK_OK) {
            return err;
        }
    }
    const exk_limits_step step = {at->ref.tool.tip_m, at->r.angle_rad, drive->angle_rad,
                                  drive->legs_m};
    return exk_limits_command(&loop->limits, k, &step, &what) ? EXK_OK : EXK_ERR_LIMIT;
}

/* e[k] = r[k] - m[k], c[k+1] = feedback(e[k]). */
static exk_err correct(exk_loop *loop, int64_t k, const exk_joints *r, const exk_drive *drive,
                       const exk_reading *reading, exk_brief *out)
{
    exk_violation what;
    if (exk_guard_check(&loop->guard, k, r->angle_rad, drive->angle_rad, reading) !=
        EXK_SAMPLE_GOOD) {
        return EXK_ERR_SENSOR;
    }
    for (int i = 0; i < EXK_N_AXES; i++) {
        out->e_rad[i] = r->angle_rad[i] - reading->measured_rad[i];
    }
    exk_feedback_step(&loop->feedback, out->e_rad, loop->c_rad);
    return exk_limits_following(&loop->limits, reading->measured_rad, &what) ? EXK_OK
                                                                             : EXK_ERR_LIMIT;
}

static exk_err forward(const exk_loop *loop, const exk_joints *r, const exk_reading *reading,
                       exk_tool *out)
{
    const double *angle_rad = reading->has_true ? reading->true_rad : reading->measured_rad;
    exk_joints joints = *r;
    joints.angle_rad[EXK_ALPHA] = angle_rad[EXK_ALPHA];
    joints.angle_rad[EXK_BETA] = angle_rad[EXK_BETA];
    return exk_kin_forward(loop->cfg.kin, &joints, out);
}

exk_err exk_loop_brief(exk_loop *loop, int64_t k, const exk_waypoint *at, exk_brief *out)
{
    exk_drive drive = {.legs_m = {0.0}};
    exk_reading reading = {.fresh = false};
    if (!is_plain(loop, k)) {
        return EXK_ERR_ARG;
    }
    loop->motion.k = k;
    loop->motion.j = k;
    command(loop, k, &at->r, &drive, out);
    exk_err err = ask_limits(loop, k, at, &drive);
    if (err == EXK_OK) {
        err = loop->cfg.source.exchange(loop->cfg.source.ctx, k, &drive, &reading);
    }
    if (err == EXK_OK) {
        err = correct(loop, k, &at->r, &drive, &reading, out);
    }
    if (err == EXK_OK) {
        err = forward(loop, &at->r, &reading, &out->tool);
    }
    if (err == EXK_OK && k + 1 == loop->cfg.plan->n_ticks) {
        exk_state_take(&loop->sm, EXK_CAUSE_END, k);
    }
    return err;
}
