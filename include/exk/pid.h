/** PID controller of one angle: angle error in, angle correction out.
 *
 *  c[k+1] = sat( kp e[k] + I[k+1] + D[k+1], c_max )
 *  I[k+1] = I[k] + ki dt e[k]           held while e pushes further into saturation
 *  D[k+1] = b D[k] + (1 - b) kd (e[k] - e[k-1])/dt,  b = exp(-dt/d_filter), first D = 0
 *  Stability on the unit-gain axis with one step of delay, e = d - c (docs/step.md).
 *          With g = ki dt and h = (1 - b) kd/dt the closed loop has the roots of
 *              z (z-1)(z-b) + kp (z-1)(z-b) + g z (z-b) + h (z-1)^2
 *          less z = b when kd = 0 and z = 1 when ki = 0, which cancel. Accepted: 0 <= kp < 1,
 *          0 <= g < 2 (1 - kp), kd >= 0, and every root inside the unit circle (Schur-Cohn).
 *          For kd = 0 the first two conditions are the whole of it.
 *  Shapes  scalar in, scalar out; one exk_pid an angle.
 *  Units   kp [1], ki [1/s], kd [s], e and c [rad].
 *  Errors  init: EXK_ERR_ARG (a number not finite; dt or c_max not > 0; d_filter or a gain
 *          negative; an unstable loop), and then pid is not written. step: cannot fail; an error
 *          that is not finite, or so large that the sum overflows, leaves the state and returns
 *          the last output.
 *  Memory  the caller owns the struct; no pointer kept.
 */
#ifndef EXK_PID_H
#define EXK_PID_H

#include <stdbool.h>

#include "exk/err.h"

typedef struct {
    double kp;         /* [1] */
    double ki;         /* [1/s] */
    double kd;         /* [s] */
    double d_filter_s; /* time constant of the derivative filter, 0: none */
    double c_max_rad;  /* symmetric limit of the output, > 0 */
    double dt_s;
} exk_pid_config;

typedef struct {
    exk_pid_config cfg; /* fixed by init */
    double i_gain;      /* g = ki dt */
    double d_gain;      /* h = (1 - b) kd/dt */
    double d_pole;      /* b */
    double integral_rad;
    double derivative_rad;
    double last_error_rad;
    double output_rad;
    bool has_last;
} exk_pid;

/** Integral only, 2 /s at 1 kHz, limit 0.1 rad. */
exk_pid_config exk_pid_default(void);
exk_err exk_pid_init(exk_pid *pid, const exk_pid_config *cfg);

/** Clears the state, keeps the configuration. */
void exk_pid_reset(exk_pid *pid);

/** Bumpless start: the output becomes output_rad (clipped to the limit), and the next step with the
 *  same error_rad moves it by the integral's own ki dt error_rad only. Numbers that are not finite
 *  change nothing. */
void exk_pid_preset(exk_pid *pid, double output_rad, double error_rad);

/** After a gap: the next step takes error_rad for the error before it, so that the derivative sees no
 *  jump; integral and output stay. Numbers that are not finite change nothing. */
void exk_pid_rejoin(exk_pid *pid, double error_rad);

/** c[k+1] from e[k]. */
double exk_pid_step(exk_pid *pid, double error_rad);

#endif
