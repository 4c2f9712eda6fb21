/** Two-axis wrists that turn the tool against the plate.
 *
 *  Equation  AB: tau_plate = Rx(t4) Ry(t5) e_z,  t4 = atan2(-y, z),  t5 = asin(x)
 *            CA: tau_plate = Rz(t4) Rx(t5) e_z,  t4 = atan2(x, -y),  t5 = atan2(|(x, y)|, z)
 *  Source    docs/kinematics.md section 8. AB is the default; CA is singular with the tool along w,
 *            which for holes along Z is the centre of the workspace.
 *  Branch    AB: |t5| < 90 deg; CA: t5 > 0 (the other solution is (t4 + pi, -t5)).
 *  Frames    plate frame (u, v, w), w toward the tool; tau is the unit tool direction.
 *  Errors    EXK_ERR_SINGULAR |cos(t5)| (AB) or |sin(t5)| (CA) below EXK_WRIST_SINGULAR;
 *            EXK_ERR_LIMIT tau . w <= 0, a tool that points back at the plate;
 *            EXK_ERR_ARG not finite, or no such wrist.
 *  Units     radians. Memory: no state; outputs written only on EXK_OK.
 */
#ifndef EXK_WRIST_H
#define EXK_WRIST_H

#include "exk/err.h"
#include "exk/kinematics.h"

/* Nearer to the singular direction than this [rad], t4 means nothing. */
#define EXK_WRIST_SINGULAR 1e-4

/** tau must be a unit vector; exk_machine_inverse has checked it. */
exk_err exk_wrist_inverse(exk_wrist_kind wrist, const double tau_plate[3],
                          double wrist_rad[EXK_N_WRIST]);

/** Any finite angles. */
exk_err exk_wrist_forward(exk_wrist_kind wrist, const double wrist_rad[EXK_N_WRIST],
                          double tau_plate[3]);

const char *exk_wrist_name(exk_wrist_kind wrist); /* "AB", "CA"; never NULL */

#endif
