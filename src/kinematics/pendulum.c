#include "exk/pendulum.h"

#include <math.h>

#include "level_plate.h"

const exk_kin_ops exk_pendulum_ops = {
    .name = "pendulum",
    .inverse = exk_pendulum_inverse,
    .forward = exk_pendulum_forward,
    .legs = exk_pendulum_legs,
};

/* Length of bar 2 at the working height h: the bars end on a plate d2 - d4 nearer. */
static double bar2_m(const exk_kin *kin, double h)
{
    const double gap = kin->geo.d2_m - kin->geo.d4_m;
    return sqrt(h * h + gap * gap);
}

static void plate(const exk_kin *kin, const exk_joints *joints, double o_m[3])
{
    const double h = joints->h_m, beta = joints->angle_rad[EXK_BETA];
    o_m[0] = bar2_m(kin, h) * sin(joints->angle_rad[EXK_ALPHA]);
    o_m[1] = h * sin(beta);
    o_m[2] = h * cos(beta);
}

exk_err exk_pendulum_inverse(const exk_kin *kin, const exk_tool *tool, exk_joints *out)
{
    exk_err err = exk_level_check_tool(tool);
    if (err != EXK_OK) {
        return err;
    }
    const double h = tool->tip_m[2];
    const double sin_alpha = tool->tip_m[0] / bar2_m(kin, h), sin_beta = tool->tip_m[1] / h;
    if (!(fabs(sin_alpha) < 1.0 && fabs(sin_beta) < 1.0)) {
        return EXK_ERR_UNREACHABLE;
    }
    const double alpha = asin(sin_alpha), beta = asin(sin_beta);
    err = exk_level_check_angles(alpha, beta);
    if (err == EXK_OK) {
        *out = (exk_joints){.angle_rad = {alpha, beta}, .h_m = h};
    }
    return err;
}

exk_err exk_pendulum_forward(const exk_kin *kin, const exk_joints *joints, exk_tool *out)
{
    exk_err err = exk_level_check_joints(joints);
    if (err == EXK_OK) {
        *out = (exk_tool){.axis = {0.0, 0.0, 1.0}};
        plate(kin, joints, out->tip_m);
    }
    return err;
}

exk_err exk_pendulum_legs(const exk_kin *kin, const exk_joints *joints,
                          double legs_m[EXK_N_LEGS])
{
    exk_err err = exk_level_check_joints(joints);
    if (err == EXK_OK) {
        double o_m[3];
        plate(kin, joints, o_m);
        exk_level_legs(&kin->geo, o_m, legs_m);
    }
    return err;
}

exk_err exk_pendulum_jacobian(const exk_kin *kin, const exk_joints *joints, double J[2][2])
{
    exk_err err = exk_level_check_joints(joints);
    if (err == EXK_OK) {
        J[0][0] = bar2_m(kin, joints->h_m) * cos(joints->angle_rad[EXK_ALPHA]);
        J[0][1] = 0.0;
        J[1][0] = 0.0;
        J[1][1] = joints->h_m * cos(joints->angle_rad[EXK_BETA]);
    }
    return err;
}
