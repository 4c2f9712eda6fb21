#include <math.h>

#include "exk/stats.h"
#include "exk/units.h"

enum { BESSEL_STEPS = 512, INSIDE_STEPS = 4096, BISECTIONS = 60 };

static const double ratio_max = 30.0; /* offset / sigma; beyond it the error is all offset */

/* exp(-x) I_n(x) = 1/pi integral over 0..pi of exp(x (cos t - 1)) cos(n t): the trapezoid rule of a
 * periodic function, exact to rounding for the x of ratio_max. */
static double scaled_bessel(int n, double x)
{
    double sum = 0.0;
    for (int i = 0; i <= BESSEL_STEPS; i++) {
        const double t = EXK_PI * i / BESSEL_STEPS;
        const double weight = i == 0 || i == BESSEL_STEPS ? 0.5 : 1.0;
        sum += weight * exp(x * (cos(t) - 1.0)) * cos(n * t);
    }
    return sum / BESSEL_STEPS;
}

exk_rician exk_rician_fit(double mean_r2, double var_r2)
{
    if (!(mean_r2 > 0.0 && var_r2 >= 0.0)) {
        return (exk_rician){NAN, NAN};
    }
    const double left = mean_r2 * mean_r2 - var_r2;
    const double variance = 0.5 * (mean_r2 - sqrt(fmax(left, 0.0)));
    return (exk_rician){sqrt(fmax(mean_r2 - 2.0 * variance, 0.0)), sqrt(variance)};
}

double exk_rician_mean(exk_rician r)
{
    if (!(r.offset >= 0.0 && r.sigma > 0.0 && r.offset <= ratio_max * r.sigma)) {
        return NAN;
    }
    const double half = 0.5 * (r.offset / r.sigma) * (r.offset / r.sigma);
    return r.sigma * sqrt(0.5 * EXK_PI) *
           ((1.0 + half) * scaled_bessel(0, 0.5 * half) + half * scaled_bessel(1, 0.5 * half));
}

/* x = limit sin t along the offset; across it a normal error between +-limit cos t. */
double exk_rician_inside(double limit, exk_rician r)
{
    if (!(limit >= 0.0 && r.offset >= 0.0 && r.sigma > 0.0)) {
        return NAN;
    }
    double sum = 0.0;
    for (int i = 1; i < INSIDE_STEPS; i++) {
        const double t = EXK_PI * ((double)i / INSIDE_STEPS - 0.5);
        const double z = (limit * sin(t) - r.offset) / r.sigma;
        sum += exp(-0.5 * z * z) * cos(t) * erf(limit * cos(t) / (r.sigma * sqrt(2.0)));
    }
    const double step = EXK_PI / INSIDE_STEPS;
    return sum * step * limit / (r.sigma * sqrt(2.0 * EXK_PI));
}

static exk_rician with_ratio(double mean, double ratio)
{
    const double unit_mean = exk_rician_mean((exk_rician){ratio, 1.0});
    return (exk_rician){mean * ratio / unit_mean, mean / unit_mean};
}

exk_rician exk_rician_of_mean_and_inside(double mean, double limit, double share)
{
    double low = 0.0;
    double high = ratio_max;
    if (!(mean > 0.0 && limit > mean) ||
        !(share >= exk_rician_inside(limit, with_ratio(mean, low)) &&
          share <= exk_rician_inside(limit, with_ratio(mean, high)))) {
        return (exk_rician){NAN, NAN};
    }
    for (int i = 0; i < BISECTIONS; i++) {
        const double middle = 0.5 * (low + high);
        if (exk_rician_inside(limit, with_ratio(mean, middle)) < share) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return with_ratio(mean, low);
}
