/** Three-component vectors as plain double[3]; inline, no allocation, no failure.
 *
 *  Shapes  double[3] in, double[3] or scalar out; the output may not overlap an input of cross.
 */
#ifndef EXK_VEC3_H
#define EXK_VEC3_H

#include <math.h>
#include <stdbool.h>

static inline double exk_dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double exk_norm3(const double a[3])
{
    return sqrt(exk_dot3(a, a));
}

static inline void exk_cross3(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static inline void exk_copy3(const double a[3], double out[3])
{
    out[0] = a[0];
    out[1] = a[1];
    out[2] = a[2];
}

/** out = a + scale * b; out may be a or b. */
static inline void exk_add_scaled3(const double a[3], double scale, const double b[3],
                                   double out[3])
{
    out[0] = a[0] + scale * b[0];
    out[1] = a[1] + scale * b[1];
    out[2] = a[2] + scale * b[2];
}

/** True when every component is finite. */
static inline bool exk_finite3(const double a[3])
{
    return isfinite(a[0]) && isfinite(a[1]) && isfinite(a[2]);
}

#endif
