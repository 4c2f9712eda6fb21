#include <math.h>
#include <string.h>

#include "claims.h"
#include "unity.h"
#include "words.h"

static study_sums sums;
static study_measure measures[STUDY_N_PAPER];

/* The kinds that claims and words read; keys do not matter here. */
void setUp(void)
{
    for (int i = 0; i < STUDY_N_PAPER; i++) {
        measures[i] = (study_measure){.unit = "m", .kind = STUDY_LENGTH};
    }
    measures[STUDY_M_S9_INSIDE] =
        (study_measure){.unit = "", .kind = STUDY_COUNT, .count_max = STUDY_GRID45};
    measures[STUDY_M_S3_MINUS_END].kind = STUDY_COUNT;
    measures[STUDY_M_S3_MINUS_END].count_max = 1;
    study_sums_open(&sums, measures, STUDY_N_PAPER);
}

void tearDown(void)
{
    study_sums_close(&sums);
}

static const study_claim *claim(const char *id)
{
    size_t n = 0;
    const study_claim *claims = study_claims(&n);
    for (size_t i = 0; i < n; i++) {
        if (strcmp(claims[i].id, id) == 0) {
            return &claims[i];
        }
    }
    TEST_FAIL_MESSAGE(id);
    return NULL;
}

/* n values spread evenly from low to high. */
static void spread(study_paper_measure measure, double low, double high, int n)
{
    for (int i = 0; i < n; i++) {
        study_tally_add(&sums.tallies[measure], low + (high - low) * i / (n - 1));
    }
}

static void a_printed_figure_stands_for_its_rounding_interval(void)
{
    static const struct {
        const char *name;
        double high_mm; /* upper end of the simulated values, 0.05 the lower */
        bool inside;    /* published 0.07, printed to 0.01: 0.065 to 0.075 */
    } rows[] = {{"far below", 0.060, false},
                {"just below the rounding interval", 0.0645, false},
                {"within rounding of it", 0.0670, true},
                {"beyond it", 0.0900, true}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        study_tally_clear(&sums.tallies[STUDY_M_S7_MAX]);
        spread(STUDY_M_S7_MAX, 0.05e-3, rows[i].high_mm * 1e-3, 2001);
        const study_verdict v = study_judge(claim("S7_max"), sums.tallies);
        TEST_ASSERT_EQUAL_MESSAGE(rows[i].inside, v.inside, rows[i].name);
        /* 97.5 % of an even spread; a bin is 1/256 wide */
        const double want = 0.05 + 0.975 * (rows[i].high_mm - 0.05);
        TEST_ASSERT_DOUBLE_WITHIN(want / 256.0, want, v.prediction95.high);
    }
}

static void a_figure_above_or_below_all_is_outside(void)
{
    spread(STUDY_M_S7_MAX, 0.08e-3, 0.09e-3, 100);
    TEST_ASSERT_FALSE(study_judge(claim("S7_max"), sums.tallies).inside);
}

static void nothing_simulated_is_not_inside(void)
{
    TEST_ASSERT_FALSE(study_was_run(claim("S8_max"), sums.tallies));
    TEST_ASSERT_FALSE(study_judge(claim("S8_max"), sums.tallies).inside);
}

static void the_rate_is_a_share_of_45(void)
{
    for (int i = 0; i < 1000; i++) {
        study_tally_add(&sums.tallies[STUDY_M_S9_INSIDE], 30 + i % 9);
    }
    const study_verdict v = study_judge(claim("S9_rate"), sums.tallies);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 34.0 / 45.0, v.mean);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 30.0 / 45.0, v.prediction95.low);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 38.0 / 45.0, v.prediction95.high);
    TEST_ASSERT_TRUE(v.inside);
}

static study_word word(const char *id)
{
    study_word words[STUDY_WORDS_MAX];
    const size_t n = study_words(sums.tallies, words);
    for (size_t i = 0; i < n; i++) {
        if (strcmp(words[i].id, id) == 0) {
            return words[i];
        }
    }
    TEST_FAIL_MESSAGE(id);
    return words[0];
}

static void a_paired_difference_is_tested_on_its_side(void)
{
    static const struct {
        const char *name;
        double mean, statistic;
        bool holds;
    } rows[] = {{"clear", 1.0, 10.0, true},
                {"none", 0.0, 0.0, false},
                {"other side", -1.0, -10.0, false}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        study_tally_clear(&sums.tallies[STUDY_M_S8_EDGE]);
        for (int j = 0; j < 100; j++) {
            study_tally_add(&sums.tallies[STUDY_M_S8_EDGE],
                            1e-3 * (rows[i].mean + (j % 2 == 0 ? 1.0 : -1.0)));
        }
        const study_word w = word("S8_edge");
        /* standard error sqrt(100/99)/10 of the spread 1 */
        TEST_ASSERT_DOUBLE_WITHIN(0.06, rows[i].statistic, w.statistic);
        TEST_ASSERT_EQUAL_MESSAGE(rows[i].holds, w.holds, rows[i].name);
    }
}

static void a_share_is_tested_against_chance(void)
{
    for (int i = 0; i < 400; i++) {
        study_tally_add(&sums.tallies[STUDY_M_S3_MINUS_END], i % 2);
    }
    const study_word w = word("S3_negative");
    /* (0.5 - 0.25) / sqrt(0.25 0.75 / 400) */
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 11.547005383792515, w.statistic);
    TEST_ASSERT_TRUE(w.holds);
}

static void rates_of_the_measured_machines(void)
{
    /* pooled z of 45 and 37, 37 and 36 of 45 */
    TEST_ASSERT_DOUBLE_WITHIN(5e-4, 2.9630, word("S10").statistic);
    TEST_ASSERT_TRUE(word("S10").holds);
    TEST_ASSERT_DOUBLE_WITHIN(5e-4, 0.2693, word("S11").statistic);
    TEST_ASSERT_FALSE(word("S11").holds);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_printed_figure_stands_for_its_rounding_interval);
    RUN_TEST(a_figure_above_or_below_all_is_outside);
    RUN_TEST(nothing_simulated_is_not_inside);
    RUN_TEST(the_rate_is_a_share_of_45);
    RUN_TEST(a_paired_difference_is_tested_on_its_side);
    RUN_TEST(a_share_is_tested_against_chance);
    RUN_TEST(rates_of_the_measured_machines);
    return UNITY_END();
}
