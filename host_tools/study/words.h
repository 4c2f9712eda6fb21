/** Claims in words as statistics with a test; each may come out false.
 *
 *  Paired     one difference a trial, both sides on the same random numbers; statistic: its mean over its
 *             standard error, against "not above 0", one-sided, normal (n is in the hundreds).
 *  Share      of trials in which a thing happens; statistic z against chance p0, one-sided normal.
 *  Two rates  37 of 45 against another count of 45, pooled z, one-sided.
 *  Holds      p below 0.01 (there are some twenty claims); a statistic on the wrong side never does.
 *  Errors     fewer than two trials, or no spread at all where the mean is 0: p is 1.
 */
#ifndef STUDY_WORDS_H
#define STUDY_WORDS_H

#include <stdbool.h>

#include "paper.h"

typedef struct {
    const char *id;
    const char *claim;     /* as the study says it, and how it is read */
    const char *effect_is; /* what effect is, with its unit */
    double effect;
    exk_interval ci95; /* of effect */
    double statistic;
    double p_value;
    bool holds;
} study_word;

enum { STUDY_WORDS_MAX = 32 };

/** Fills words; returns how many. */
size_t study_words(const study_tally *tallies, study_word words[STUDY_WORDS_MAX]);

#endif
