/* Inverse and forward of every kinematics on any numbers: a status, and never a NaN under EXK_OK. Forward
 * of inverse is where it began; with the level plate of models P and U in x and y, h being its height. */
#include <math.h>

#include "exk/kinematics.h"
#include "exk/machine.h"
#include "exk/pendulum.h"
#include "exk/universal.h"
#include "exk/vec3.h"
#include "exk/wrist.h"
#include "fuzz.h"
#include "numbers.h"

static const double round_trip_m = 1e-9; /* on a machine of a metre */

static bool all_finite(const double *x, int n)
{
    bool good = true;
    for (int i = 0; i < n; i++) {
        good = good && isfinite(x[i]);
    }
    return good;
}

static bool joints_finite(const exk_joints *j)
{
    return all_finite(j->angle_rad, EXK_N_AXES) && isfinite(j->h_m) &&
           all_finite(j->wrist_rad, EXK_N_WRIST);
}

static double number(numbers *in, bool raw, double center, double span)
{
    return raw ? next_bits(in) : next_near(in, center, span);
}

static void comes_back(const exk_kin *kin, const exk_tool *tool, const exk_joints *joints)
{
    exk_tool again;
    double legs_m[EXK_N_LEGS], off_m[3];
    PROMISE(joints_finite(joints));
    PROMISE(exk_kin_forward(kin, joints, &again) == EXK_OK);
    exk_add_scaled3(again.tip_m, -1.0, tool->tip_m, off_m);
    off_m[2] = kin->model == EXK_KIN_MACHINE ? off_m[2] : 0.0;
    PROMISE(exk_norm3(off_m) <= round_trip_m * (1.0 + exk_norm3(tool->tip_m)));
    PROMISE(exk_kin_legs(kin, joints, legs_m) == EXK_OK ? all_finite(legs_m, EXK_N_LEGS)
                                                        : true);
}

static void inverse(const exk_kin *kin, numbers *in, bool raw, bool upright)
{
    exk_tool tool = {.axis = {0.0, 0.0, 1.0}};
    exk_joints joints;
    double J[3][3];
    for (int i = 0; i < 3; i++) {
        tool.tip_m[i] = number(in, raw, i == 2 ? 1.2 : 0.0, 0.7);
    }
    for (int i = 0; i < 3 && !upright; i++) {
        tool.axis[i] = number(in, raw, i == 2 ? 1.0 : 0.0, 0.5);
    }
    const double length = exk_norm3(tool.axis);
    for (int i = 0; i < 3 && !raw && length > 0.1; i++) {
        tool.axis[i] /= length;
    }
    if (exk_kin_inverse(kin, &tool, &joints) == EXK_OK) {
        comes_back(kin, &tool, &joints);
    }
    if (exk_machine_jacobian(kin, &tool, J) == EXK_OK) {
        PROMISE(all_finite(&J[0][0], 9));
    }
}

static void forward(const exk_kin *kin, numbers *in, bool raw)
{
    exk_joints joints;
    exk_tool tool;
    double legs_m[EXK_N_LEGS], J[2][2];
    for (int i = 0; i < EXK_N_AXES; i++) {
        joints.angle_rad[i] = number(in, raw, 0.0, 1.7);
        joints.wrist_rad[i] = number(in, raw, 0.0, 3.2);
    }
    joints.h_m = number(in, raw, 1.0, 0.8);
    if (exk_kin_forward(kin, &joints, &tool) == EXK_OK) {
        PROMISE(exk_finite3(tool.tip_m) && exk_finite3(tool.axis));
    }
    if (exk_kin_legs(kin, &joints, legs_m) == EXK_OK) {
        PROMISE(all_finite(legs_m, EXK_N_LEGS));
    }
    if (exk_pendulum_jacobian(kin, &joints, J) == EXK_OK) {
        PROMISE(all_finite(&J[0][0], 4));
    }
    if (exk_universal_jacobian(kin, &joints, J) == EXK_OK) {
        PROMISE(all_finite(&J[0][0], 4));
    }
}

/* Newton, from any start: what it calls a pose has these lengths. */
static void forward_of_legs(const exk_tripod *tri, numbers *in, bool raw, bool cold)
{
    double legs_m[EXK_N_LEGS], again_m[EXK_N_LEGS];
    exk_tripod_pose pose;
    exk_tripod_report report;
    for (int i = 0; i < EXK_N_LEGS; i++) {
        legs_m[i] = number(in, raw, 1.0, 0.5);
    }
    const exk_tripod_pose start = {number(in, raw, 0.0, 1.7), number(in, raw, 0.0, 1.7),
                                   number(in, raw, 1.0, 1.2)};
    if (exk_tripod_forward(tri, legs_m, cold ? NULL : &start, &pose, &report) != EXK_OK) {
        return;
    }
    PROMISE(isfinite(pose.alpha_rad) && isfinite(pose.beta_rad) && isfinite(pose.h_m));
    PROMISE(report.residual_m <= round_trip_m);
    if (exk_tripod_legs(tri, &pose, again_m) == EXK_OK) {
        for (int i = 0; i < EXK_N_LEGS; i++) {
            PROMISE(fabs(again_m[i] - legs_m[i]) <= 2.0 * round_trip_m);
        }
    }
}

static void positions(const exk_tripod *tri, numbers *in, bool raw)
{
    double o_m[3], again_m[3], legs_m[EXK_N_LEGS], J[3][3];
    exk_tripod_pose pose;
    exk_tripod_passive passive;
    for (int i = 0; i < 3; i++) {
        o_m[i] = number(in, raw, i == 2 ? 1.0 : 0.0, 0.7);
    }
    if (exk_tripod_inverse(tri, o_m, &pose, legs_m) == EXK_OK) {
        PROMISE(all_finite(legs_m, EXK_N_LEGS));
        PROMISE(exk_tripod_position(tri, &pose, again_m) == EXK_OK);
        exk_add_scaled3(again_m, -1.0, o_m, again_m);
        PROMISE(exk_norm3(again_m) <= round_trip_m);
        PROMISE(exk_tripod_passive_joints(tri, &pose, &passive) == EXK_OK);
        PROMISE(isfinite(passive.u_first_rad) && isfinite(passive.leg2_x_rad));
    }
    if (exk_tripod_jacobian(tri, o_m, J) == EXK_OK) {
        PROMISE(all_finite(&J[0][0], 9));
    }
}

static exk_geometry geometry(numbers *in, bool raw)
{
    exk_geometry geo = exk_geometry_default();
    geo.d1_m = number(in, raw, 0.9, 0.2);
    geo.d2_m = number(in, raw, 0.72, 0.2);
    geo.d5_m = number(in, raw, 0.7, 0.2);
    geo.e_m = number(in, raw, 0.2, 0.4);
    geo.f_m = number(in, raw, 0.0, 0.4);
    geo.t_m = number(in, raw, 0.3, 0.4);
    return geo;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    numbers in = {data, size};
    exk_kin kin;
    const uint8_t how = next_byte(&in);
    const bool raw = (how & 1) != 0;
    const exk_geometry geo =
        (how & 2) != 0 ? geometry(&in, (how & 4) != 0) : exk_geometry_default();
    const exk_kin_model model = (exk_kin_model)(next_byte(&in) % EXK_KIN_COUNT);
    const exk_wrist_kind wrist = (exk_wrist_kind)(next_byte(&in) % EXK_WRIST_COUNT);
    if (exk_kin_init(&kin, model, wrist, &geo) != EXK_OK) {
        return 0;
    }
    for (int i = 0; i < 4 && in.left > 0; i++) {
        const uint8_t which = next_byte(&in);
        switch (which % 4) {
        case 0:
            inverse(&kin, &in, raw, (which & 4) != 0);
            break;
        case 1:
            forward(&kin, &in, raw);
            break;
        case 2:
            forward_of_legs(&kin.tripod, &in, raw, (which & 4) != 0);
            break;
        default:
            positions(&kin.tripod, &in, raw);
            break;
        }
    }
    return 0;
}
