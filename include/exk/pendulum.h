/** Paper model P: each bar group is a pendulum of constant length, the plate stays level.
 *
 *  Equation  x = L2 sin(alpha),  y = R sin(beta),  z = R cos(beta)
 *            R = h,  L2 = sqrt(h^2 + (d2 - d4)^2),  h: the working height of the plate
 *            dx/dalpha = L2 cos(alpha),  dy/dbeta = R cos(beta),  the rest zero
 *  Source    docs/kinematics.md section 10; why this model: docs/adr/0002-model-p.md.
 *  Feed      a feed in z at fixed (x, y) is a change of h with both angles recomputed. The
 *            inverse therefore reads h from the tip's z, while the forward returns the z of the
 *            swung bar, R cos(beta): x and y make the round trip, z does so on the centre line.
 *  Branch    both cosines positive. Singular where a bar lies level; the limit keeps clear of it.
 *  Errors    inverse: EXK_ERR_ARG input not finite; EXK_ERR_UNREACHABLE |x| >= L2, |y| >= R,
 *            h outside (0, EXK_LENGTH_MAX_M], tool axis not (0, 0, 1) within 1e-9;
 *            EXK_ERR_LIMIT an angle beyond EXK_PENDULUM_ANGLE_MAX_RAD.
 *            forward, legs, Jacobian: ARG as above; UNREACHABLE h as above, or an angle of
 *            90 deg or more. They check no limit: a disturbed angle is still drawn.
 *  Units     metres, radians, base frame. Memory: no state; outputs written only on EXK_OK.
 */
#ifndef EXK_PENDULUM_H
#define EXK_PENDULUM_H

#include "exk/kinematics.h"

/* Limit of |alpha| and |beta| in the inverse of P and U (docs/kinematics.md section 10). */
#define EXK_PENDULUM_ANGLE_MAX_RAD 0.6

extern const exk_kin_ops exk_pendulum_ops;

exk_err exk_pendulum_inverse(const exk_kin *kin, const exk_tool *tool, exk_joints *out);
exk_err exk_pendulum_forward(const exk_kin *kin, const exk_joints *joints, exk_tool *out);

/** |A_i B_i| with B1,3 = O_e -+ (d3/2) e_x and B2 = O_e + d4 e_y, the level plate as drawn. */
exk_err exk_pendulum_legs(const exk_kin *kin, const exk_joints *joints,
                          double legs_m[EXK_N_LEGS]);

/** J = d(x, y)/d(alpha, beta), row-major 2 x 2, [m/rad]. */
exk_err exk_pendulum_jacobian(const exk_kin *kin, const exk_joints *joints, double J[2][2]);

#endif
