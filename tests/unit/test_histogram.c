#include "exk/realtime.h"
#include "unity.h"

static exk_histogram hist;

void setUp(void)
{
    hist = (exk_histogram){.n = 0};
}

void tearDown(void)
{
}

static void an_empty_one_says_zero(void)
{
    TEST_ASSERT_EQUAL_INT64(0, exk_histogram_quantile_ns(&hist, 0.5));
}

/* A bin is at most a quarter of its value wide, so a quantile is at most 25 % high. */
static void quantiles_are_at_most_a_quarter_high(void)
{
    for (int64_t i = 1; i <= 100000; i++) {
        exk_histogram_add(&hist, 100 * i);
    }
    static const double p[] = {0.001, 0.01, 0.1, 0.5, 0.9, 0.99, 0.999};
    for (size_t i = 0; i < sizeof p / sizeof p[0]; i++) {
        const double exact = p[i] * 1e7;
        const double found = (double)exk_histogram_quantile_ns(&hist, p[i]);
        TEST_ASSERT_TRUE(found >= exact && found <= 1.25 * exact);
    }
    TEST_ASSERT_EQUAL_INT64(10000000, exk_histogram_quantile_ns(&hist, 1.0));
}

static void small_and_huge_values_have_a_bin(void)
{
    static const struct {
        const char *name;
        int64_t value_ns;
    } rows[] = {{"zero", 0},
                {"early", -5},
                {"63 ns", 63},
                {"64 ns", 64},
                {"an hour", 3600000000000},
                {"the largest", INT64_MAX}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        setUp();
        exk_histogram_add(&hist, rows[i].value_ns);
        TEST_ASSERT_EQUAL_UINT64_MESSAGE(1, hist.n, rows[i].name);
        uint64_t sum = 0;
        for (int b = 0; b < EXK_HIST_BINS; b++) {
            sum += hist.bin[b];
        }
        TEST_ASSERT_EQUAL_UINT64_MESSAGE(1, sum, rows[i].name);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(an_empty_one_says_zero);
    RUN_TEST(quantiles_are_at_most_a_quarter_high);
    RUN_TEST(small_and_huge_values_have_a_bin);
    return UNITY_END();
}
