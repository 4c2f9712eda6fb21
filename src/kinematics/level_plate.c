#include "level_plate.h"

#include <math.h>

#include "exk/pendulum.h"
#include "exk/units.h"
#include "exk/vec3.h"

#define AXIS_SLACK 1e-9

exk_err exk_level_check_tool(const exk_tool *tool)
{
    if (!(exk_finite3(tool->tip_m) && exk_finite3(tool->axis))) {
        return EXK_ERR_ARG;
    }
    const bool upright = fabs(tool->axis[0]) <= AXIS_SLACK &&
                         fabs(tool->axis[1]) <= AXIS_SLACK &&
                         fabs(tool->axis[2] - 1.0) <= AXIS_SLACK;
    const bool in_height = tool->tip_m[2] > 0.0 && tool->tip_m[2] <= EXK_LENGTH_MAX_M;
    return upright && in_height ? EXK_OK : EXK_ERR_UNREACHABLE;
}

exk_err exk_level_check_joints(const exk_joints *joints)
{
    const double alpha = joints->angle_rad[EXK_ALPHA], beta = joints->angle_rad[EXK_BETA];
    const double h = joints->h_m;
    if (fabs(alpha) < 0.5 * EXK_PI && fabs(beta) < 0.5 * EXK_PI && h > 0.0 &&
        h <= EXK_LENGTH_MAX_M) {
        return EXK_OK;
    }
    const bool finite = isfinite(alpha) && isfinite(beta) && isfinite(h);
    return finite ? EXK_ERR_UNREACHABLE : EXK_ERR_ARG;
}

exk_err exk_level_check_angles(double alpha_rad, double beta_rad)
{
    const bool inside = fabs(alpha_rad) <= EXK_PENDULUM_ANGLE_MAX_RAD &&
                        fabs(beta_rad) <= EXK_PENDULUM_ANGLE_MAX_RAD;
    return inside ? EXK_OK : EXK_ERR_LIMIT;
}

void exk_level_legs(const exk_geometry *geo, const double o_m[3], double legs_m[EXK_N_LEGS])
{
    const double x = o_m[0], z = o_m[2];
    const double gap = 0.5 * (geo->d1_m - geo->d3_m);
    const double yz2 = o_m[1] * o_m[1] + z * z;
    const double y2 = o_m[1] + geo->d4_m - geo->d2_m;
    legs_m[0] = sqrt((x + gap) * (x + gap) + yz2);
    legs_m[1] = sqrt(x * x + y2 * y2 + z * z);
    legs_m[2] = sqrt((x - gap) * (x - gap) + yz2);
}
