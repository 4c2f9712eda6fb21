#include <exk/kinematics.h>
#include <exk/version.h>
#include <math.h>
#include <stdio.h>

int main(void)
{
    const exk_geometry geo = exk_geometry_default();
    const exk_tool want = {.tip_m = {0.1, 0.05, geo.z0_m}, .axis = {0.0, 0.0, 1.0}};
    exk_tool got = {0};
    exk_joints joints;
    exk_kin kin;
    exk_err err = exk_kin_init(&kin, EXK_KIN_PENDULUM, EXK_WRIST_AB, &geo);
    err = err ? err : exk_kin_inverse(&kin, &want, &joints);
    err = err ? err : exk_kin_forward(&kin, &joints, &got);
    printf("exk %s: %s, x = %.6f m\n", EXK_VERSION, exk_err_name(err), got.tip_m[0]);
    return fabs(got.tip_m[0] - want.tip_m[0]) <= 1e-12 ? 0 : 1;
}
