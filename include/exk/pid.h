/** PID controller of one angle: angle error in, angle correction out.
 *
 *  c[k+1] = sat( kp e[k] + I[k+1] + D[k+1], c_max )
 *  I[k+1] = I[k] + ki dt e[k]           held while e pushes further into saturation
 *  D[k+1] = b D[k] + (1 - b) kd (e[k] - e[k-1])/dt,  b = exp(-dt/d_filter), first D = 0
 *  Stability on the unit-gain axis with one step of delay (architecture.md section 2):
 *          refused unless 0 <= kp < 1, 0 <= ki dt < 2 (1 - kp), and with kd the whole
 *          characteristic polynomial has its roots inside the unit circle (Jury test).
 *  Units   kp [1], ki [1/s], kd [s], e and c [rad].
 *  Errors  init: EXK_ERR_ARG. step: cannot fail; an error that is not finite leaves the state
 *          and returns the last output.
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
    double d_pole;      /* b */
    double integral_rad;
    double derivative_rad;
    double last_error_rad;
    double output_rad;
    bool has_last;
} exk_pid;

exk_pid_config exk_pid_default(void);
exk_err exk_pid_init(exk_pid *pid, const exk_pid_config *cfg);
void exk_pid_reset(exk_pid *pid);

/** Bumpless start: the next step continues from output_rad (clipped to the limit). */
void exk_pid_preset(exk_pid *pid, double output_rad, double error_rad);
double exk_pid_step(exk_pid *pid, double error_rad);

#endif
