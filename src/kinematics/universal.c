#include "exk/universal.h"

#include <math.h>

#include "level_plate.h"

const exk_kin_ops exk_universal_ops = {
    .name = "universal",
    .inverse = exk_universal_inverse,
    .forward = exk_universal_forward,
    .legs = exk_universal_legs,
};

static void plate(const exk_joints *joints, double o_m[3])
{
    const double R = joints->h_m;
    const double alpha = joints->angle_rad[EXK_ALPHA], beta = joints->angle_rad[EXK_BETA];
    const double arm = R * cos(alpha);
    o_m[0] = R * sin(alpha);
    o_m[1] = arm * sin(beta);
    o_m[2] = arm * cos(beta);
}

exk_err exk_universal_inverse(const exk_kin *kin, const exk_tool *tool, exk_joints *out)
{
    (void)kin;
    exk_err err = exk_level_check_tool(tool);
    if (err != EXK_OK) {
        return err;
    }
    const double x = tool->tip_m[0], y = tool->tip_m[1], R = tool->tip_m[2];
    const double z2 = (R - x) * (R + x) - y * y;
    if (!(z2 > 0.0)) {
        return EXK_ERR_UNREACHABLE;
    }
    const double alpha = asin(x / R), beta = atan2(y, sqrt(z2));
    err = exk_level_check_angles(alpha, beta);
    if (err == EXK_OK) {
        *out = (exk_joints){.angle_rad = {alpha, beta}, .h_m = R};
    }
    return err;
}

exk_err exk_universal_forward(const exk_kin *kin, const exk_joints *joints, exk_tool *out)
{
    (void)kin;
    exk_err err = exk_level_check_joints(joints);
    if (err == EXK_OK) {
        *out = (exk_tool){.axis = {0.0, 0.0, 1.0}};
        plate(joints, out->tip_m);
    }
    return err;
}

exk_err exk_universal_legs(const exk_kin *kin, const exk_joints *joints,
                           double legs_m[EXK_N_LEGS])
{
    exk_err err = exk_level_check_joints(joints);
    if (err == EXK_OK) {
        double o_m[3];
        plate(joints, o_m);
        exk_level_legs(&kin->geo, o_m, legs_m);
    }
    return err;
}

exk_err exk_universal_jacobian(const exk_kin *kin, const exk_joints *joints, double J[2][2])
{
    (void)kin;
    exk_err err = exk_level_check_joints(joints);
    if (err == EXK_OK) {
        const double R = joints->h_m;
        const double alpha = joints->angle_rad[EXK_ALPHA], beta = joints->angle_rad[EXK_BETA];
        J[0][0] = R * cos(alpha);
        J[0][1] = 0.0;
        J[1][0] = -R * sin(alpha) * sin(beta);
        J[1][1] = R * cos(alpha) * cos(beta);
    }
    return err;
}
