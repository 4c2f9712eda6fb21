#include "exk/tripod.h"

#include "attitude.h"

/* Section 6.1: l1^2 = Sigma + D, l3^2 = Sigma - D, l2^2 = h^2 + k^2. */
void exk_attitude_jacobian(const exk_tripod *tri, const exk_attitude *att,
                           const double legs_m[EXK_N_LEGS], double J[3][3])
{
    const double a = tri->a_m, b = tri->b_m, d2 = tri->d2_m, h = att->h;
    const double sa = att->sa, ca = att->ca;
    const double c = d2 * att->sb, dc = d2 * att->cb;
    const double k = dc - tri->d4_m;
    const double d_sigma[3] = {-2.0 * (h * c - a * b) * sa, 2.0 * dc * (c + h * ca),
                               2.0 * (h + c * ca)};
    const double d_d[3] = {2.0 * (h * a + b * c) * ca, 2.0 * b * dc * sa, 2.0 * a * sa};
    const double half_d_l2_squared[3] = {0.0, -k * c, h};
    for (int j = 0; j < 3; j++) {
        J[0][j] = 0.5 * (d_sigma[j] + d_d[j]) / legs_m[0];
        J[1][j] = half_d_l2_squared[j] / legs_m[1];
        J[2][j] = 0.5 * (d_sigma[j] - d_d[j]) / legs_m[2];
    }
}

/* Gradients of alpha, beta, h with respect to S. With rS the reach of S along e_r and
 * hS = h + e:  grad beta = v/rS,  grad s = e_r + (f - d2 cos(beta)) grad beta,
 * grad alpha = (cos(alpha) e_x - sin(alpha) grad s)/hS,
 * grad h = sin(alpha) e_x + cos(alpha) grad s. */
static void gradients(const exk_tripod *tri, const exk_attitude *att, double e, double f,
                      double grad[3][3])
{
    const double hs = att->h + e;
    const double rs = hs * att->ca + tri->d2_m * att->sb;
    const double bend = (f - tri->d2_m * att->cb) / rs;
    const double v[3] = {0.0, att->cb, -att->sb};
    const double e_r[3] = {0.0, att->sb, att->cb};
    const double e_x[3] = {1.0, 0.0, 0.0};
    for (int j = 0; j < 3; j++) {
        const double grad_s = e_r[j] + bend * v[j];
        grad[0][j] = (att->ca * e_x[j] - att->sa * grad_s) / hs;
        grad[1][j] = v[j] / rs;
        grad[2][j] = att->sa * e_x[j] + att->ca * grad_s;
    }
}

void exk_attitude_jacobian_point(const exk_tripod *tri, const exk_attitude *att,
                                 const double legs_m[EXK_N_LEGS], double e, double f,
                                 double J[3][3])
{
    double by_pose[3][3], grad[3][3];
    exk_attitude_jacobian(tri, att, legs_m, by_pose);
    gradients(tri, att, e, f, grad);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            J[i][j] = by_pose[i][0] * grad[0][j] + by_pose[i][1] * grad[1][j] +
                      by_pose[i][2] * grad[2][j];
        }
    }
}

exk_err exk_tripod_jacobian_pose(const exk_tripod *tri, const exk_tripod_pose *pose,
                                 double J[3][3])
{
    exk_attitude att;
    double legs_m[EXK_N_LEGS];
    exk_err err = exk_attitude_of_pose(tri, pose, &att);
    if (err == EXK_OK) {
        err = exk_attitude_legs(tri, &att, legs_m);
    }
    if (err == EXK_OK) {
        exk_attitude_jacobian(tri, &att, legs_m, J);
    }
    return err;
}

exk_err exk_tripod_jacobian(const exk_tripod *tri, const double o1_m[3], double J[3][3])
{
    exk_attitude att;
    double legs_m[EXK_N_LEGS];
    exk_err err = exk_attitude_of_point(tri, o1_m, 0.0, 0.0, &att);
    if (err == EXK_OK) {
        err = exk_attitude_legs(tri, &att, legs_m);
    }
    if (err == EXK_OK) {
        exk_attitude_jacobian_point(tri, &att, legs_m, 0.0, 0.0, J);
    }
    return err;
}
