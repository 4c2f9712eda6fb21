#include "exk/kinematics.h"

#include <stddef.h>

#include "exk/machine.h"
#include "exk/pendulum.h"
#include "exk/universal.h"

static const exk_kin_ops *const models[EXK_KIN_COUNT] = {
    [EXK_KIN_PENDULUM] = &exk_pendulum_ops,
    [EXK_KIN_UNIVERSAL] = &exk_universal_ops,
    [EXK_KIN_MACHINE] = &exk_machine_ops,
};

exk_err exk_kin_init(exk_kin *kin, exk_kin_model model, exk_wrist_kind wrist,
                     const exk_geometry *geo)
{
    exk_tripod tripod;
    if ((unsigned)model >= EXK_KIN_COUNT || (unsigned)wrist >= EXK_WRIST_COUNT ||
        exk_tripod_init(&tripod, geo) != EXK_OK) {
        return EXK_ERR_ARG;
    }
    *kin = (exk_kin){
        .ops = models[model],
        .model = model,
        .wrist = wrist,
        .geo = *geo,
        .tripod = tripod,
    };
    return EXK_OK;
}

const char *exk_kin_name(exk_kin_model model)
{
    return (unsigned)model < EXK_KIN_COUNT ? models[model]->name : "unknown";
}

exk_err exk_kin_inverse(const exk_kin *kin, const exk_tool *tool, exk_joints *out)
{
    return kin->ops->inverse(kin, tool, out);
}

exk_err exk_kin_forward(const exk_kin *kin, const exk_joints *joints, exk_tool *out)
{
    return kin->ops->forward(kin, joints, out);
}

exk_err exk_kin_legs(const exk_kin *kin, const exk_joints *joints, double legs_m[EXK_N_LEGS])
{
    return kin->ops->legs(kin, joints, legs_m);
}
