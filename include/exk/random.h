/** Counter-based random numbers: a draw is a pure function of its numbers, so any split of the
 *  work over threads, ranks or runs gives the same bits.
 *
 *  Bits    Philox4x32-10 (Salmon et al., SC 2011) of Random123. key = seed (64 bit, low word
 *          first); counter = (low 32 bits of k, run, series, bits 32..47 of k << 16 |
 *          source << 8 | channel): the streams of two different names never meet, and k repeats
 *          after 2^48 draws.
 *  Uniform u = (2 j + 1) 2^-53, j the upper 52 bits of (word 1, word 0) or (word 3, word 2):
 *          symmetric about 1/2, never 0 or 1, so |z| <= 8.21.
 *  Normal  inverse normal distribution (Wichura, Algorithm AS 241, PPND16) of u; relative error
 *          below 1e-15. One block gives one channel's draw, or the pair that a second-order step
 *          needs.
 *  Units   none; z has mean 0 and variance 1.
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

/** The four words of block number k. */
void exk_random_block(const exk_stream *stream, int64_t k, uint32_t word[4]);

/** Standard normal draw number k of a stream. */
double exk_normal(const exk_stream *stream, int64_t k);

/** Two independent standard normals from one block; z[0] equals exk_normal(stream, k). */
void exk_normal_pair(const exk_stream *stream, int64_t k, double z[2]);

#endif
