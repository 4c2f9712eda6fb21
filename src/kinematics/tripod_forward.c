/* Newton on (alpha, beta, h) for the squared lengths (docs/kinematics.md section 5), in the form
 *
 *   Sigma = (l1^2 + l3^2)/2,   D = (l1^2 - l3^2)/2,   h^2 + k^2 = l2^2,   k = d2 cos(beta) - d4
 *
 * which needs no square root, and whose third row has no alpha: h is eliminated by hand and two
 * equations are left. */
#include "exk/tripod.h"

#include <stddef.h>

#include "attitude.h"

/* The iteration ends when every squared length is this near, relative to their size: a hundred
 * times what rounding leaves, 5e-14 m on the default machine. */
#define CONVERGED 1e-13
#define RESIDUAL_MAX_M 1e-9
/* A determinant smaller than this part of its scale gives a step that means nothing. */
#define DETERMINANT_MIN 1e-12
/* Beyond 60 deg another branch may begin (section 5): geometry.h admits no larger limit. */
#define BRANCH_TAN 1.7320508075688772

enum { COLD_PASSES = 2 };

typedef struct {
    double sigma; /* (l1^2 + l3^2)/2 */
    double d;     /* (l1^2 - l3^2)/2 */
    double l2sq;
} squares;

static squares squares_of(const double legs_m[EXK_N_LEGS])
{
    const double l1sq = legs_m[0] * legs_m[0], l3sq = legs_m[2] * legs_m[2];
    return (squares){0.5 * (l1sq + l3sq), 0.5 * (l1sq - l3sq), legs_m[1] * legs_m[1]};
}

static double clamp(double value, double most)
{
    return fmax(-most, fmin(most, value));
}

/* A start from the lengths alone. Given sin(beta), the three equations of section 5 give in turn
 * h from l2, alpha from D and a better sin(beta) from Sigma, a quadratic in c = d2 sin(beta):
 *   c^2 + 2 h cos(alpha) c + h^2 + a^2 + b^2 - 2 a b cos(alpha) - Sigma = 0,
 * whose larger root has r = c + h cos(alpha) > 0. Twice round from beta = 0 comes near enough;
 * all is clamped to where a working pose can be. */
static exk_tripod_pose cold_start(const exk_tripod *tri, const squares *want)
{
    const double a = tri->a_m, b = tri->b_m, d2 = tri->d2_m;
    const double sin_max = tri->tan_max / sqrt(1.0 + tri->tan_max * tri->tan_max);
    double sb = 0.0, sa = 0.0, h = 0.0;
    for (int pass = 0; pass < COLD_PASSES; pass++) {
        const double k = d2 * sqrt(1.0 - sb * sb) - tri->d4_m;
        h = sqrt(fmax(want->l2sq - k * k, 0.01 * want->l2sq));
        sa = clamp(want->d / (2.0 * (h * a + b * d2 * sb)), sin_max);
        const double ca = sqrt(1.0 - sa * sa);
        const double rest = h * h + a * a + b * b - 2.0 * a * b * ca - want->sigma;
        const double root = sqrt(fmax(h * h * ca * ca - rest, 0.0));
        sb = clamp((root - h * ca) / d2, sin_max);
    }
    return (exk_tripod_pose){.alpha_rad = asin(sa), .beta_rad = asin(sb), .h_m = h};
}

static exk_attitude attitude_at(const exk_tripod_pose *pose)
{
    return (exk_attitude){
        .sa = sin(pose->alpha_rad),
        .ca = cos(pose->alpha_rad),
        .sb = sin(pose->beta_rad),
        .cb = cos(pose->beta_rad),
        .h = pose->h_m,
    };
}

/* What is missing: wanted minus present squares. */
static squares defect_at(const exk_tripod *tri, const exk_attitude *att, const squares *want)
{
    const double a = tri->a_m, b = tri->b_m, h = att->h;
    const double c = tri->d2_m * att->sb, k = tri->d2_m * att->cb - tri->d4_m;
    const double sigma = h * h + a * a + b * b + c * c + 2.0 * (h * c - a * b) * att->ca;
    const double d = 2.0 * (h * a + b * c) * att->sa;
    return (squares){want->sigma - sigma, want->d - d, want->l2sq - (h * h + k * k)};
}

/* One Newton step. From the third row dh = lift + tilt dbeta. */
static exk_err newton_step(const exk_tripod *tri, const exk_attitude *att,
                           const squares *defect, double scale, exk_tripod_pose *pose)
{
    const double a = tri->a_m, b = tri->b_m, h = att->h, sa = att->sa, ca = att->ca;
    const double c = tri->d2_m * att->sb, dc = tri->d2_m * att->cb;
    const double lift = 0.5 * defect->l2sq / h, tilt = (dc - tri->d4_m) * c / h;
    const double sigma_h = 2.0 * (h + c * ca), d_h = 2.0 * a * sa;
    const double m00 = -2.0 * (h * c - a * b) * sa, m10 = 2.0 * (h * a + b * c) * ca;
    const double m01 = 2.0 * dc * (c + h * ca) + tilt * sigma_h;
    const double m11 = 2.0 * b * dc * sa + tilt * d_h;
    const double y0 = defect->sigma - lift * sigma_h, y1 = defect->d - lift * d_h;
    const double det = m00 * m11 - m01 * m10;
    if (!(fabs(det) > DETERMINANT_MIN * scale * scale)) {
        return EXK_ERR_SINGULAR;
    }
    const double d_beta = (m00 * y1 - m10 * y0) / det;
    pose->alpha_rad += (y0 * m11 - y1 * m01) / det;
    pose->beta_rad += d_beta;
    pose->h_m += lift + tilt * d_beta;
    return EXK_OK;
}

static double worst_defect(const squares *defect)
{
    return fmax(fabs(defect->sigma) + fabs(defect->d), fabs(defect->l2sq));
}

/* Steps until the defect is down to rounding. A start that needs more steps than the bound is
 * given up, however near it came: the cold start then does better. */
static exk_err iterate(const exk_tripod *tri, const squares *want, exk_tripod_pose *pose,
                       exk_attitude *att, int *n_iter)
{
    for (int n = 0;; n++) {
        *n_iter = n;
        *att = attitude_at(pose);
        const squares defect = defect_at(tri, att, want);
        if (worst_defect(&defect) <= CONVERGED * want->sigma) {
            return EXK_OK;
        }
        if (n == EXK_TRIPOD_STEPS_MAX) {
            return EXK_ERR_NO_CONVERGE;
        }
        exk_err err = newton_step(tri, att, &defect, want->sigma, pose);
        if (err != EXK_OK) {
            return err;
        }
        if (!(pose->h_m > 0.0 && pose->h_m <= EXK_LENGTH_MAX_M)) {
            return EXK_ERR_UNREACHABLE;
        }
    }
}

static double residual_of(const exk_tripod *tri, const exk_attitude *att,
                          const double legs_m[EXK_N_LEGS])
{
    double found[EXK_N_LEGS];
    exk_attitude_lengths(tri, att, found);
    double worst = 0.0;
    for (int i = 0; i < EXK_N_LEGS; i++) {
        const double miss = fabs(found[i] - legs_m[i]);
        worst = miss <= worst ? worst : miss; /* keeps a NaN */
    }
    return worst;
}

/* The one assembly we may answer: h, r, z positive and both angles where it is unique. */
static exk_err check_branch(const exk_tripod *tri, const exk_attitude *att,
                            const exk_tripod_pose *pose)
{
    const double r = att->h * att->ca + tri->d2_m * att->sb;
    const bool working = fabs(pose->alpha_rad) < 0.5 * EXK_PI &&
                         fabs(pose->beta_rad) < 0.5 * EXK_PI &&
                         fabs(att->sa) <= BRANCH_TAN * att->ca &&
                         fabs(att->sb) <= BRANCH_TAN * att->cb && r > 0.0;
    return working ? exk_attitude_check_angles(tri, att) : EXK_ERR_UNREACHABLE;
}

static exk_err solve_from(const exk_tripod *tri, const double legs_m[EXK_N_LEGS],
                          const squares *want, exk_tripod_pose *pose, exk_tripod_report *report)
{
    exk_attitude att;
    report->residual_m = INFINITY;
    exk_err err = iterate(tri, want, pose, &att, &report->n_iter);
    if (err != EXK_OK) {
        return err;
    }
    report->residual_m = residual_of(tri, &att, legs_m);
    if (!(report->residual_m <= RESIDUAL_MAX_M)) {
        return EXK_ERR_NO_CONVERGE;
    }
    return check_branch(tri, &att, pose);
}

static bool usable(const exk_tripod_pose *start)
{
    return start != NULL && isfinite(start->alpha_rad) && isfinite(start->beta_rad) &&
           start->h_m > 0.0 && start->h_m <= EXK_LENGTH_MAX_M;
}

exk_err exk_tripod_forward(const exk_tripod *tri, const double legs_m[EXK_N_LEGS],
                           const exk_tripod_pose *start, exk_tripod_pose *pose,
                           exk_tripod_report *report)
{
    exk_tripod_report own;
    exk_tripod_report *said = report != NULL ? report : &own;
    *said = (exk_tripod_report){.n_iter = 0, .residual_m = INFINITY, .cold = 0};
    exk_err err = exk_stroke_check(tri, legs_m);
    if (err != EXK_OK) {
        return exk_bad_point(legs_m, err);
    }
    const squares want = squares_of(legs_m);
    exk_tripod_pose found;
    err = EXK_ERR_NO_CONVERGE;
    if (usable(start)) {
        found = *start;
        err = solve_from(tri, legs_m, &want, &found, said);
    }
    if (err != EXK_OK) {
        said->cold = 1;
        found = cold_start(tri, &want);
        err = solve_from(tri, legs_m, &want, &found, said);
    }
    if (err == EXK_OK) {
        *pose = found;
    }
    return err;
}
