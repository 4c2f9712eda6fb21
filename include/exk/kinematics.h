/** One small interface over the kinematic models a loop can run.
 *
 *  Models  pendulum  paper model P, constant bars, level plate      (docs/kinematics.md section 10)
 *          universal alternative U, universal-joint pendulum        (section 10)
 *          machine   exact tripod and two-axis wrist, AB or CA      (sections 2 to 8)
 *  Shapes  exk_tool (tip and axis) <-> exk_joints (alpha, beta, h, wrist).
 *  h       machine: (O1 - A2) . w; P and U: the working height of the plate.
 *  Units   metres, radians, base frame.
 *  Errors  EXK_ERR_ARG for input that is not finite, EXK_ERR_UNREACHABLE where no pose exists,
 *          EXK_ERR_LIMIT when a leg or an angle leaves its limit, EXK_ERR_SINGULAR near a
 *          singular pose. Outputs are written only on EXK_OK.
 *  Memory  the caller owns exk_kin; it holds a copy of the geometry and no pointer but its
 *          constant table of operations. A call changes nothing in it: one may serve many threads.
 */
#ifndef EXK_KINEMATICS_H
#define EXK_KINEMATICS_H

#include "exk/axes.h"
#include "exk/err.h"
#include "exk/geometry.h"
#include "exk/tripod.h"

typedef enum {
    EXK_KIN_PENDULUM,
    EXK_KIN_UNIVERSAL,
    EXK_KIN_MACHINE,
    EXK_KIN_COUNT
} exk_kin_model;

typedef enum { EXK_WRIST_AB, EXK_WRIST_CA, EXK_WRIST_COUNT } exk_wrist_kind;

typedef struct {
    double angle_rad[EXK_N_AXES];
    double h_m;
    double wrist_rad[EXK_N_WRIST]; /* t4, t5; zero where the model has no wrist */
} exk_joints;

typedef struct exk_kin exk_kin;

/** What a model provides; a new one is a file with such a table and a row in kinematics.c. */
typedef struct {
    const char *name;
    exk_err (*inverse)(const exk_kin *kin, const exk_tool *tool, exk_joints *out);
    exk_err (*forward)(const exk_kin *kin, const exk_joints *joints, exk_tool *out);
    exk_err (*legs)(const exk_kin *kin, const exk_joints *joints, double legs_m[EXK_N_LEGS]);
} exk_kin_ops;

struct exk_kin {
    const exk_kin_ops *ops;
    exk_kin_model model;
    exk_wrist_kind wrist;
    exk_geometry geo;
    exk_tripod tripod; /* constants of the geometry, made by init */
};

/** EXK_ERR_ARG when the geometry does not pass exk_geometry_check or an enum is out of range. */
exk_err exk_kin_init(exk_kin *kin, exk_kin_model model, exk_wrist_kind wrist,
                     const exk_geometry *geo);

const char *exk_kin_name(exk_kin_model model); /* "pendulum", ...; never NULL */

/** Inverse with every limit checked: pose, legs, angles. */
exk_err exk_kin_inverse(const exk_kin *kin, const exk_tool *tool, exk_joints *out);

/** Forward from angles, h and wrist in closed form; checks finiteness and domain, not limits. */
exk_err exk_kin_forward(const exk_kin *kin, const exk_joints *joints, exk_tool *out);

/** Lengths |A_i B_i| of the joints given. machine: EXK_ERR_LIMIT when a leg leaves the stroke or
 *  an angle its limit, and the other refusals of tripod.h; the wrist is not looked at.
 *  P and U, whose bars are constant: the distances |A_i B_i| of the drawn level plate, no limit. */
exk_err exk_kin_legs(const exk_kin *kin, const exk_joints *joints, double legs_m[EXK_N_LEGS]);

#endif
