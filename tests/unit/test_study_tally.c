#include <math.h>
#include <stdlib.h>

#include "tally.h"
#include "unity.h"

static const study_measure length = {.key = "length", .unit = "m", .kind = STUDY_LENGTH};
static const study_measure count = {.key = "count", .kind = STUDY_COUNT, .count_max = 45};
static const study_measure difference = {.key = "difference", .kind = STUDY_SIGNED};

static uint32_t *bins[2];
static study_tally tally[2];

static void open_two(const study_measure *measure)
{
    for (int i = 0; i < 2; i++) {
        bins[i] = malloc((study_bins_needed(measure) + 1) * sizeof *bins[i]);
        study_tally_init(&tally[i], measure, bins[i]);
    }
}

void setUp(void)
{
    bins[0] = bins[1] = NULL;
}

void tearDown(void)
{
    free(bins[0]);
    free(bins[1]);
}

/* Exponential spacing over many octaves: value i of n is known, so is every quantile. */
static double spread_value(int i, int n)
{
    return 1e-7 * exp(8.0 * i / n);
}

static void quantiles_of_lengths_are_within_a_bin(void)
{
    const int n = 20001;
    open_two(&length);
    for (int i = 0; i < n; i++) {
        study_tally_add(&tally[0], spread_value(i, n));
    }
    for (double p = 0.005; p < 1.0; p += 0.005) {
        const double want = spread_value((int)ceil(p * n) - 1, n);
        /* a bin is at most 1/256 wide; neighbours stand 0.0004 apart */
        TEST_ASSERT_DOUBLE_WITHIN(want / 256.0, want, study_tally_quantile(&tally[0], p));
    }
}

static void values_below_are_the_inverse_of_quantiles(void)
{
    const int n = 20001;
    open_two(&length);
    for (int i = 0; i < n; i++) {
        study_tally_add(&tally[0], spread_value(i, n));
    }
    for (double p = 0.005; p < 1.0; p += 0.005) {
        const double below = study_tally_below(&tally[0], study_tally_quantile(&tally[0], p));
        TEST_ASSERT_DOUBLE_WITHIN(1e-6 * n, p * n, below);
    }
    TEST_ASSERT_EQUAL_DOUBLE(0.0, study_tally_below(&tally[0], 1e-12));
    TEST_ASSERT_EQUAL_DOUBLE(n, study_tally_below(&tally[0], 100.0));
}

static void counts_below_take_whole_bins(void)
{
    open_two(&count);
    for (int i = 0; i <= 40; i++) {
        study_tally_add(&tally[0], i);
    }
    TEST_ASSERT_EQUAL_DOUBLE(37.0, study_tally_below(&tally[0], 36.0));
    TEST_ASSERT_EQUAL_DOUBLE(37.0, study_tally_below(&tally[0], 36.5));
    TEST_ASSERT_EQUAL_DOUBLE(38.0, study_tally_below(&tally[0], 37.5));
    TEST_ASSERT_EQUAL_DOUBLE(0.0, study_tally_below(&tally[0], -0.5));
    TEST_ASSERT_EQUAL_DOUBLE(41.0, study_tally_below(&tally[0], 99.0));
}

static void counts_are_exact(void)
{
    open_two(&count);
    for (int i = 0; i <= 40; i++) {
        study_tally_add(&tally[0], i);
    }
    TEST_ASSERT_EQUAL_DOUBLE(1.0, study_tally_quantile(&tally[0], 0.025));
    TEST_ASSERT_EQUAL_DOUBLE(20.0, study_tally_quantile(&tally[0], 0.5));
    TEST_ASSERT_EQUAL_DOUBLE(39.0, study_tally_quantile(&tally[0], 0.975));
    study_tally_add(&tally[0], 1000.0);
    TEST_ASSERT_EQUAL_UINT32(1, bins[0][45]);
}

static void lengths_outside_the_bins_are_kept(void)
{
    open_two(&length);
    study_tally_add(&tally[0], 0.0);
    study_tally_add(&tally[0], 1e-15);
    study_tally_add(&tally[0], 100.0);
    TEST_ASSERT_EQUAL_UINT64(3, tally[0].moments.n);
    /* the last bin reaches from 4 m to the largest value seen */
    TEST_ASSERT_DOUBLE_WITHIN(0.1, 100.0, study_tally_quantile(&tally[0], 0.9999));
    TEST_ASSERT_TRUE(study_tally_quantile(&tally[0], 0.1) < 1e-10);
}

static void what_is_not_finite_is_counted_apart(void)
{
    open_two(&length);
    study_tally_add(&tally[0], NAN);
    study_tally_add(&tally[0], INFINITY);
    TEST_ASSERT_EQUAL_UINT64(2, tally[0].n_bad);
    TEST_ASSERT_EQUAL_UINT64(0, tally[0].moments.n);
    TEST_ASSERT_DOUBLE_IS_NAN(study_tally_quantile(&tally[0], 0.5));
    TEST_ASSERT_DOUBLE_IS_NAN(study_tally_ci95(&tally[0]));
}

static void signed_values_have_moments_and_no_quantile(void)
{
    open_two(&difference);
    for (int i = -2; i <= 4; i++) {
        study_tally_add(&tally[0], i);
    }
    TEST_ASSERT_EQUAL_UINT64(4, tally[0].n_positive);
    TEST_ASSERT_EQUAL_DOUBLE(-2.0, tally[0].min);
    TEST_ASSERT_DOUBLE_IS_NAN(study_tally_quantile(&tally[0], 0.5));
}

static void merged_parts_hold_what_one_tally_would(void)
{
    const int n = 1000;
    open_two(&length);
    study_tally all;
    uint32_t *all_bins = calloc(study_bins_needed(&length), sizeof *all_bins);
    study_tally_init(&all, &length, all_bins);
    for (int i = 0; i < n; i++) {
        study_tally_add(&all, spread_value(i, n));
        study_tally_add(&tally[i % 3 == 0], spread_value(i, n));
    }
    study_tally_merge(&tally[0], &tally[1]);
    TEST_ASSERT_EQUAL_UINT64(all.moments.n, tally[0].moments.n);
    /* sums of 1000 terms in another order: a few units of 1e-16 relative */
    TEST_ASSERT_DOUBLE_WITHIN(1e-13 * all.moments.mean, all.moments.mean,
                              tally[0].moments.mean);
    TEST_ASSERT_EQUAL_DOUBLE(all.min, tally[0].min);
    TEST_ASSERT_EQUAL_DOUBLE(all.max, tally[0].max);
    TEST_ASSERT_EQUAL_UINT32_ARRAY(all_bins, bins[0], study_bins_needed(&length));
    free(all_bins);
}

static void confidence_interval_of_a_known_sample(void)
{
    open_two(&difference);
    for (int i = 0; i < 100; i++) {
        study_tally_add(&tally[0], i % 2 == 0 ? 1.0 : -1.0);
    }
    /* sd = sqrt(100/99), half = 1.95996 sd / 10 */
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1.959963984540054 * sqrt(100.0 / 99.0) / 10.0,
                              study_tally_ci95(&tally[0]));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(quantiles_of_lengths_are_within_a_bin);
    RUN_TEST(values_below_are_the_inverse_of_quantiles);
    RUN_TEST(counts_below_take_whole_bins);
    RUN_TEST(counts_are_exact);
    RUN_TEST(lengths_outside_the_bins_are_kept);
    RUN_TEST(what_is_not_finite_is_counted_apart);
    RUN_TEST(signed_values_have_moments_and_no_quantile);
    RUN_TEST(merged_parts_hold_what_one_tally_would);
    RUN_TEST(confidence_interval_of_a_known_sample);
    return UNITY_END();
}
