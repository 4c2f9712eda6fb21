/** One disturbance of the joint angles: waveform x order x channel (docs/step.md).
 *
 *  order 0  n[k] = w(t)                           gaussian: n[k] = s z,           s [rad]
 *  order 1  n[k] = integral of w, n[0] = 0        gaussian: n[k+1] = n[k] + s sqrt(dt) z,
 *                                                 s [rad/s^0.5]
 *  order 2  n[k] = double integral, n[0] = 0      gaussian: (n, rate) with the exact joint
 *           and rate[0] = 0                       covariance s^2 [dt^3/3, dt^2/2; dt^2/2, dt],
 *                                                 s [rad/s^1.5]
 *  constant w(t) = A; sine w(t) = A sin(2 pi f t + phase); t = k dt. Exact integrals;
 *           A [rad, rad/s, rad/s^2] for order 0, 1, 2. Both channels get the same w.
 *  gaussian both channels draw on their own. Order 0 is one draw a sample, so its spectrum depends
 *           on dt; orders 1 and 2 have the same statistics in time for every dt.
 *  Repeat   frozen: the draws of run 0, whatever the run; fresh: those of the run.
 *  State    a function of k: ticks that were skipped are integrated too (gaussian orders 1 and 2
 *           cost one draw a skipped tick, all others nothing).
 *  Shapes   one value an angle, EXK_N_AXES.  Units  radians, seconds, hertz.
 *  Errors   init: EXK_ERR_ARG (enum or order out of range, number not finite, sigma or frequency
 *           negative, dt not > 0), and then d is not written. step: cannot fail.
 *  Memory   the caller owns the struct; no pointer kept.
 */
#ifndef EXK_DISTURBANCE_H
#define EXK_DISTURBANCE_H

#include <stdbool.h>
#include <stdint.h>

#include "exk/axes.h"
#include "exk/err.h"
#include "exk/random.h"

typedef enum {
    EXK_WAVE_NONE,
    EXK_WAVE_CONSTANT,
    EXK_WAVE_SINE,
    EXK_WAVE_GAUSSIAN,
    EXK_WAVE_COUNT
} exk_wave;

typedef struct {
    exk_wave wave;
    int order;                /* 0, 1 or 2 */
    bool channel[EXK_N_AXES]; /* which of alpha, beta it acts on */
    double amplitude;         /* constant, sine: [rad, rad/s, rad/s^2]; gaussian: sigma */
    double freq_Hz;           /* sine */
    double phase_rad;         /* sine */
    bool frozen;              /* the same realisation in every run of a series */
} exk_disturbance_config;

/** Which realisation: seed of the study, series (trial) and run p = 1, 2, ... */
typedef struct {
    uint64_t seed;
    uint32_t series;
    uint32_t run;
} exk_realisation;

typedef struct {
    exk_disturbance_config cfg; /* fixed by init */
    double dt_s;
    double root_dt; /* sqrt(dt) [s^0.5] */
    exk_stream stream[EXK_N_AXES];
    double n_rad[EXK_N_AXES];      /* state at tick k; 0 on a channel it does not act on */
    double rate_radps[EXK_N_AXES]; /* gaussian of order 2 */
    int64_t k;                     /* tick of the state */
} exk_disturbance;

/** None: order 0, both channels, zero amplitude, frozen. */
exk_disturbance_config exk_disturbance_default(void);

/** source: index of the disturbance, so that two in one list draw on their own. */
exk_err exk_disturbance_init(exk_disturbance *d, const exk_disturbance_config *cfg, double dt_s,
                             exk_realisation which, uint8_t source);

/** Back to tick 0 of the same realisation. */
void exk_disturbance_reset(exk_disturbance *d);

/** Adds the value at tick k to out_rad. k must not fall between calls; an earlier k gives the
 *  state as it is. */
void exk_disturbance_add(exk_disturbance *d, int64_t k, double out_rad[EXK_N_AXES]);

const char *exk_wave_name(exk_wave wave); /* never NULL */

#endif
