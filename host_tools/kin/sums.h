/** What exk-kin can compute: one row for each model and direction, with its columns. */
#ifndef EXK_KIN_SUMS_H
#define EXK_KIN_SUMS_H

#include <stddef.h>

#include "exk/kinematics.h"

enum { KIN_IN_MAX = 6, KIN_OUT_MAX = 9 };

typedef enum { KIN_PENDULUM, KIN_UNIVERSAL, KIN_TRIPOD, KIN_MACHINE, KIN_MODELS } kin_model;
typedef enum { KIN_INVERSE, KIN_FORWARD, KIN_JACOBIAN, KIN_DIRECTIONS } kin_direction;

/** One row: in[n_in] to out[n_out], written on EXK_OK alone. */
typedef exk_err (*kin_fn)(const exk_kin *kin, const double *in, double *out);

typedef struct {
    const char *in[KIN_IN_MAX + 1];   /* column names, NULL after the last */
    const char *out[KIN_OUT_MAX + 1]; /* without status */
    kin_fn compute;
} kin_sum;

const kin_sum *kin_sum_of(kin_model model, kin_direction direction);

/** The model behind the small interface that a row of this kind needs. */
exk_kin_model kin_interface_of(kin_model model);

const char *kin_model_name(kin_model model);
const char *kin_direction_name(kin_direction direction);

#endif
