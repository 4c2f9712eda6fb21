/** Inverse normal distribution by rational functions: AS 241, PPND16.
 *
 *  Source  M. J. Wichura, Applied Statistics 37, 1988, 477-484: relative accuracy about 1e-16.
 *  Shapes  q = p - 1/2 and p_small = min(p, 1 - p), each as exact as the caller knows it; inline,
 *          for the random numbers, which call it for every draw. Others: exk/quantile.h.
 *  Errors  none: 0 < p_small <= 1/2 is the caller's business.
 */
#ifndef EXK_AS241_H
#define EXK_AS241_H

#include <math.h>

/* Numerator and denominator of degree 7 side by side, low power first: two lanes that a compiler
 * turns into one vector; Estrin's grouping keeps the dependency chain short. */
static inline double exk_as241_ratio(const double a[8][2], double r)
{
    const double r2 = r * r;
    const double r4 = r2 * r2;
    double v[2];
    for (int i = 0; i < 2; i++) {
        const double low = (a[0][i] + a[1][i] * r) + (a[2][i] + a[3][i] * r) * r2;
        const double high = (a[4][i] + a[5][i] * r) + (a[6][i] + a[7][i] * r) * r2;
        v[i] = low + high * r4;
    }
    return v[0] / v[1];
}

/* Coefficients of AS 241, PPND16 (M. J. Wichura, Applied Statistics 37, 1988, 477-484). */
static const double exk_as241_centre[8][2] = {
    {3.3871328727963666080e0, 1.0},
    {1.3314166789178437745e2, 4.2313330701600911252e1},
    {1.9715909503065514427e3, 6.8718700749205790830e2},
    {1.3731693765509461125e4, 5.3941960214247511077e3},
    {4.5921953931549871457e4, 2.1213794301586595867e4},
    {6.7265770927008700853e4, 3.9307895800092710610e4},
    {3.3430575583588128105e4, 2.8729085735721942674e4},
    {2.5090809287301226727e3, 5.2264952788528545610e3},
};
static const double exk_as241_middle[8][2] = {
    {1.42343711074968357734e0, 1.0},
    {4.63033784615654529590e0, 2.05319162663775882187e0},
    {5.76949722146069140550e0, 1.67638483018380384940e0},
    {3.64784832476320460504e0, 6.89767334985100004550e-1},
    {1.27045825245236838258e0, 1.48103976427480074590e-1},
    {2.41780725177450611770e-1, 1.51986665636164571966e-2},
    {2.27238449892691845833e-2, 5.47593808499534494600e-4},
    {7.74545014278341407640e-4, 1.05075007164441684324e-9},
};
static const double exk_as241_tail[8][2] = {
    {6.65790464350110377720e0, 1.0},
    {5.46378491116411436990e0, 5.99832206555887937690e-1},
    {1.78482653991729133580e0, 1.36929880922735805310e-1},
    {2.96560571828504891230e-1, 1.48753612908506148525e-2},
    {2.65321895265761230930e-2, 7.86869131145613259100e-4},
    {1.24266094738807843860e-3, 1.84631831751005468180e-5},
    {2.71155556874348757815e-5, 1.42151175831644588870e-7},
    {2.01033439929228813265e-7, 2.04426310338993978564e-15},
};

/* Quantile beyond the centre; p_small = min(p, 1 - p). Positive. */
static inline double exk_as241_outer(double p_small)
{
    const double r = sqrt(-log(p_small));
    if (r <= 5.0) {
        return exk_as241_ratio(exk_as241_middle, r - 1.6);
    }
    return exk_as241_ratio(exk_as241_tail, r - 5.0);
}

/* q = p - 1/2; p_small = min(p, 1 - p), as exact as the caller knows it. */
static inline double exk_as241(double q, double p_small)
{
    if (fabs(q) <= 0.425) {
        return q * exk_as241_ratio(exk_as241_centre, 0.180625 - q * q); /* 0.425^2 - q^2 */
    }
    return copysign(exk_as241_outer(p_small), q);
}

#endif
