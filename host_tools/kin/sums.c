#include "sums.h"

#include <string.h>

#include "exk/machine.h"
#include "exk/pendulum.h"
#include "exk/tripod.h"
#include "exk/universal.h"

static void put(double *out, const double *values, size_t n)
{
    memcpy(out, values, n * sizeof *out);
}

/* P and U: the plate at the working height of the geometry. */
static exk_err plane_joints(const exk_kin *kin, const double *in, exk_joints *joints)
{
    const exk_tool tool = {{in[0], in[1], kin->geo.z0_m}, {0.0, 0.0, 1.0}};
    return exk_kin_inverse(kin, &tool, joints);
}

static exk_err plane_inverse(const exk_kin *kin, const double *in, double *out)
{
    exk_joints joints;
    exk_err err = plane_joints(kin, in, &joints);
    if (err == EXK_OK) {
        put(out, joints.angle_rad, EXK_N_AXES);
    }
    return err;
}

static exk_err plane_forward(const exk_kin *kin, const double *in, double *out)
{
    const exk_joints joints = {.angle_rad = {in[0], in[1]}, .h_m = kin->geo.z0_m};
    exk_tool tool;
    exk_err err = exk_kin_forward(kin, &joints, &tool);
    if (err == EXK_OK) {
        put(out, tool.tip_m, 3);
    }
    return err;
}

static exk_err plane_jacobian(const exk_kin *kin, const double *in, double *out)
{
    exk_joints joints;
    double J[2][2];
    exk_err err = plane_joints(kin, in, &joints);
    if (err == EXK_OK) {
        err = kin->model == EXK_KIN_PENDULUM ? exk_pendulum_jacobian(kin, &joints, J)
                                             : exk_universal_jacobian(kin, &joints, J);
    }
    if (err == EXK_OK) {
        put(out, J[0], 2);
        put(out + 2, J[1], 2);
    }
    return err;
}

static void put_matrix(double *out, double J[3][3])
{
    for (size_t i = 0; i < 3; i++) {
        put(out + 3 * i, J[i], 3);
    }
}

static exk_err tripod_inverse(const exk_kin *kin, const double *in, double *out)
{
    exk_tripod_pose pose;
    double legs_m[EXK_N_LEGS];
    exk_err err = exk_tripod_inverse(&kin->tripod, in, &pose, legs_m);
    if (err == EXK_OK) {
        out[0] = pose.alpha_rad;
        out[1] = pose.beta_rad;
        put(out + 2, legs_m, EXK_N_LEGS);
    }
    return err;
}

/* Each row from a cold start: its answer does not depend on the rows before it. */
static exk_err tripod_forward(const exk_kin *kin, const double *in, double *out)
{
    exk_tripod_pose pose;
    double o1_m[3];
    exk_err err = exk_tripod_forward(&kin->tripod, in, NULL, &pose, NULL);
    if (err == EXK_OK) {
        err = exk_tripod_position(&kin->tripod, &pose, o1_m);
    }
    if (err == EXK_OK) {
        put(out, o1_m, 3);
        out[3] = pose.alpha_rad;
        out[4] = pose.beta_rad;
    }
    return err;
}

static exk_err tripod_jacobian(const exk_kin *kin, const double *in, double *out)
{
    double J[3][3];
    exk_err err = exk_tripod_jacobian(&kin->tripod, in, J);
    if (err == EXK_OK) {
        put_matrix(out, J);
    }
    return err;
}

static exk_tool tool_of(const double *in)
{
    return (exk_tool){{in[0], in[1], in[2]}, {in[3], in[4], in[5]}};
}

static exk_err machine_inverse(const exk_kin *kin, const double *in, double *out)
{
    const exk_tool tool = tool_of(in);
    exk_joints joints;
    double legs_m[EXK_N_LEGS];
    exk_err err = exk_kin_inverse(kin, &tool, &joints);
    if (err == EXK_OK) {
        err = exk_kin_legs(kin, &joints, legs_m);
    }
    if (err == EXK_OK) {
        put(out, joints.angle_rad, EXK_N_AXES);
        put(out + 2, legs_m, EXK_N_LEGS);
        put(out + 5, joints.wrist_rad, EXK_N_WRIST);
    }
    return err;
}

static exk_err machine_forward(const exk_kin *kin, const double *in, double *out)
{
    exk_tripod_pose pose;
    exk_tool tool;
    exk_err err = exk_tripod_forward(&kin->tripod, in, NULL, &pose, NULL);
    if (err == EXK_OK) {
        const exk_joints joints = {{pose.alpha_rad, pose.beta_rad}, pose.h_m, {in[3], in[4]}};
        err = exk_kin_forward(kin, &joints, &tool);
    }
    if (err == EXK_OK) {
        put(out, tool.tip_m, 3);
        put(out + 3, tool.axis, 3);
        out[6] = pose.alpha_rad;
        out[7] = pose.beta_rad;
    }
    return err;
}

static exk_err machine_jacobian(const exk_kin *kin, const double *in, double *out)
{
    const exk_tool tool = tool_of(in);
    double J[3][3];
    exk_err err = exk_machine_jacobian(kin, &tool, J);
    if (err == EXK_OK) {
        put_matrix(out, J);
    }
    return err;
}

#define PLANE {"x_m", "y_m"}
#define ANGLES {"alpha_rad", "beta_rad"}
#define POINT {"x_m", "y_m", "z_m"}
#define TOOL {"x_m", "y_m", "z_m", "nx", "ny", "nz"}
#define J2X2 {"j11", "j12", "j21", "j22"}
#define J3X3 {"j11", "j12", "j13", "j21", "j22", "j23", "j31", "j32", "j33"}

static const kin_sum sums[KIN_MODELS][KIN_DIRECTIONS] = {
    [KIN_PENDULUM] = {{PLANE, ANGLES, plane_inverse},
                      {ANGLES, POINT, plane_forward},
                      {PLANE, J2X2, plane_jacobian}},
    [KIN_UNIVERSAL] = {{PLANE, ANGLES, plane_inverse},
                       {ANGLES, POINT, plane_forward},
                       {PLANE, J2X2, plane_jacobian}},
    [KIN_TRIPOD] = {{POINT, {"alpha_rad", "beta_rad", "l1_m", "l2_m", "l3_m"}, tripod_inverse},
                    {{"l1_m", "l2_m", "l3_m"},
                     {"x_m", "y_m", "z_m", "alpha_rad", "beta_rad"},
                     tripod_forward},
                    {POINT, J3X3, tripod_jacobian}},
    [KIN_MACHINE] = {{TOOL,
                      {"alpha_rad", "beta_rad", "l1_m", "l2_m", "l3_m", "t4_rad", "t5_rad"},
                      machine_inverse},
                     {{"l1_m", "l2_m", "l3_m", "t4_rad", "t5_rad"},
                      {"x_m", "y_m", "z_m", "nx", "ny", "nz", "alpha_rad", "beta_rad"},
                      machine_forward},
                     {TOOL, J3X3, machine_jacobian}},
};

const kin_sum *kin_sum_of(kin_model model, kin_direction direction)
{
    return &sums[model][direction];
}

exk_kin_model kin_interface_of(kin_model model)
{
    switch (model) {
    case KIN_PENDULUM:
        return EXK_KIN_PENDULUM;
    case KIN_UNIVERSAL:
        return EXK_KIN_UNIVERSAL;
    case KIN_TRIPOD:
    case KIN_MACHINE:
    case KIN_MODELS:
    default:
        return EXK_KIN_MACHINE;
    }
}

const char *kin_model_name(kin_model model)
{
    static const char *const names[KIN_MODELS] = {"pendulum", "universal", "tripod", "machine"};
    return names[model];
}

const char *kin_direction_name(kin_direction direction)
{
    static const char *const names[KIN_DIRECTIONS] = {"inverse", "forward", "jacobian"};
    return names[direction];
}
