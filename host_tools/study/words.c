#include "words.h"

#include <math.h>

#include "exk/quantile.h"
#include "exk/units.h"

static const double significant = 0.01;

typedef enum { PAIRED, SHARE } test_kind;

typedef struct {
    const char *id;
    const char *claim;
    test_kind kind;
    study_paper_measure of;
    double chance; /* SHARE: what would be so without any effect */
} row;

static const row rows[] = {
    {"S1", "sine: noise on beta alone stays closer to the expected path than on alpha alone",
     PAIRED, STUDY_M_S1_ALPHA_LESS_BETA, 0.0},
    {"S1_both", "sine: noise on alpha alone stays closer than on both angles", PAIRED,
     STUDY_M_S1_BOTH_LESS_ALPHA, 0.0},
    {"S2", "AWGN accumulates (first order): the second half of the run is worse than the first",
     PAIRED, STUDY_M_S2_GROWTH, 0.0},
    {"S2_zero_order", "AWGN accumulates, read as zero order: the second half is worse", PAIRED,
     STUDY_M_S2_WHITE_GROWTH, 0.0},
    {"S2_alpha", "AWGN: noise on beta alone stays closer to the path than on alpha alone",
     PAIRED, STUDY_M_S2_ALPHA_LESS_BETA, 0.0},
    {"S3_negative", "a negative force sends the tool to the third quadrant", SHARE,
     STUDY_M_S3_MINUS_END, 0.25},
    {"S3_positive", "a positive force sends the tool to the first quadrant", SHARE,
     STUDY_M_S3_PLUS_END, 0.25},
    {"S3_strongest", "second-order noise is stronger than AWGN (first order), at our sizes",
     PAIRED, STUDY_M_S3_LESS_S2, 0.0},
    {"S3_over_sine", "second-order noise is stronger than the sine, at our sizes", PAIRED,
     STUDY_M_S3_LESS_S1, 0.0},
    {"S4_run2", "ILC: the error falls from run 1 to run 2", PAIRED, STUDY_M_S4_FALL_2, 0.0},
    {"S4_run3", "ILC: the error falls from run 2 to run 3", PAIRED, STUDY_M_S4_FALL_3, 0.0},
    {"S4_gap", "ILC: at run 3 a gap is left between last point and start", PAIRED,
     STUDY_M_S4_GAP, 0.0},
    {"S4_alpha", "ILC: that gap comes from alpha, |dx| > |dy| at the last point", PAIRED,
     STUDY_M_S4_DX_LESS_DY, 0.0},
    {"S7_edge", "25 holes, zero order: holes on the edge are worse than the inner ones", PAIRED,
     STUDY_M_S7_EDGE, 0.0},
    {"S7_turn", "25 holes, zero order: holes at turning points are worse than the others",
     PAIRED, STUDY_M_S7_TURN, 0.0},
    {"S8_mean", "25 holes: the mean error of first order is larger than that of zero order",
     PAIRED, STUDY_M_S8_LESS_S7, 0.0},
    {"S8_edge", "25 holes, first order: holes on the edge are worse than the inner ones",
     PAIRED, STUDY_M_S8_EDGE, 0.0},
    {"S8_turn", "25 holes, first order: holes at turning points are worse than the others",
     PAIRED, STUDY_M_S8_TURN, 0.0},
};

static double upper_tail(double z)
{
    return 0.5 * erfc(z / sqrt(2.0));
}

static void conclude(study_word *word, double statistic)
{
    word->statistic = statistic;
    word->p_value = isnan(statistic) ? 1.0 : upper_tail(statistic);
    word->holds = word->p_value < significant;
}

static void test_paired(study_word *word, const study_tally *tally)
{
    const double half = study_tally_ci95(tally);
    const double mean = tally->moments.mean;
    const double error = exk_moments_std(&tally->moments) / sqrt((double)tally->moments.n);
    word->effect = EXK_MM_PER_M * mean;
    word->ci95 = (exk_interval){EXK_MM_PER_M * (mean - half), EXK_MM_PER_M * (mean + half)};
    word->effect_is = "mean difference, mm";
    conclude(word, mean / error);
}

static void test_share(study_word *word, const study_tally *tally, double chance)
{
    const double n = (double)tally->moments.n;
    word->effect = tally->moments.mean;
    word->ci95 = exk_wilson(tally->n_positive, tally->moments.n, 0.95);
    word->effect_is = "share of trials";
    conclude(word, (word->effect - chance) / sqrt(chance * (1.0 - chance) / n));
}

/* k_better of n against k_worse of n. */
static study_word compare_rates(const char *id, const char *claim, double k_better,
                                double k_worse, double n)
{
    study_word word = {.id = id, .claim = claim, .effect_is = "difference of the shares"};
    const double pooled = (k_better + k_worse) / (2.0 * n);
    const double error = sqrt(2.0 * pooled * (1.0 - pooled) / n);
    const double half = exk_normal_quantile(0.975) * error;
    word.effect = (k_better - k_worse) / n;
    word.ci95 = (exk_interval){word.effect - half, word.effect + half};
    conclude(&word, word.effect / error);
    return word;
}

size_t study_words(const study_tally *tallies, study_word words[STUDY_WORDS_MAX])
{
    size_t n = 0;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const study_tally *tally = &tallies[rows[i].of];
        if (tally->moments.n == 0) {
            continue; /* its experiment was left out */
        }
        words[n] = (study_word){.id = rows[i].id, .claim = rows[i].claim};
        if (rows[i].kind == PAIRED) {
            test_paired(&words[n], tally);
        } else {
            test_share(&words[n], tally, rows[i].chance);
        }
        n++;
    }
    words[n++] = compare_rates(
        "S10", "Mazak (45 of 45, count assumed) has more holes inside than Exechon (37 of 45)",
        45.0, 37.0, 45.0);
    words[n++] = compare_rates(
        "S11", "Exechon (37 of 45) has more holes inside than Loxin (36 of 45, count assumed)",
        37.0, 36.0, 45.0);
    return n;
}
