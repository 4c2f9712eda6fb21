/** Exact Exechon tripod (2 UPR + 1 SPR): three legs carry the plate point O1.
 *
 *  Equation  beta = atan2(y, z), r = |(y, z)|, s = r - d2 sin(beta), alpha = atan2(x, s),
 *            h = |(x, s)|;  O1 = (h sin(alpha), r sin(beta), r cos(beta)), r = h cos(alpha) + c
 *            with c = d2 sin(beta), a = d1/2, b = d3/2:
 *            Sigma = h^2 + a^2 + b^2 + c^2 + 2 (h c - a b) cos(alpha)
 *            D     = 2 (h a + b c) sin(alpha)
 *            l1^2 = Sigma + D,  l3^2 = Sigma - D,  l2^2 = h^2 + (d2 cos(beta) - d4)^2
 *  Source    docs/kinematics.md sections 3 to 7.
 *  Frames    base frame O; +alpha goes with +x, +beta with +y (beta is left-handed about X).
 *            Position fixes orientation: R_base_plate = Rx(-beta) Ry(alpha).
 *  Branch    h > 0, r > 0, z > 0, |alpha| and |beta| within the limit. At most one of the up to
 *            16 assemblies of three lengths is there.
 *  Singular  forward: G(alpha, beta, h) = 0; inverse: h = 0 or r = 0.
 *  Errors    in this order, by every function that checks a pose: EXK_ERR_ARG input not finite;
 *            EXK_ERR_UNREACHABLE farther than any leg direction can reach, or z <= 0, or r <= 0;
 *            EXK_ERR_SINGULAR h or r within 1e-6 m of zero, or margin below
 *            EXK_TRIPOD_MARGIN_MIN; EXK_ERR_LIMIT an angle or a leg beyond its limit.
 *  Units     metres, radians. Memory: exk_tripod is a plain value of constants made by init; all
 *            else is on the caller's stack. Outputs are written only on EXK_OK.
 */
#ifndef EXK_TRIPOD_H
#define EXK_TRIPOD_H

#include "exk/axes.h"
#include "exk/err.h"
#include "exk/geometry.h"

/* Smallest G/(a d2 h^3) that counts as regular; 1 at home, 0 on the singular surface. */
#define EXK_TRIPOD_MARGIN_MIN 1e-3

/* Bound of the Newton iteration; 7 steps are the most that any reachable pose was seen to need. */
enum { EXK_TRIPOD_STEPS_MAX = 8 };

/** Constants of one machine, computed once. Take every field as read-only. */
typedef struct {
    double a_m;     /* d1/2 */
    double b_m;     /* d3/2 */
    double d2_m;    /* |OA2| */
    double d4_m;    /* |O1B2| */
    double l_min_m; /* shortest leg */
    double l_max_m; /* longest leg */
    double reach_m; /* no assembly has O1 farther than this from O */
    double tan_max; /* tangent of the limit of |alpha| and |beta| */
} exk_tripod;

/** Globally regular coordinates of the plate. */
typedef struct {
    double alpha_rad;
    double beta_rad;
    double h_m; /* (O1 - A2) . w */
} exk_tripod_pose;

/** What the forward solver did. Written on success and on failure alike. */
typedef struct {
    int n_iter; /* Newton steps taken, of the last start tried */
    double
        residual_m; /* worst |leg asked - leg of the pose|; INFINITY where none was computed */
    int cold;       /* 1: from the cold start, 0: from the start given */
} exk_tripod_report;

/** Angles of the passive joints (docs/kinematics.md section 7). */
typedef struct {
    double u_first_rad;   /* legs 1 and 3, first axis, right-handed about X */
    double u1_second_rad; /* leg 1, second axis of the base joint */
    double u3_second_rad; /* leg 3, second axis of the base joint */
    double b1_rad;        /* R joint at B1 */
    double b3_rad;        /* R joint at B3 */
    double leg2_x_rad;    /* leg 2 seen along Y, from Z */
} exk_tripod_passive;

/** EXK_ERR_ARG when the geometry does not pass exk_geometry_check. */
exk_err exk_tripod_init(exk_tripod *tri, const exk_geometry *geo);

/** Lengths of the three legs from the position of O1, without any trigonometric call. */
exk_err exk_tripod_lengths(const exk_tripod *tri, const double o1_m[3],
                           double legs_m[EXK_N_LEGS]);

/** Pose and lengths from the position of O1. */
exk_err exk_tripod_inverse(const exk_tripod *tri, const double o1_m[3], exk_tripod_pose *pose,
                           double legs_m[EXK_N_LEGS]);

/** Lengths from a pose; every limit checked. */
exk_err exk_tripod_legs(const exk_tripod *tri, const exk_tripod_pose *pose,
                        double legs_m[EXK_N_LEGS]);

/** Position of O1 from a pose, closed form. EXK_ERR_ARG, or EXK_ERR_UNREACHABLE off the branch
 *  (h outside (0, EXK_LENGTH_MAX_M], r <= 0, an angle of 90 deg or more); checks no limit. */
exk_err exk_tripod_position(const exk_tripod *tri, const exk_tripod_pose *pose, double o1_m[3]);

/** Pose from three lengths, by Newton on (alpha, beta, h) and the squared lengths.
 *
 *  start   last pose, or NULL for a cold start, a pose estimated from the lengths. A start that
 *          is not finite, or leads to no good pose, is followed by a cold one.
 *  pose    within every limit; legs re-computed from it differ by report.residual_m.
 *  Errors  EXK_ERR_ARG a length not finite; EXK_ERR_LIMIT a length outside the stroke, or the
 *          pose found has an angle beyond its limit; EXK_ERR_SINGULAR the iteration ran into, or
 *          ended on, a singular pose; EXK_ERR_UNREACHABLE it ended on another assembly branch;
 *          EXK_ERR_NO_CONVERGE not down to rounding after EXK_TRIPOD_STEPS_MAX steps, or a residual
 *          above 1e-9 m (also the answer where the lengths close no assembly at all).
 *  report  may be NULL. */
exk_err exk_tripod_forward(const exk_tripod *tri, const double legs_m[EXK_N_LEGS],
                           const exk_tripod_pose *start, exk_tripod_pose *pose,
                           exk_tripod_report *report);

/** J[i][j] = d l_(i+1) / d (alpha, beta, h)_j: [m/rad], [m/rad], [1]. Checks the pose wholly. */
exk_err exk_tripod_jacobian_pose(const exk_tripod *tri, const exk_tripod_pose *pose,
                                 double J[3][3]);

/** J[i][j] = d l_(i+1) / d (x, y, z)_j of O1, [1]. Checks the pose wholly. */
exk_err exk_tripod_jacobian(const exk_tripod *tri, const double o1_m[3], double J[3][3]);

/** G [m^5], docs/kinematics.md 6.3: det dl/d(alpha, beta, h) = -2 G/(l1 l2 l3). NaN in, NaN out. */
double exk_tripod_G(const exk_tripod *tri, const exk_tripod_pose *pose);

/** G/(a d2 h^3): 1 at home, 0 on the forward-singular surface, negative beyond it. */
double exk_tripod_margin(const exk_tripod *tri, const exk_tripod_pose *pose);

/** Passive joint angles; the errors of exk_tripod_position. */
exk_err exk_tripod_passive_joints(const exk_tripod *tri, const exk_tripod_pose *pose,
                                  exk_tripod_passive *out);

#endif
