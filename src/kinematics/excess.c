#include "exk/excess.h"

#include <math.h>

static exk_kin without_limits(const exk_kin *kin)
{
    exk_kin wide = *kin;
    wide.tripod.l_min_m = 0.0;
    wide.tripod.l_max_m = EXK_LENGTH_MAX_M;
    wide.tripod.reach_m = EXK_LENGTH_MAX_M;
    wide.tripod.tan_max = (double)INFINITY;
    return wide;
}

static bool find_angle(const exk_kin *kin, const exk_joints *joints, exk_excess *out)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        const double angle_rad = joints->angle_rad[i];
        if (!(fabs(angle_rad) <= kin->geo.angle_max_rad)) {
            *out =
                (exk_excess){false, i, angle_rad, copysign(kin->geo.angle_max_rad, angle_rad)};
            return true;
        }
    }
    return false;
}

static bool find_leg(const exk_kin *kin, const double legs_m[EXK_N_LEGS], exk_excess *out)
{
    for (int i = 0; i < EXK_N_LEGS; i++) {
        const bool is_short = legs_m[i] < kin->tripod.l_min_m;
        if (is_short || !(legs_m[i] <= kin->tripod.l_max_m)) {
            *out = (exk_excess){true, i, legs_m[i],
                                is_short ? kin->tripod.l_min_m : kin->tripod.l_max_m};
            return true;
        }
    }
    return false;
}

bool exk_excess_of_joints(const exk_kin *kin, const exk_joints *joints, exk_excess *out)
{
    double legs_m[EXK_N_LEGS];
    const exk_kin wide = without_limits(kin);
    if (kin->model != EXK_KIN_MACHINE || exk_kin_legs(&wide, joints, legs_m) != EXK_OK) {
        return false;
    }
    return find_angle(kin, joints, out) || find_leg(kin, legs_m, out);
}

bool exk_excess_of_tool(const exk_kin *kin, const exk_tool *tool, exk_excess *out)
{
    exk_joints joints;
    const exk_kin wide = without_limits(kin);
    return kin->model == EXK_KIN_MACHINE && exk_kin_inverse(&wide, tool, &joints) == EXK_OK &&
           exk_excess_of_joints(kin, &joints, out);
}
