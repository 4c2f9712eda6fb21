/** Statistics of holes and of many runs: pure functions, no heap, no state but the caller's.
 *
 *  Moments   running mean and sum of squared deviations (Welford); two halves merge exactly as one
 *            stream would, up to rounding (Chan, Golub, LeVeque).
 *  Wilson    interval of a proportion k / n, z the normal quantile of (1 + confidence) / 2:
 *            (p + z^2/2n -+ z sqrt(p (1-p)/n + z^2/4n^2)) / (1 + z^2/n).
 *  Rayleigh  radial error of two normal axes of one sigma and no offset:
 *            P(r <= T) = 1 - exp(-T^2 / 2 s^2), mean = s sqrt(pi/2), median = s sqrt(2 ln 2).
 *            Fit: s = sqrt(mean r^2 / 2).
 *  Rician    radial error about a fixed offset v, same sigma s on both axes; v = 0 is Rayleigh.
 *            Fit from the moments of r^2: mean A = v^2 + 2 s^2, variance V = 4 s^2 (A - s^2), so
 *            s^2 = (A - sqrt(A^2 - V))/2; mean by Bessel functions, P(r <= T) by quadrature.
 *  Ppk       one-sided by quantiles, for an error that is not normal:
 *            (T - median) / (x_99.865 - median), x_p the Rayleigh quantile.
 *  AP, RP    after ISO 9283: AP is the distance of the mean point from the command, RP the mean
 *            distance from the mean point plus three standard deviations of it. The standard wants
 *            30 visits of one pose; over the holes of a job the figures are of that kind only.
 *  Sizes     holes without a miss that claim a proportion; holes to tell two proportions apart.
 *  Errors    a question without an answer (too few values, an argument out of range or NaN) gives
 *            NaN, a size 0. Nothing here fails otherwise.
 */
#ifndef EXK_STATS_H
#define EXK_STATS_H

#include <stddef.h>
#include <stdint.h>

typedef struct {
    uint64_t n;
    double mean;
    double m2; /* sum of squared deviations from the mean */
} exk_moments;

void exk_moments_reset(exk_moments *m);
void exk_moments_add(exk_moments *m, double x);
void exk_moments_merge(exk_moments *into, const exk_moments *other);
double exk_moments_variance(const exk_moments *m); /* unbiased, n - 1; NaN below two values */
double exk_moments_std(const exk_moments *m);

typedef struct {
    double low;
    double high;
} exk_interval;

/** Wilson interval of k good ones in n, for a confidence such as 0.95. */
exk_interval exk_wilson(uint64_t k, uint64_t n, double confidence);

/** One-sided lower bound of the proportion after n good ones out of n: (1-confidence)^(1/n). */
double exk_no_miss_bound(uint64_t n, double confidence);

/** Fewest good ones without a miss that claim a proportion p: smallest n with p^n <= 1-confidence. */
uint64_t exk_no_miss_size(double p, double confidence);

/** Size of each of two samples that tells p1 from p2, two-sided at the confidence, with the power
 *  given: (z_(1+c)/2 + z_power)^2 (p1 q1 + p2 q2) / (p1 - p2)^2, rounded up. */
uint64_t exk_two_proportions_size(double p1, double p2, double confidence, double power);

double exk_rayleigh_fit(const double *r, size_t n);          /* sigma from radial errors */
double exk_rayleigh_sigma_of_mean(double mean);              /* sigma from a published mean */
double exk_rayleigh_inside(double limit, double sigma);      /* P(r <= limit) */
double exk_rayleigh_quantile(double p, double sigma);        /* 0 <= p < 1 */
double exk_rayleigh_ppk(double tolerance, double sigma);     /* infinite for sigma 0 */
double exk_rayleigh_sigma_for(double tolerance, double ppk); /* largest sigma that reaches it */

typedef struct {
    double offset;
    double sigma;
} exk_rician;

/** From mean and variance of the squared radial error; more scatter than Rayleigh's gives offset 0. */
exk_rician exk_rician_fit(double mean_r2, double var_r2);
double exk_rician_mean(exk_rician r); /* offset <= 30 sigma */
double exk_rician_inside(double limit, exk_rician r);

/** The one with this mean and this share inside limit; NaN when there is none, or only with an
 *  offset beyond 30 sigma. limit > mean. */
exk_rician exk_rician_of_mean_and_inside(double mean, double limit, double share);

/** Diameter of the zone round the true position that the hole's axis lies in: 2 r. */
double exk_true_position(double radial);

typedef struct {
    double mean_dx;
    double mean_dy;
    double ap;
    double rp; /* NaN below two points */
} exk_pose_figures;

exk_pose_figures exk_pose_accuracy(const double *dx, const double *dy, size_t n);

/** A machine or model that the study published figures of. */
typedef struct {
    const char *name;
    const char *kind;    /* "measured machine" or "published model" */
    uint64_t n_holes;    /* 0: not published */
    uint64_t n_inside;   /* 0 where n_holes is */
    double correct_rate; /* 0 to 1, tolerance 0.03 mm */
    double mean_m;       /* of the radial error */
    const char *source;
} exk_reference;

/** Mazak, Loxin and the Exechon model of the study; *n receives how many. */
const exk_reference *exk_references(size_t *n);

#endif
