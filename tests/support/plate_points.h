/** The tripod as points in space, the long way round: the plate's matrix, its joint centres and
 *  plain distances (docs/kinematics.md sections 1 and 3). Shares no formula with the room but the
 *  pose itself; used as the other side of a comparison. */
#ifndef EXK_TESTS_PLATE_POINTS_H
#define EXK_TESTS_PLATE_POINTS_H

#include <math.h>
#include <stdbool.h>

#include "exk/geometry.h"
#include "exk/vec3.h"

/* Columns u, v, w of Rx(-beta) Ry(alpha), multiplied out. */
static inline void plate_matrix(double alpha, double beta, double R[3][3])
{
    const double Rx[3][3] = {
        {1, 0, 0}, {0, cos(-beta), -sin(-beta)}, {0, sin(-beta), cos(-beta)}};
    const double Ry[3][3] = {
        {cos(alpha), 0, sin(alpha)}, {0, 1, 0}, {-sin(alpha), 0, cos(alpha)}};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            R[i][j] = Rx[i][0] * Ry[0][j] + Rx[i][1] * Ry[1][j] + Rx[i][2] * Ry[2][j];
        }
    }
}

/* p of the plate frame (origin O1) in the base frame. */
static inline void plate_point(const double o1_m[3], double R[3][3], double u, double v,
                               double w, double out_m[3])
{
    for (int i = 0; i < 3; i++) {
        out_m[i] = o1_m[i] + R[i][0] * u + R[i][1] * v + R[i][2] * w;
    }
}

static inline double distance(const double a[3], const double b[3])
{
    double d[3];
    exk_add_scaled3(a, -1.0, b, d);
    return exk_norm3(d);
}

/* Leg lengths of a plate at o1_m turned by alpha and beta. */
static inline void plate_legs(const exk_geometry *geo, const double o1_m[3], double alpha,
                              double beta, double legs_m[3])
{
    const double A1[3] = {-0.5 * geo->d1_m, 0, 0}, A3[3] = {0.5 * geo->d1_m, 0, 0};
    const double A2[3] = {0, geo->d2_m, 0};
    double R[3][3], B1[3], B2[3], B3[3];
    plate_matrix(alpha, beta, R);
    plate_point(o1_m, R, -0.5 * geo->d3_m, 0, 0, B1);
    plate_point(o1_m, R, 0, geo->d4_m, 0, B2);
    plate_point(o1_m, R, 0.5 * geo->d3_m, 0, 0, B3);
    legs_m[0] = distance(A1, B1);
    legs_m[1] = distance(A2, B2);
    legs_m[2] = distance(A3, B3);
}

/* The angles that the constraints C1 to C3 leave at a position: u . (O1 - A2) = 0. */
static inline void plate_angles(const exk_geometry *geo, const double o1_m[3], double *alpha,
                                double *beta)
{
    *beta = atan2(o1_m[1], o1_m[2]);
    const double e_r = cos(*beta) * o1_m[2] + sin(*beta) * (o1_m[1] - geo->d2_m);
    *alpha = atan2(o1_m[0], e_r);
}

/* Signed room to the nearest limit of a position in front of the base; negative: outside. */
static inline double plate_room(const exk_geometry *geo, const double o1_m[3])
{
    double alpha, beta, legs_m[3];
    plate_angles(geo, o1_m, &alpha, &beta);
    plate_legs(geo, o1_m, alpha, beta, legs_m);
    double room = fmin(o1_m[2], geo->angle_max_rad - fmax(fabs(alpha), fabs(beta)));
    for (int i = 0; i < 3; i++) {
        room = fmin(room, fmin(legs_m[i] - geo->l_min_m, geo->l_min_m + geo->d5_m - legs_m[i]));
    }
    return room;
}

#endif
