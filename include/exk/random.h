/** Counter-based random numbers: a draw is a pure function of its numbers, so any split of the
 *  work over threads, ranks or runs gives the same bits.
 *
 *  Bits    Philox4x32-10 of Random123. key = seed (64 bit); counter = (low 32 bits of k, run,
 *          series, high 16 bits of k << 16 | source << 8 | channel).
 *  Normal  inverse normal distribution (Wichura, AS 241, PPND16) of a 53-bit uniform in (0, 1);
 *          relative accuracy about 1e-16. One block gives one channel's draw, or the pair that
 *          a second-order step needs.
 *  Errors  none: every input is a valid counter.  Memory  none.
 */
#ifndef EXK_RANDOM_H
#define EXK_RANDOM_H

#include <stdint.h>

/** Names one stream of draws. run is 0 for a frozen stream: the same realisation in every run. */
typedef struct {
    uint64_t seed;
    uint32_t series; /* trial index */
    uint32_t run;    /* repetition p within a series, 1 ..; 0 = frozen */
    uint8_t source;  /* disturbance index, or EXK_SOURCE_SENSOR */
    uint8_t channel; /* EXK_ALPHA or EXK_BETA */
} exk_stream;

enum { EXK_SOURCE_SENSOR = 255 };

/** Standard normal draw number k of a stream. */
double exk_normal(const exk_stream *stream, int64_t k);

/** Two independent standard normals from one block; z[0] equals exk_normal(stream, k). */
void exk_normal_pair(const exk_stream *stream, int64_t k, double z[2]);

/** Quantile of the standard normal, p in (0, 1); NaN outside. */
double exk_normal_quantile(double p);

#endif
