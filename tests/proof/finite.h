/** What Eva knows too little of: isfinite asked in a way that keeps the range of x, and tan, of which only
 *  0 to pi/4 is used. */
#ifndef EXK_PROOF_FINITE_H
#define EXK_PROOF_FINITE_H

#include <__fc_builtin.h>
#include <float.h>
#include <math.h>

#undef isfinite
#define isfinite(x) ((x) == (x) && (x) >= -DBL_MAX && (x) <= DBL_MAX)

static inline double proof_tan(double x)
{
    return x >= 0.0 && x <= 0.7854 ? Frama_C_double_interval(0.0, 1.00001) : tan(x);
}
#define tan proof_tan

#endif
