#include "exk/quantile.h"

#include <math.h>

#include "exk/as241.h"

double exk_normal_quantile(double p)
{
    if (!(p > 0.0 && p < 1.0)) {
        return (double)NAN;
    }
    return exk_as241(p - 0.5, p < 0.5 ? p : 1.0 - p);
}
