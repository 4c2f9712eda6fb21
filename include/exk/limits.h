/** Limits on what is commanded, asked at every step before the command leaves the loop.
 *
 *  Asked   every number finite; |q| <= angle_max; |q - r| <= correction_max (c + u);
 *          |q[k] - q[k-1]| <= rate_max dt; leg_min <= leg <= leg_max; |leg[k] - leg[k-1]| <=
 *          leg_speed_max dt; the reference tip inside the box. After the answer:
 *          |q - m| <= following + following_time |q[k] - q[k-1]|/dt  (speed-scaled).
 *          dt is that of the ticks that went by, so that missed ticks do not count as speed.
 *  NaN     fails every comparison, so it breaks the first limit that meets it.
 *  First   after init or reset nothing is known of speed: rates are asked from the second step on.
 *          A command that is refused is not remembered.
 *  Shapes  both angles, three legs, tip.  Units  rad, m, s.
 *  Errors  init: EXK_ERR_ARG (dt not > 0 and finite, a limit negative or NaN, leg_min or box_min
 *          above its max). Asking: false, and what, which, value and limit.
 *  Memory  the caller owns the struct; no pointer kept.
 */
#ifndef EXK_LIMITS_H
#define EXK_LIMITS_H

#include <stdbool.h>
#include <stdint.h>

#include "exk/axes.h"
#include "exk/err.h"

/** What can be beyond its limit; on the wire, so new ones go to the end. */
typedef enum {
    EXK_QUANTITY_NONE,
    EXK_QUANTITY_ANGLE,      /* commanded angle, index: alpha, beta */
    EXK_QUANTITY_CORRECTION, /* c + u, index: alpha, beta */
    EXK_QUANTITY_RATE,       /* commanded angle rate, index: alpha, beta */
    EXK_QUANTITY_LEG,        /* commanded leg length, index: leg 0 to 2 */
    EXK_QUANTITY_LEG_SPEED,  /* index: leg 0 to 2 */
    EXK_QUANTITY_WORKSPACE,  /* reference tip, index: x, y, z */
    EXK_QUANTITY_FOLLOWING,  /* commanded less measured angle, index: alpha, beta */
    EXK_QUANTITY_POSE,       /* no pose of the mechanism meets the command */
    EXK_QUANTITY_SAMPLES,    /* rejected sensor samples in a row */
    EXK_QUANTITY_DEADLINES,  /* missed deadlines in a row */
    EXK_QUANTITY_CLOCK,      /* waits in a row that did not meet their tick */
    EXK_QUANTITY_COUNT
} exk_quantity;

typedef struct {
    double dt_s;
    double angle_max_rad;
    double correction_max_rad;
    double rate_max_radps;
    double leg_min_m;
    double leg_max_m;
    double leg_speed_max_mps;
    double box_min_m[3];
    double box_max_m[3];
    double following_rad;
    double following_time_s;
} exk_limits_config;

typedef struct {
    exk_limits_config cfg; /* fixed by init */
    double q_rad[EXK_N_AXES];
    double legs_m[EXK_N_LEGS];
    double rate_radps[EXK_N_AXES]; /* of the last command that passed */
    int64_t k;                     /* its tick */
    bool has_last;
} exk_limits;

typedef struct {
    exk_quantity quantity;
    int index;
    double value;
    double limit;
} exk_violation;

/** What is asked of one step. */
typedef struct {
    const double *tip_m; /* reference */
    const double *r_rad;
    const double *q_rad;
    const double *legs_m;
} exk_limits_step;

/** Unlimited: finite numbers are asked for only. */
exk_limits_config exk_limits_default(void);
exk_err exk_limits_init(exk_limits *limits, const exk_limits_config *cfg);
void exk_limits_reset(exk_limits *limits);

/** True when a leg could break a limit: else their lengths need not be known. */
bool exk_limits_ask_legs(const exk_limits *limits);

/** True and remembered when the command of tick k may leave. */
bool exk_limits_command(exk_limits *limits, int64_t k, const exk_limits_step *step,
                        exk_violation *out);

/** Nothing is sent at tick k, the last command stands: no time passes for the rates. */
void exk_limits_stand(exk_limits *limits, int64_t k);

/** The last command against the angles measured. */
bool exk_limits_following(const exk_limits *limits, const double m_rad[EXK_N_AXES],
                          exk_violation *out);

const char *exk_quantity_name(exk_quantity quantity); /* "leg speed"; never NULL */
const char *exk_quantity_unit(exk_quantity quantity); /* "m/s", "" without; never NULL */
const char *exk_quantity_part(exk_quantity quantity, int index); /* "alpha", "leg 2", "" */
const char *exk_quantity_advice(exk_quantity quantity);          /* what to do; never NULL */

#endif
