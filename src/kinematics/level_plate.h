/** Inside the room: what models P and U share, a level plate at O_e hung on constant bars. */
#ifndef EXK_KINEMATICS_LEVEL_PLATE_H
#define EXK_KINEMATICS_LEVEL_PLATE_H

#include "exk/kinematics.h"

/** EXK_ERR_ARG input not finite; EXK_ERR_UNREACHABLE axis not (0, 0, 1) within 1e-9, or the
 *  height outside (0, EXK_LENGTH_MAX_M]. */
exk_err exk_level_check_tool(const exk_tool *tool);

/** EXK_ERR_ARG an angle or h not finite; EXK_ERR_UNREACHABLE an angle of 90 deg or more, or h
 *  outside (0, EXK_LENGTH_MAX_M]. */
exk_err exk_level_check_joints(const exk_joints *joints);

/** EXK_ERR_LIMIT beyond EXK_PENDULUM_ANGLE_MAX_RAD. */
exk_err exk_level_check_angles(double alpha_rad, double beta_rad);

/** |A_i B_i| with B1,3 = O_e -+ (d3/2) e_x and B2 = O_e + d4 e_y. */
void exk_level_legs(const exk_geometry *geo, const double o_m[3], double legs_m[EXK_N_LEGS]);

#endif
