/** Digital twin of the two driven angles.
 *
 *  x[k]     = a x[k-1] + (1 - a) q[k],  a = exp(-dt/tau), a = 0 for tau = 0, x[-1] = q[0]
 *  theta[k] = x[k] + sum of the disturbances n[k]
 *  m[k]     = round((theta[k] + v[k]) / quantum) * quantum;  v normal, sigma; quantum 0: no rounding
 *  Order    disturbances are summed in their listed order; disturbance i draws as source i, the
 *           sensor as EXK_SOURCE_SENSOR.
 *  Skipped  ticks are integrated with the last command held (docs/step.md). Ticks must
 *           rise: an earlier or repeated k reads the state again and moves nothing (a fresh look:
 *           the sensor noise is that of k).
 *  Shapes   both angles in, both angles out.  Units  radians, seconds.
 *  Errors   init: EXK_ERR_SIZE (more than EXK_MAX_DISTURBANCES), EXK_ERR_ARG (dt not > 0, tau,
 *           sigma or quantum negative or not finite, a disturbance refused); the twin is not usable
 *           then. step: cannot fail; a command that is not finite in both angles leaves the servo
 *           where it is (at 0 before the first good one) until the next good command.
 *  Memory   the caller owns the struct; no pointer kept.
 */
#ifndef EXK_TWIN_H
#define EXK_TWIN_H

#include <stddef.h>

#include "exk/disturbance.h"
#include "exk/source.h"

enum { EXK_MAX_DISTURBANCES = 8 };

typedef struct {
    double dt_s;
    double servo_tau_s;
    double sensor_sigma_rad;
    double sensor_quantum_rad;
    bool sensor_frozen;
    exk_disturbance_config disturbance[EXK_MAX_DISTURBANCES];
    size_t n_disturbances;
} exk_twin_config;

typedef struct {
    exk_twin_config cfg; /* fixed by init */
    exk_disturbance disturbance[EXK_MAX_DISTURBANCES];
    exk_stream sensor[EXK_N_AXES];
    double pole;                        /* a */
    double command_rad[EXK_N_AXES];     /* last one, held over skipped ticks */
    double servo_rad[EXK_N_AXES];       /* x */
    bool has_command;                   /* x[-1] is known */
    const double *lent_rad[EXK_N_AXES]; /* NULL: drawn */
    size_t n_lent;
    int64_t k; /* tick of the state, -1 before the first */
} exk_twin;

/** 1 kHz, ideal servo, ideal sensor (fresh), no disturbance. */
exk_twin_config exk_twin_default(void);
exk_err exk_twin_init(exk_twin *twin, const exk_twin_config *cfg, exk_realisation which);

/** Back to before tick 0 of the same realisation. */
void exk_twin_reset(exk_twin *twin);

/** Draws n[k] of the ticks 0 .. n - 1 into arrays, for exk_twin_lend. False, and nothing written, unless
 *  the twin has exactly one disturbance (the sum of several depends on the order of adding). */
bool exk_twin_draw(const exk_twin *twin, size_t n, double *const n_rad[EXK_N_AXES]);

/** From here on n[k] of the ticks 0 .. n - 1 is read from arrays drawn for this very realisation: the
 *  same bits, drawn once for all runs of a series. Until the next init; the caller keeps them. */
void exk_twin_lend(exk_twin *twin, size_t n, double *const n_rad[EXK_N_AXES]);

/** Applies q at tick k and reads the angles of that tick; out is always fresh and has the truth. */
void exk_twin_step(exk_twin *twin, int64_t k, const double q_rad[EXK_N_AXES], exk_reading *out);

/** The twin as a joint source; twin must outlive it. */
exk_source exk_twin_source(exk_twin *twin);

#endif
