#include "exk/wrist.h"

#include <math.h>
#include <stddef.h>

#include "exk/vec3.h"

static exk_err inverse_ab(const double tau[3], double wrist_rad[EXK_N_WRIST])
{
    const double cos_t5 = sqrt(tau[1] * tau[1] + tau[2] * tau[2]);
    if (!(cos_t5 >= EXK_WRIST_SINGULAR)) {
        return EXK_ERR_SINGULAR;
    }
    wrist_rad[0] = atan2(-tau[1], tau[2]);
    wrist_rad[1] = atan2(tau[0], cos_t5);
    return EXK_OK;
}

static exk_err inverse_ca(const double tau[3], double wrist_rad[EXK_N_WRIST])
{
    const double sin_t5 = sqrt(tau[0] * tau[0] + tau[1] * tau[1]);
    if (!(sin_t5 >= EXK_WRIST_SINGULAR)) {
        return EXK_ERR_SINGULAR;
    }
    wrist_rad[0] = atan2(tau[0], -tau[1]);
    wrist_rad[1] = atan2(sin_t5, tau[2]);
    return EXK_OK;
}

exk_err exk_wrist_inverse(exk_wrist_kind wrist, const double tau_plate[3],
                          double wrist_rad[EXK_N_WRIST])
{
    if (!exk_finite3(tau_plate) || (unsigned)wrist >= EXK_WRIST_COUNT) {
        return EXK_ERR_ARG;
    }
    double found[EXK_N_WRIST];
    exk_err err =
        wrist == EXK_WRIST_AB ? inverse_ab(tau_plate, found) : inverse_ca(tau_plate, found);
    if (err == EXK_OK && !(tau_plate[2] > 0.0)) {
        err = EXK_ERR_LIMIT;
    }
    if (err == EXK_OK) {
        wrist_rad[0] = found[0];
        wrist_rad[1] = found[1];
    }
    return err;
}

exk_err exk_wrist_forward(exk_wrist_kind wrist, const double wrist_rad[EXK_N_WRIST],
                          double tau_plate[3])
{
    if (!(isfinite(wrist_rad[0]) && isfinite(wrist_rad[1])) ||
        (unsigned)wrist >= EXK_WRIST_COUNT) {
        return EXK_ERR_ARG;
    }
    const double s4 = sin(wrist_rad[0]), c4 = cos(wrist_rad[0]);
    const double s5 = sin(wrist_rad[1]), c5 = cos(wrist_rad[1]);
    if (wrist == EXK_WRIST_AB) {
        tau_plate[0] = s5;
        tau_plate[1] = -s4 * c5;
        tau_plate[2] = c4 * c5;
    } else {
        tau_plate[0] = s4 * s5;
        tau_plate[1] = -c4 * s5;
        tau_plate[2] = c5;
    }
    return EXK_OK;
}

const char *exk_wrist_name(exk_wrist_kind wrist)
{
    static const char *const names[EXK_WRIST_COUNT] = {
        [EXK_WRIST_AB] = "AB",
        [EXK_WRIST_CA] = "CA",
    };
    return (unsigned)wrist < EXK_WRIST_COUNT ? names[wrist] : "unknown";
}
