/** Alternative model U: one universal-joint pendulum of radius R about O, level plate.
 *
 *  Equation  (x, y, z) = R ( sin(alpha), cos(alpha) sin(beta), cos(alpha) cos(beta) ),  R = h
 *            alpha = asin(x/R),  beta = atan2(y, sqrt(R^2 - x^2 - y^2))
 *            d(x, y) = R [ cos(alpha), 0 ; -sin(alpha) sin(beta), cos(alpha) cos(beta) ]
 *  Source    docs/kinematics.md section 10. A sensitivity check of what is concluded with P; it uses
 *            bars 1 and 3 alone and does not set X before Y at the centre.
 *  Feed      as in P (pendulum.h): the inverse reads h from the tip's z, the forward returns the
 *            z of the swung bar.
 *  Errors    those of P, with UNREACHABLE where x^2 + y^2 >= R^2; the same angle limit.
 *  Units     metres, radians, base frame. Memory: no state; outputs written only on EXK_OK.
 */
#ifndef EXK_UNIVERSAL_H
#define EXK_UNIVERSAL_H

#include "exk/kinematics.h"

extern const exk_kin_ops exk_universal_ops;

exk_err exk_universal_inverse(const exk_kin *kin, const exk_tool *tool, exk_joints *out);
exk_err exk_universal_forward(const exk_kin *kin, const exk_joints *joints, exk_tool *out);
exk_err exk_universal_legs(const exk_kin *kin, const exk_joints *joints,
                           double legs_m[EXK_N_LEGS]);

/** J = d(x, y)/d(alpha, beta), row-major 2 x 2, [m/rad]. */
exk_err exk_universal_jacobian(const exk_kin *kin, const exk_joints *joints, double J[2][2]);

#endif
