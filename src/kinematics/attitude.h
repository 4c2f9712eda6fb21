/** Inside the room: the plate of the tripod as sines and cosines, so that the hot path from a
 *  position to leg lengths needs square roots alone. Symbols as in docs/kinematics.md 3 to 6.
 *
 *  A point fixed in the plate, S = O1 + e w + f v, obeys the same relations as O1 with h + e in
 *  place of h; the tripod (e = f = 0) and the wrist centre therefore share this code.
 */
#ifndef EXK_KINEMATICS_ATTITUDE_H
#define EXK_KINEMATICS_ATTITUDE_H

#include <math.h>

#include "exk/tripod.h"
#include "exk/units.h"
#include "exk/vec3.h"

/* h or r nearer to zero than this is a singular pose: alpha or beta is free there. */
#define EXK_NEAR_ZERO_M 1e-6

typedef struct {
    double sa, ca; /* sin, cos of alpha */
    double sb, cb; /* sin, cos of beta */
    double h;      /* (O1 - A2) . w [m] */
    double x, s;   /* of the point S: alpha = atan2(x, s) */
    double y, z;   /* beta = atan2(y, z), scaled by |(Sy, Sz)|, so no cheaper form is lost */
} exk_attitude;

/* The failing path of a check that NaN fails: what is not finite is a bad argument. */
static inline exk_err exk_bad_point(const double p[3], exk_err otherwise)
{
    return exk_finite3(p) ? otherwise : EXK_ERR_ARG;
}

/** Attitude of the plate from the point S; e and f [m] place S in it. */
static inline exk_err exk_attitude_of_point(const exk_tripod *tri, const double p_m[3],
                                            double e, double f, exk_attitude *att)
{
    const double x = p_m[0], y = p_m[1], z = p_m[2];
    const double rho2 = y * y + z * z;
    const double reach = tri->reach_m + e + fabs(f);
    if (!(x * x + rho2 <= reach * reach)) {
        return exk_bad_point(p_m, EXK_ERR_UNREACHABLE);
    }
    const double r2 = rho2 - f * f;
    if (!(r2 > EXK_NEAR_ZERO_M * EXK_NEAR_ZERO_M)) {
        return f == 0.0 ? EXK_ERR_SINGULAR : EXK_ERR_UNREACHABLE;
    }
    const double r = sqrt(r2);
    att->y = y * r - z * f;
    att->z = z * r + y * f;
    if (!(att->z > 0.0)) {
        return EXK_ERR_UNREACHABLE;
    }
    att->sb = att->y / rho2;
    att->cb = att->z / rho2;
    att->x = x;
    att->s = r - tri->d2_m * att->sb;
    const double hs2 = x * x + att->s * att->s;
    const double hs = sqrt(hs2);
    att->h = hs - e;
    if (!(att->h > EXK_NEAR_ZERO_M)) {
        return att->h < -EXK_NEAR_ZERO_M ? EXK_ERR_UNREACHABLE : EXK_ERR_SINGULAR;
    }
    const double per_hs = hs / hs2;
    att->sa = x * per_hs;
    att->ca = att->s * per_hs;
    return r - e * att->ca > 0.0 ? EXK_OK : EXK_ERR_UNREACHABLE; /* r of O1 itself */
}

/** Attitude from a pose; the domain of the working branch, no limit. Fills no x, s, y, z. */
static inline exk_err exk_attitude_of_pose(const exk_tripod *tri, const exk_tripod_pose *pose,
                                           exk_attitude *att)
{
    const double alpha = pose->alpha_rad, beta = pose->beta_rad, h = pose->h_m;
    if (!(fabs(alpha) < 0.5 * EXK_PI && fabs(beta) < 0.5 * EXK_PI && h > 0.0 &&
          h <= EXK_LENGTH_MAX_M)) {
        return exk_bad_point((const double[3]){alpha, beta, h}, EXK_ERR_UNREACHABLE);
    }
    att->sa = sin(alpha);
    att->ca = cos(alpha);
    att->sb = sin(beta);
    att->cb = cos(beta);
    att->h = h;
    const double r = h * att->ca + tri->d2_m * att->sb;
    return r > 0.0 ? EXK_OK : EXK_ERR_UNREACHABLE;
}

/* O1 = (h sin(alpha), r sin(beta), r cos(beta)), r = h cos(alpha) + d2 sin(beta). */
static inline void exk_attitude_position(const exk_tripod *tri, const exk_attitude *att,
                                         double o1_m[3])
{
    const double r = att->h * att->ca + tri->d2_m * att->sb;
    o1_m[0] = att->h * att->sa;
    o1_m[1] = r * att->sb;
    o1_m[2] = r * att->cb;
}

/* Section 4. The radicands are sums of squares; rounding cannot turn them negative in range. */
static inline void exk_attitude_lengths(const exk_tripod *tri, const exk_attitude *att,
                                        double legs_m[EXK_N_LEGS])
{
    const double a = tri->a_m, b = tri->b_m, h = att->h;
    const double c = tri->d2_m * att->sb;
    const double k = tri->d2_m * att->cb - tri->d4_m;
    const double sigma = h * h + a * a + b * b + c * c + 2.0 * (h * c - a * b) * att->ca;
    const double d = 2.0 * (h * a + b * c) * att->sa;
    legs_m[0] = sqrt(sigma + d);
    legs_m[1] = sqrt(h * h + k * k);
    legs_m[2] = sqrt(sigma - d);
}

/* G of section 6.3 [m^5]. */
static inline double exk_attitude_G(const exk_tripod *tri, const exk_attitude *att)
{
    const double a = tri->a_m, b = tri->b_m, d2 = tri->d2_m, h = att->h;
    const double c = d2 * att->sb;
    const double k = d2 * att->cb - tri->d4_m;
    const double p = (h * a + b * c) * att->ca;
    const double q = (h * c - a * b) * att->sa * att->sa;
    return d2 * att->sb * k * (p * (h + c * att->ca) + a * q) +
           h * d2 * att->cb * (p * (c + h * att->ca) + b * q);
}

/* The scale of G: its value at home. */
static inline double exk_attitude_G_home(const exk_tripod *tri, double h)
{
    return tri->a_m * tri->d2_m * h * h * h;
}

static inline exk_err exk_attitude_check_angles(const exk_tripod *tri, const exk_attitude *att)
{
    const double least = EXK_TRIPOD_MARGIN_MIN * exk_attitude_G_home(tri, att->h);
    if (!(exk_attitude_G(tri, att) > least)) {
        return EXK_ERR_SINGULAR;
    }
    const bool inside =
        fabs(att->sa) <= tri->tan_max * att->ca && fabs(att->sb) <= tri->tan_max * att->cb;
    return inside ? EXK_OK : EXK_ERR_LIMIT;
}

static inline exk_err exk_stroke_check(const exk_tripod *tri, const double legs_m[EXK_N_LEGS])
{
    for (int i = 0; i < EXK_N_LEGS; i++) {
        if (!(legs_m[i] >= tri->l_min_m && legs_m[i] <= tri->l_max_m)) {
            return EXK_ERR_LIMIT;
        }
    }
    return EXK_OK;
}

/** Lengths of an attitude on the branch, singularity and every limit checked. */
static inline exk_err exk_attitude_legs(const exk_tripod *tri, const exk_attitude *att,
                                        double legs_m[EXK_N_LEGS])
{
    double found[EXK_N_LEGS];
    exk_attitude_lengths(tri, att, found);
    exk_err err = exk_attitude_check_angles(tri, att);
    if (err == EXK_OK) {
        err = exk_stroke_check(tri, found);
    }
    if (err == EXK_OK) {
        exk_copy3(found, legs_m);
    }
    return err;
}

/** dl/d(alpha, beta, h), section 6.1. legs_m: the lengths of att. */
void exk_attitude_jacobian(const exk_tripod *tri, const exk_attitude *att,
                           const double legs_m[EXK_N_LEGS], double J[3][3]);

/** dl/dS for the point S = O1 + e w + f v of the plate; e = f = 0 is section 6.2. */
void exk_attitude_jacobian_point(const exk_tripod *tri, const exk_attitude *att,
                                 const double legs_m[EXK_N_LEGS], double e, double f,
                                 double J[3][3]);

#endif
