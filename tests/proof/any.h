/** Values of which Frama-C Eva knows nothing but their range. */
#ifndef EXK_PROOF_ANY_H
#define EXK_PROOF_ANY_H

#include <__fc_builtin.h>
#include <stdint.h>

extern volatile double exk_any_bits; /* every double: finite, infinite and NaN */
extern volatile int64_t exk_any_tick;
extern volatile int exk_any_int;

static inline double any_bits(void)
{
    return exk_any_bits;
}

static inline double any_in(double low, double high)
{
    return Frama_C_double_interval(low, high);
}

static inline int any_of(int n)
{
    return Frama_C_interval(0, n - 1);
}

#endif
