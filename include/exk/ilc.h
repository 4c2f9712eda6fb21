/** Iterative learning control of one angle: a stored correction, improved between runs.
 *
 *  u_{p+1}[k] = Q( u_p[k] + gain (e_p[k+lead] + c_p[k]) + d_gain (x[k+1] - x[k])/dt ),
 *               x[k] = e_p[k+lead] + c_p[k]; the last sample is held past the end
 *  Why c_p: the law learns what the loop would have missed without feedback, so the error falls
 *           as (1-gain)^(p-1) with PI on too (architecture.md section 2).
 *  Q        second-order low-pass run forwards and backwards (zero phase), cutoff_Hz; 0: no filter.
 *  Units    u, e, c [rad]; gain [1]; d_gain [s]; one call an angle.
 *  Errors   check: EXK_ERR_ARG unless 0 < gain < 2, 0 <= d_gain/dt, gain + 2 d_gain/dt < 2,
 *           0 <= lead <= 1000, 0 <= cutoff < Nyquist/2, u_max > 0, all finite.
 *           learn: EXK_ERR_SIZE (n = 0), EXK_ERR_ARG (overlap of u_next with an input, or a value
 *           not finite, in or out). All or nothing: on error the caller must not use u_next; u is
 *           never written.
 *  Memory   the caller lends every array; nothing is kept.
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

exk_err exk_ilc_learn(const exk_ilc_config *cfg, const double *u_rad, const double *e_rad,
                      const double *c_rad, size_t n, double *u_next_rad);

#endif
