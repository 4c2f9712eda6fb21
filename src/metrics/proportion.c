#include <math.h>
#include <stdbool.h>

#include "exk/quantile.h"
#include "exk/stats.h"
#include "exk/units.h"

static bool is_fraction(double p)
{
    return p > 0.0 && p < 1.0; /* false for NaN */
}

exk_interval exk_wilson(uint64_t k, uint64_t n, double confidence)
{
    if (n == 0 || k > n || !is_fraction(confidence)) {
        return (exk_interval){NAN, NAN};
    }
    const double z = exk_normal_quantile(0.5 + 0.5 * confidence);
    const double size = (double)n;
    const double p = (double)k / size;
    const double zz_n = z * z / size;
    const double half = z * sqrt(p * (1.0 - p) / size + zz_n / (4.0 * size));
    const double low = (p + 0.5 * zz_n - half) / (1.0 + zz_n);
    const double high = (p + 0.5 * zz_n + half) / (1.0 + zz_n);
    return (exk_interval){k == 0 ? 0.0 : low, k == n ? 1.0 : high};
}

double exk_no_miss_bound(uint64_t n, double confidence)
{
    if (n == 0 || !is_fraction(confidence)) {
        return NAN;
    }
    return pow(1.0 - confidence, 1.0 / (double)n);
}

uint64_t exk_no_miss_size(double p, double confidence)
{
    if (!is_fraction(p) || !is_fraction(confidence)) {
        return 0;
    }
    return (uint64_t)ceil(log1p(-confidence) / log(p));
}

uint64_t exk_two_proportions_size(double p1, double p2, double confidence, double power)
{
    if (!(is_fraction(p1) && is_fraction(p2) && is_fraction(confidence) &&
          is_fraction(power)) ||
        p1 == p2) {
        return 0;
    }
    const double z = exk_normal_quantile(0.5 + 0.5 * confidence) + exk_normal_quantile(power);
    const double variance = p1 * (1.0 - p1) + p2 * (1.0 - p2);
    return (uint64_t)ceil(z * z * variance / ((p1 - p2) * (p1 - p2)));
}
