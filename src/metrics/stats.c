#include "exk/stats.h"

#include <math.h>

#include "exk/units.h"

static const double CAPABILITY_P = 0.99865; /* the upper three-sigma point of a normal error */
static const double RP_DEVIATIONS = 3.0;    /* ISO 9283 */

void exk_moments_reset(exk_moments *m)
{
    *m = (exk_moments){0};
}

void exk_moments_add(exk_moments *m, double x)
{
    const double delta = x - m->mean;
    m->n++;
    m->mean += delta / (double)m->n;
    m->m2 += delta * (x - m->mean);
}

void exk_moments_merge(exk_moments *into, const exk_moments *other)
{
    if (other->n == 0) {
        return;
    }
    const double n_a = (double)into->n;
    const double n_b = (double)other->n;
    const double delta = other->mean - into->mean;
    into->n += other->n;
    into->mean += delta * n_b / (n_a + n_b);
    into->m2 += other->m2 + delta * delta * n_a * n_b / (n_a + n_b);
}

double exk_moments_variance(const exk_moments *m)
{
    return m->n < 2 ? (double)NAN : m->m2 / (double)(m->n - 1);
}

double exk_moments_std(const exk_moments *m)
{
    return sqrt(exk_moments_variance(m));
}

double exk_true_position(double radial)
{
    return 2.0 * radial;
}

static double length2(double x, double y)
{
    return sqrt(x * x + y * y);
}

exk_pose_figures exk_pose_accuracy(const double *dx, const double *dy, size_t n)
{
    exk_moments x = {0};
    exk_moments y = {0};
    exk_moments distance = {0};
    for (size_t i = 0; i < n; i++) {
        exk_moments_add(&x, dx[i]);
        exk_moments_add(&y, dy[i]);
    }
    for (size_t i = 0; i < n; i++) {
        exk_moments_add(&distance, length2(dx[i] - x.mean, dy[i] - y.mean));
    }
    if (n == 0) {
        return (exk_pose_figures){NAN, NAN, NAN, NAN};
    }
    return (exk_pose_figures){x.mean, y.mean, length2(x.mean, y.mean),
                              distance.mean + RP_DEVIATIONS * exk_moments_std(&distance)};
}

double exk_rayleigh_fit(const double *r, size_t n)
{
    double sum_sq = 0.0;
    for (size_t i = 0; i < n; i++) {
        sum_sq += r[i] * r[i];
    }
    return n == 0 ? (double)NAN : sqrt(sum_sq / (2.0 * (double)n));
}

double exk_rayleigh_sigma_of_mean(double mean)
{
    return mean / sqrt(EXK_PI / 2.0);
}

double exk_rayleigh_inside(double limit, double sigma)
{
    if (!(limit >= 0.0 && sigma >= 0.0)) {
        return NAN;
    }
    const double t = limit / sigma;
    return sigma > 0.0 ? -expm1(-0.5 * t * t) : 1.0;
}

double exk_rayleigh_quantile(double p, double sigma)
{
    if (!(p >= 0.0 && p < 1.0 && sigma >= 0.0)) {
        return NAN;
    }
    return sigma * sqrt(-2.0 * log1p(-p));
}

double exk_rayleigh_ppk(double tolerance, double sigma)
{
    const double median = exk_rayleigh_quantile(0.5, sigma);
    return (tolerance - median) / (exk_rayleigh_quantile(CAPABILITY_P, sigma) - median);
}

double exk_rayleigh_sigma_for(double tolerance, double ppk)
{
    const double median = exk_rayleigh_quantile(0.5, 1.0);
    return tolerance / (median + ppk * (exk_rayleigh_quantile(CAPABILITY_P, 1.0) - median));
}
