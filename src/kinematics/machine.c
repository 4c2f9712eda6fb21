#include "exk/machine.h"

#include "attitude.h"
#include "exk/wrist.h"

/* |tau|^2 may differ from 1 by twice what |tau| may. */
#define UNIT_SLACK 2e-9

const exk_kin_ops exk_machine_ops = {
    .name = "machine",
    .inverse = exk_machine_inverse,
    .forward = exk_machine_forward,
    .legs = exk_machine_legs,
};

/* Columns u, v, w of R_base_plate (section 3). */
static void plate_axes(const exk_attitude *att, double u[3], double v[3], double w[3])
{
    u[0] = att->ca;
    u[1] = -att->sa * att->sb;
    u[2] = -att->sa * att->cb;
    v[0] = 0.0;
    v[1] = att->cb;
    v[2] = -att->sb;
    w[0] = att->sa;
    w[1] = att->ca * att->sb;
    w[2] = att->ca * att->cb;
}

/* Attitude and legs that put the wrist centre S = Q - t tau where it has to be. */
static exk_err place_plate(const exk_kin *kin, const exk_tool *tool, exk_attitude *att,
                           double legs_m[EXK_N_LEGS])
{
    const double off_unit = exk_dot3(tool->axis, tool->axis) - 1.0;
    if (!(fabs(off_unit) <= UNIT_SLACK)) {
        return EXK_ERR_ARG;
    }
    double s_m[3];
    exk_add_scaled3(tool->tip_m, -kin->geo.t_m, tool->axis, s_m);
    exk_err err = exk_attitude_of_point(&kin->tripod, s_m, kin->geo.e_m, kin->geo.f_m, att);
    return err == EXK_OK ? exk_attitude_legs(&kin->tripod, att, legs_m) : err;
}

exk_err exk_machine_inverse(const exk_kin *kin, const exk_tool *tool, exk_joints *out)
{
    exk_attitude att;
    double legs_m[EXK_N_LEGS], u[3], v[3], w[3], wrist_rad[EXK_N_WRIST];
    exk_err err = place_plate(kin, tool, &att, legs_m);
    if (err != EXK_OK) {
        return err;
    }
    plate_axes(&att, u, v, w);
    const double tau_plate[3] = {exk_dot3(u, tool->axis), exk_dot3(v, tool->axis),
                                 exk_dot3(w, tool->axis)};
    err = exk_wrist_inverse(kin->wrist, tau_plate, wrist_rad);
    if (err == EXK_OK) {
        *out = (exk_joints){
            .angle_rad = {atan2(att.x, att.s), atan2(att.y, att.z)},
            .h_m = att.h,
            .wrist_rad = {wrist_rad[0], wrist_rad[1]},
        };
    }
    return err;
}

static exk_tripod_pose pose_of(const exk_joints *joints)
{
    return (exk_tripod_pose){joints->angle_rad[EXK_ALPHA], joints->angle_rad[EXK_BETA],
                             joints->h_m};
}

/* Q = O1 + e w + f v + t tau. */
exk_err exk_machine_forward(const exk_kin *kin, const exk_joints *joints, exk_tool *out)
{
    const exk_tripod_pose pose = pose_of(joints);
    exk_attitude att;
    double tau[3], u[3], v[3], w[3];
    exk_err err = exk_attitude_of_pose(&kin->tripod, &pose, &att);
    if (err == EXK_OK) {
        err = exk_wrist_forward(kin->wrist, joints->wrist_rad, tau);
    }
    if (err != EXK_OK) {
        return err;
    }
    plate_axes(&att, u, v, w);
    exk_attitude_position(&kin->tripod, &att, out->tip_m);
    for (int i = 0; i < 3; i++) {
        out->axis[i] = u[i] * tau[0] + v[i] * tau[1] + w[i] * tau[2];
        out->tip_m[i] +=
            kin->geo.e_m * w[i] + kin->geo.f_m * v[i] + kin->geo.t_m * out->axis[i];
    }
    return EXK_OK;
}

exk_err exk_machine_legs(const exk_kin *kin, const exk_joints *joints,
                         double legs_m[EXK_N_LEGS])
{
    const exk_tripod_pose pose = pose_of(joints);
    return exk_tripod_legs(&kin->tripod, &pose, legs_m);
}

exk_err exk_machine_jacobian(const exk_kin *kin, const exk_tool *tool, double J[3][3])
{
    exk_attitude att;
    double legs_m[EXK_N_LEGS];
    exk_err err = place_plate(kin, tool, &att, legs_m);
    if (err == EXK_OK) {
        exk_attitude_jacobian_point(&kin->tripod, &att, legs_m, kin->geo.e_m, kin->geo.f_m, J);
    }
    return err;
}
