#include "tally.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "exk/quantile.h"

enum {
    BITS_AN_OCTAVE = 8, /* 256 bins */
    LOWEST_EXPONENT = -34,
    HIGHEST_EXPONENT = 2,
    OCTAVES = HIGHEST_EXPONENT - LOWEST_EXPONENT,
    LOG_BINS = (OCTAVES << BITS_AN_OCTAVE) + 2, /* one below, one above */
    MANTISSA_BITS = 52,
    EXPONENT_BIAS = 1023
};

uint32_t study_bins_needed(const study_measure *measure)
{
    switch (measure->kind) {
    case STUDY_LENGTH:
        return LOG_BINS;
    case STUDY_COUNT:
        return measure->count_max + 1;
    case STUDY_SIGNED:
        return 0;
    }
    return 0;
}

void study_tally_clear(study_tally *tally)
{
    const bool was_used = tally->moments.n > 0;
    exk_moments_reset(&tally->moments);
    tally->min = INFINITY;
    tally->max = -INFINITY;
    tally->n_positive = 0;
    tally->n_bad = 0;
    if (was_used && tally->n_bins > 0) {
        memset(tally->bins, 0, tally->n_bins * sizeof *tally->bins);
    }
}

void study_tally_init(study_tally *tally, const study_measure *measure, uint32_t *bins)
{
    *tally = (study_tally){
        .kind = measure->kind, .n_bins = study_bins_needed(measure), .bins = bins};
    tally->moments.n = 1; /* the bins may hold anything yet */
    study_tally_clear(tally);
}

/* Exponent and first bits of the mantissa of a positive number, less those of the lowest bin. */
static uint32_t log_bin(double value)
{
    uint64_t bits = 0;
    const double lowest = ldexp(1.0, LOWEST_EXPONENT);
    if (!(value >= lowest)) {
        return 0;
    }
    memcpy(&bits, &value, sizeof bits);
    const uint64_t step = bits >> (MANTISSA_BITS - BITS_AN_OCTAVE);
    const uint64_t first = (uint64_t)(LOWEST_EXPONENT + EXPONENT_BIAS) << BITS_AN_OCTAVE;
    const uint64_t bin = step - first + 1;
    return bin < LOG_BINS - 1 ? (uint32_t)bin : LOG_BINS - 1;
}

static uint32_t bin_of(const study_tally *tally, double value)
{
    if (tally->kind == STUDY_LENGTH) {
        return log_bin(value);
    }
    const double whole = fmax(0.0, nearbyint(value));
    return whole < (double)tally->n_bins ? (uint32_t)whole : tally->n_bins - 1;
}

void study_tally_add(study_tally *tally, double value)
{
    if (!isfinite(value)) {
        tally->n_bad++;
        return;
    }
    exk_moments_add(&tally->moments, value);
    tally->min = fmin(tally->min, value);
    tally->max = fmax(tally->max, value);
    tally->n_positive += value > 0.0;
    if (tally->n_bins > 0) {
        tally->bins[bin_of(tally, value)]++;
    }
}

void study_tally_merge(study_tally *into, const study_tally *part)
{
    exk_moments_merge(&into->moments, &part->moments);
    into->min = fmin(into->min, part->min);
    into->max = fmax(into->max, part->max);
    into->n_positive += part->n_positive;
    into->n_bad += part->n_bad;
    for (uint32_t i = 0; i < into->n_bins && part->moments.n > 0; i++) {
        into->bins[i] += part->bins[i];
    }
}

/* Lower edge of a log bin, 1 <= bin. */
static double log_edge(uint32_t bin)
{
    const uint32_t step = bin - 1;
    const uint32_t per_octave = 1U << BITS_AN_OCTAVE;
    const double mantissa = 1.0 + (double)(step % per_octave) / per_octave;
    return ldexp(mantissa, LOWEST_EXPONENT + (int)(step / per_octave));
}

/* The value the fraction of the way through a bin, kept within what was really seen. */
static double value_in(const study_tally *tally, uint32_t bin, double fraction)
{
    if (tally->kind == STUDY_COUNT) {
        return (double)bin;
    }
    const double low = bin == 0 ? 0.0 : log_edge(bin);
    const double high = bin == LOG_BINS - 1 ? tally->max : log_edge(bin + 1);
    const double value = low + fraction * (high - low);
    return fmin(fmax(value, tally->min), tally->max);
}

double study_tally_quantile(const study_tally *tally, double p)
{
    const double wanted = p * (double)tally->moments.n;
    double before = 0.0;
    for (uint32_t i = 0; i < tally->n_bins; i++) {
        const double here = tally->bins[i];
        if (here > 0.0 && before + here >= wanted) {
            return value_in(tally, i, (wanted - before) / here);
        }
        before += here;
    }
    return NAN;
}

/* Share of a bin at or below a value that falls into it. */
static double share_of_bin(const study_tally *tally, uint32_t bin, double value)
{
    const double low = value_in(tally, bin, 0.0);
    const double high = value_in(tally, bin, 1.0);
    return high > low ? fmin(fmax((value - low) / (high - low), 0.0), 1.0) : value >= high;
}

double study_tally_below(const study_tally *tally, double value)
{
    double n = 0.0;
    if (tally->n_bins == 0 || isnan(value)) {
        return NAN;
    }
    const uint32_t last = tally->kind == STUDY_LENGTH ? log_bin(value) : bin_of(tally, value);
    for (uint32_t i = 0; i < last; i++) {
        n += tally->bins[i];
    }
    return n + share_of_bin(tally, last, value) * tally->bins[last];
}

double study_tally_ci95(const study_tally *tally)
{
    return exk_normal_quantile(0.975) * exk_moments_std(&tally->moments) /
           sqrt((double)tally->moments.n);
}
