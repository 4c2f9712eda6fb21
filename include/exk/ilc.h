/** Iterative learning control of one angle: a stored correction, improved between runs.
 *
 *  u_{p+1}[k] = clip( Q( u_p[k] + gain x[k] + d_gain (x[k] - x[k-1])/dt ), u_max ),
 *               x[k] = e_p[k+lead] + c_p[k], e_p held at its last sample past the end, x[-1] = x[0]
 *  Why c_p: the law learns what the loop would have missed without feedback, so the error falls
 *           as (1-gain)^(p-1) with PI on too (docs/step.md).
 *  Why the difference looks back: x = -(n + u) on the unit-gain axis, so a pass multiplies x by
 *           1 - gain - h (1 - 1/z), h = d_gain/dt, whose largest size on the unit circle is
 *           max(|1 - gain|, |1 - gain - 2 h|): every frequency shrinks in every pass exactly when
 *           0 < gain and gain + 2 h < 2. Looking ahead instead would need 2 h < gain. Look ahead
 *           with lead.
 *  Q        second-order Butterworth low-pass run forwards, then backwards: no phase, gain 1/2 at
 *           cutoff_Hz (1/sqrt(2) each way); each way starts at rest on its first sample, so a
 *           constant passes as it is. 0: no filter.
 *  Shapes   arrays of n samples, one call an angle.  Units  u, e, c [rad]; gain [1]; d_gain [s].
 *  Errors   check: EXK_ERR_ARG unless dt > 0, 0 < gain < 2, 0 <= d_gain, gain + 2 d_gain/dt < 2,
 *           0 <= lead <= 1000, 0 <= cutoff < 1/(4 dt) (half of Nyquist), u_max > 0, all finite.
 *           learn: EXK_ERR_SIZE (n = 0), EXK_ERR_ARG (check refuses cfg, u_next overlaps an input,
 *           or a value not finite, in or out). All or nothing: on error the caller must not use
 *           u_next; u is never written.
 *  Memory   the caller lends every array; nothing is kept, no work space.
 */
#ifndef EXK_ILC_H
#define EXK_ILC_H

#include <stddef.h>
#include <stdint.h>

#include "exk/err.h"

typedef struct {
    double gain;      /* [1] */
    double d_gain_s;  /* [s], 0: P-type */
    int lead;         /* d, samples */
    double cutoff_Hz; /* of Q, 0: no filter */
    double u_max_rad; /* u is clipped to +-u_max */
    double dt_s;
} exk_ilc_config;

enum { EXK_ILC_LEAD_MAX = 1000 };

/** The study's law: gain 0.5, P-type, no lead, no filter, limit 0.1 rad, 1 kHz. */
exk_ilc_config exk_ilc_default(void);
exk_err exk_ilc_check(const exk_ilc_config *cfg);

/** Stored correction at tick k; the last sample is held past the end; 0 when n is 0. */
static inline double exk_ilc_at(const double *u_rad, size_t n, int64_t k)
{
    if (n == 0 || k < 0) {
        return 0.0;
    }
    return (uint64_t)k < n ? u_rad[k] : u_rad[n - 1];
}

/** u_{p+1} of a whole run from its u_p, e_p and c_p. */
exk_err exk_ilc_learn(const exk_ilc_config *cfg, const double *u_rad, const double *e_rad,
                      const double *c_rad, size_t n, double *u_next_rad);

#endif
