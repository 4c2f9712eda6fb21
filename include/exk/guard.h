/** Sensor guard: is the sample of this tick to be believed?
 *
 *  Kinds   in the order they are asked: missing, late, repeated, reordered (by the tick the source says
 *          the sample belongs to), NaN, infinite, out of range, stuck, spike. One bad angle rejects
 *          both. Every kind is counted.
 *  Expected  x[k] = a x[k-1] + (1-a) q[k], a = exp(-dt/tau): the servo as the profile describes it.
 *          d = m - x is what disturbances and sensor add. The guard follows it,
 *              d^ <- d^ + K (d - d^),   K = P/(P+R), P = (Q + sqrt(Q^2 + 4 Q R))/2, K >= 0.1,
 *          the scalar Kalman filter of a walk (variance Q a step) under white noise (variance R). A value
 *          that repeats the two before tells nothing new: d^ stays, so that a sensor that sticks and
 *          comes back is judged by what was known before.
 *  Spike   |d - d^| > n_sigmas sqrt(P+R + (n-1) Q) + n drift/K + quantum, n ticks after the last good
 *          sample that told something. sqrt(2) of the first term while d^ is young (1/K samples). So the limit grows while
 *          nothing is known, and a true change of course is accepted in the end. Accepting a sample
 *          just inside the limit moves d^ by K of it: the good samples after it stay good.
 *          One sample later its error is known better. A spike of A shows as A in d - d^ of its own tick, e1,
 *          and as -K A in that of the next, e2, and both have the variance P+R, so
 *              A^ = (e1 - K e2)/(1 + K^2),   sigma of A^ = sqrt((P+R)/(1 + K^2)):
 *          beyond n_sigmas of it, and (1+K)/(1+K^2) of what is not noise, the sample before was a spike. d^
 *          forgets it, and the pair is rejected in the tick of the second. Asked while d^ is grown up.
 *  Stuck   the same bits n times in a row, n = stuck_s/dt (3 at least), counted only
 *          - while the reference, seen through the same servo, and x have both moved since the value
 *            last changed, by more than 10 quanta (1e-6 rad without a quantum) and what may drift
 *            meanwhile: a quiet dwell is constant by right, also where corrections move the command to
 *            keep it so, and so is a turn that feedback brings before the lag would; or
 *          - where sensor noise is not below the quantum; n is then also large enough that clean
 *            samples repeat so often once in 1e9 only (a value repeats with p <= q/(2 sqrt(pi) sigma)).
 *  First   after init or reset a sample is a spike beyond start_rad + n_sigmas sqrt(2 R + (k+1) Q) +
 *          (k+1) drift + quantum from x
 *          (start_rad INFINITY: range only); after forget the first one is believed within the range.
 *  Shapes  both angles.  Units  rad, s; sigmas are per sample.
 *  Errors  init: EXK_ERR_ARG (dt, angle_max not > 0 and finite; a size negative or NaN; n_sigmas not
 *          > 0, INFINITY: no spike is judged; stuck_s 0: stuck is not judged).
 *          check: cannot fail; any bits whatever may be in the reading.
 *  Memory  the caller owns the struct; no pointer kept.
 */
#ifndef EXK_GUARD_H
#define EXK_GUARD_H

#include <stdbool.h>
#include <stdint.h>

#include "exk/axes.h"
#include "exk/err.h"
#include "exk/source.h"
#include "exk/twin.h"

/** On the wire as an index of the counts, so new ones go to the end. */
typedef enum {
    EXK_SAMPLE_GOOD,
    EXK_SAMPLE_MISSING,   /* no sample came */
    EXK_SAMPLE_LATE,      /* a newer one than any before, but of an earlier tick */
    EXK_SAMPLE_REPEATED,  /* the newest one again */
    EXK_SAMPLE_REORDERED, /* older than the newest, or of a tick still to come */
    EXK_SAMPLE_NAN,
    EXK_SAMPLE_INFINITE,
    EXK_SAMPLE_RANGE,
    EXK_SAMPLE_STUCK,
    EXK_SAMPLE_SPIKE,
    EXK_SAMPLE_COUNT
} exk_sample_kind;

typedef struct {
    double dt_s;
    double angle_max_rad; /* range of the sensor, both ways */
    double servo_tau_s;   /* of the expected servo, 0: none */
    double white_rad;     /* sqrt(R): new in every sample */
    double walk_rad;      /* sqrt(Q): adds up, a step */
    double drift_rad;     /* steady movement, a step, at most */
    double start_rad;     /* steady offset of the first sample, at most; INFINITY: not known */
    double noise_rad;     /* of the sensor alone */
    double quantum_rad;   /* of the sensor, 0: none */
    double n_sigmas;      /* of a spike */
    double stuck_s;
} exk_guard_config;

typedef struct {
    double expected_rad;  /* x */
    double reference_rad; /* r through the same servo */
    double offset_rad;    /* d^ */
    double before_rad;    /* d^ without the newest sample in it */
    double last_rad;      /* d - d^ of that sample, e1 */
    double raw_rad;       /* newest finite sample, good or not */
    double moved_from;    /* reference when raw last changed */
    double expected_from; /* x then */
    int64_t n_same;       /* repeats of raw */
    int64_t k_news;       /* last tick that told something */
    int64_t n_news;       /* samples in d^; 0: nothing known */
} exk_guard_axis;

typedef struct {
    exk_guard_config cfg;  /* fixed by init */
    double pole;           /* a */
    double gain;           /* K */
    double variance;       /* P + R */
    double limit_rad;      /* of a spike one tick after a good sample, d^ grown up */
    double back_limit_rad; /* of A^ */
    double fixed_rad;      /* part of the limit that is not noise, a tick */
    int64_t n_stuck;       /* repeats while the reference moves */
    int64_t n_stuck_rest;  /* repeats at rest; 0: not judged at rest */
    exk_guard_axis axis[EXK_N_AXES];
    double command_rad[EXK_N_AXES]; /* of tick k, as is asked_rad, the reference */
    double asked_rad[EXK_N_AXES];
    int64_t k;      /* tick of x, -1 before the first */
    int64_t newest; /* tick of the newest sample that arrived, -1: none */
    bool starts;    /* no sample was good since reset */
    int64_t n[EXK_SAMPLE_COUNT];
    int bad_axis; /* of the last rejected sample: its angle, value and limit */
    double bad_value;
    double bad_limit;
} exk_guard;

/** 1 kHz, 0.6 rad, spikes off, stuck within 15 ms. */
exk_guard_config exk_guard_default(void);
exk_err exk_guard_init(exk_guard *guard, const exk_guard_config *cfg);

/** Forgets the machine, keeps the configuration and the counts. */
void exk_guard_reset(exk_guard *guard);

/** Forgets what the machine adds: it may have been seen to. */
void exk_guard_forget(exk_guard *guard);

/** Judges the reading of tick k, whose reference was r and command q. k may jump; x is carried over
 *  skipped ticks. */
exk_sample_kind exk_guard_check(exk_guard *guard, int64_t k, const double r_rad[EXK_N_AXES],
                                const double q_rad[EXK_N_AXES], const exk_reading *reading);

/** Noise, walk, drift and servo that a twin of this configuration shows within duration_s. */
void exk_guard_expect(const exk_twin_config *twin, double duration_s, exk_guard_config *cfg);

const char *exk_sample_kind_name(exk_sample_kind kind); /* never NULL */

#endif
