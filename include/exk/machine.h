/** Five-axis machine: exact tripod and a two-axis wrist.
 *
 *  Equation  S = Q - t tau,  S = O1 + e w + f v;  with rho = |(Sy, Sz)|:
 *            beta = atan2(Sy, Sz) - asin(f/rho),  rS = sqrt(rho^2 - f^2),
 *            s = rS - d2 sin(beta),  alpha = atan2(Sx, s),  h = |(Sx, s)| - e,
 *            tau_plate = R^T tau -> wrist angles
 *  Source    docs/kinematics.md section 8. Position still decouples from orientation: no iteration.
 *  Frames    base frame; Q is the tool tip, tau the unit tool direction.
 *  Branch    that of the tripod and of the wrist chosen.
 *  Errors    inverse: EXK_ERR_ARG not finite, or |tau| off 1 by more than 1e-9; then those of
 *            tripod.h and wrist.h. forward: EXK_ERR_ARG not finite; EXK_ERR_UNREACHABLE off
 *            the branch; no limit. legs: those of exk_tripod_legs.
 *  Units     metres, radians. Memory: no state; outputs written only on EXK_OK.
 */
#ifndef EXK_MACHINE_H
#define EXK_MACHINE_H

#include "exk/kinematics.h"

extern const exk_kin_ops exk_machine_ops;

exk_err exk_machine_inverse(const exk_kin *kin, const exk_tool *tool, exk_joints *out);
exk_err exk_machine_forward(const exk_kin *kin, const exk_joints *joints, exk_tool *out);
exk_err exk_machine_legs(const exk_kin *kin, const exk_joints *joints,
                         double legs_m[EXK_N_LEGS]);

/** J[i][j] = d l_(i+1) / d Q_j at a fixed tool axis, [1]; the errors of the inverse. */
exk_err exk_machine_jacobian(const exk_kin *kin, const exk_tool *tool, double J[3][3]);

#endif
