#include "exk/tripod.h"

#include "attitude.h"

exk_err exk_tripod_lengths(const exk_tripod *tri, const double o1_m[3],
                           double legs_m[EXK_N_LEGS])
{
    exk_attitude att;
    exk_err err = exk_attitude_of_point(tri, o1_m, 0.0, 0.0, &att);
    return err == EXK_OK ? exk_attitude_legs(tri, &att, legs_m) : err;
}

exk_err exk_tripod_inverse(const exk_tripod *tri, const double o1_m[3], exk_tripod_pose *pose,
                           double legs_m[EXK_N_LEGS])
{
    exk_attitude att;
    exk_err err = exk_attitude_of_point(tri, o1_m, 0.0, 0.0, &att);
    if (err == EXK_OK) {
        err = exk_attitude_legs(tri, &att, legs_m);
    }
    if (err == EXK_OK) {
        pose->alpha_rad = atan2(att.x, att.s);
        pose->beta_rad = atan2(att.y, att.z);
        pose->h_m = att.h;
    }
    return err;
}

exk_err exk_tripod_legs(const exk_tripod *tri, const exk_tripod_pose *pose,
                        double legs_m[EXK_N_LEGS])
{
    exk_attitude att;
    exk_err err = exk_attitude_of_pose(tri, pose, &att);
    return err == EXK_OK ? exk_attitude_legs(tri, &att, legs_m) : err;
}
