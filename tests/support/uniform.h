/** Repeatable uniform numbers for tests that link one room alone (SplitMix64). */
#ifndef EXK_TESTS_UNIFORM_H
#define EXK_TESTS_UNIFORM_H

#include <stdint.h>

typedef struct {
    uint64_t state;
} uniform;

static inline uint64_t uniform_bits(uniform *u)
{
    uint64_t z = (u->state += UINT64_C(0x9E3779B97F4A7C15));
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

static inline double uniform_in(uniform *u, double low, double high)
{
    return low + (high - low) * (double)(uniform_bits(u) >> 11) * 0x1p-53;
}

#endif
