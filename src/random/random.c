#include "exk/random.h"

/* Random123 asserts that the number of rounds is allowed; ours is a constant, and the core may not
 * call abort. */
#define R123_ASSERT(x) ((void)0)
#include <Random123/philox.h>
#include <math.h>

#include "exk/as241.h"

static inline philox4x32_ctr_t block(const exk_stream *s, int64_t k)
{
    const uint64_t tick = (uint64_t)k;
    const uint32_t high = (uint32_t)(tick >> 32) << 16;
    const philox4x32_ctr_t counter = {
        {(uint32_t)tick, s->run, s->series, high | (uint32_t)s->source << 8 | s->channel}};
    const philox4x32_key_t key = {{(uint32_t)s->seed, (uint32_t)(s->seed >> 32)}};
    return philox4x32_R(10, counter, key);
}

/* u = (2 j + 1) 2^-53 with j the upper 52 bits: never 0 or 1, q = u - 1/2 is exact. */
static inline double normal_of(uint32_t low, uint32_t high)
{
    const uint64_t bits = (uint64_t)high << 32 | low;
    const double q = (double)(int64_t)(bits >> 12) * 0x1p-52 - (0.5 - 0x1p-53);
    return exk_as241(q, 0.5 - fabs(q));
}

void exk_random_block(const exk_stream *stream, int64_t k, uint32_t word[4])
{
    const philox4x32_ctr_t b = block(stream, k);
    for (int i = 0; i < 4; i++) {
        word[i] = b.v[i];
    }
}

double exk_normal(const exk_stream *stream, int64_t k)
{
    const philox4x32_ctr_t b = block(stream, k);
    return normal_of(b.v[0], b.v[1]);
}

void exk_normal_pair(const exk_stream *stream, int64_t k, double z[2])
{
    const philox4x32_ctr_t b = block(stream, k);
    z[0] = normal_of(b.v[0], b.v[1]);
    z[1] = normal_of(b.v[2], b.v[3]);
}
