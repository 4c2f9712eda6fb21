#include "exk/tripod.h"

#include <stddef.h>

#include "attitude.h"

exk_err exk_tripod_init(exk_tripod *tri, const exk_geometry *geo)
{
    if (exk_geometry_check(geo, NULL) != EXK_OK) {
        return EXK_ERR_ARG;
    }
    const double l_max = geo->l_min_m + geo->d5_m;
    *tri = (exk_tripod){
        .a_m = 0.5 * geo->d1_m,
        .b_m = 0.5 * geo->d3_m,
        .d2_m = geo->d2_m,
        .d4_m = geo->d4_m,
        .l_min_m = geo->l_min_m,
        .l_max_m = l_max,
        .reach_m = l_max + 0.5 * (geo->d1_m + geo->d3_m), /* |OA1| + |A1B1| + |B1O1| */
        .tan_max = tan(geo->angle_max_rad),
    };
    return EXK_OK;
}

exk_err exk_tripod_position(const exk_tripod *tri, const exk_tripod_pose *pose, double o1_m[3])
{
    exk_attitude att;
    exk_err err = exk_attitude_of_pose(tri, pose, &att);
    if (err == EXK_OK) {
        exk_attitude_position(tri, &att, o1_m);
    }
    return err;
}

double exk_tripod_G(const exk_tripod *tri, const exk_tripod_pose *pose)
{
    const exk_attitude att = {
        .sa = sin(pose->alpha_rad),
        .ca = cos(pose->alpha_rad),
        .sb = sin(pose->beta_rad),
        .cb = cos(pose->beta_rad),
        .h = pose->h_m,
    };
    return exk_attitude_G(tri, &att);
}

double exk_tripod_margin(const exk_tripod *tri, const exk_tripod_pose *pose)
{
    return exk_tripod_G(tri, pose) / exk_attitude_G_home(tri, pose->h_m);
}

/* Section 7, with (x, r) the place of O1 in the plane of legs 1 and 3. */
exk_err exk_tripod_passive_joints(const exk_tripod *tri, const exk_tripod_pose *pose,
                                  exk_tripod_passive *out)
{
    exk_attitude att;
    exk_err err = exk_attitude_of_pose(tri, pose, &att);
    if (err != EXK_OK) {
        return err;
    }
    const double a = tri->a_m, b = tri->b_m, x = att.h * att.sa;
    const double r = att.h * att.ca + tri->d2_m * att.sb;
    const double k = tri->d2_m * att.cb - tri->d4_m;
    const double phi1 = atan2(x + a - b * att.ca, r + b * att.sa);
    const double phi3 = atan2(x - a + b * att.ca, r - b * att.sa);
    *out = (exk_tripod_passive){
        .u_first_rad = -pose->beta_rad,
        .u1_second_rad = phi1,
        .u3_second_rad = phi3,
        .b1_rad = pose->alpha_rad - phi1,
        .b3_rad = pose->alpha_rad - phi3,
        .leg2_x_rad = atan2(x, att.h * att.ca * att.cb + k * att.sb),
    };
    return EXK_OK;
}
