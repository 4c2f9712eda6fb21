/** What is kept of one measured number over many trials, so that parts add up to the whole.
 *
 *  Kept      count, mean and M2 (Welford; parts merge as exk_moments_merge), smallest, largest, how many
 *            are above 0, and bins for quantiles.
 *  Bins      LENGTH: 256 to an octave from 2^-34 to 2^2 (59 pm to 4 m), read from the bits of the
 *            number, so that no rounding of a logarithm decides; a quantile is linear within its
 *            bin and so off by less than 0.2 %. COUNT: one bin a whole number, exact. SIGNED: none.
 *  Quantile  the smallest value that at least the share p of all values does not exceed.
 *  Order     merging is not associative to the last bit: merge in block order for equal bytes.
 *  Errors    a value that is not finite is counted apart and enters nothing else; a quantile
 *            without bins or values is NaN.
 *  Memory    the caller lends the bins, study_bins_needed of them, zeroed by study_tally_init.
 */
#ifndef STUDY_TALLY_H
#define STUDY_TALLY_H

#include <stddef.h>
#include <stdint.h>

#include "exk/stats.h"

typedef enum { STUDY_LENGTH, STUDY_COUNT, STUDY_SIGNED } study_kind;

enum { STUDY_KEY_MAX = 32 };

typedef struct {
    char key[STUDY_KEY_MAX];
    const char *unit; /* m, m2 or none: "" */
    study_kind kind;
    uint32_t count_max; /* COUNT: largest value; larger ones count as it */
} study_measure;

typedef struct {
    exk_moments moments;
    double min;
    double max;
    uint64_t n_positive;
    uint64_t n_bad; /* not finite */
    study_kind kind;
    uint32_t n_bins;
    uint32_t *bins;
} study_tally;

uint32_t study_bins_needed(const study_measure *measure);
void study_tally_init(study_tally *tally, const study_measure *measure, uint32_t *bins);
void study_tally_clear(study_tally *tally);
void study_tally_add(study_tally *tally, double value);

/** into += part; both of the same measure. */
void study_tally_merge(study_tally *into, const study_tally *part);

/** 0 < p < 1. */
double study_tally_quantile(const study_tally *tally, double p);

/** How many values do not exceed value; linear within a bin, NaN without bins. */
double study_tally_below(const study_tally *tally, double value);

/** Half the width of the 95 % confidence interval of the mean; NaN below two values. */
double study_tally_ci95(const study_tally *tally);

#endif
