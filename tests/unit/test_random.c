#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "exk/quantile.h"
#include "exk/random.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* Known answers of philox4x32-10 published with Random123 (tests/kat_vectors), each counter and key
 * laid out as a stream: counter = {k, run, series, k high | source | channel}, key = seed. */
static const struct {
    const char *name;
    exk_stream stream;
    int64_t k;
    uint32_t want[4];
} known[] = {
    {"all zero", {0, 0, 0, 0, 0}, 0, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
    {"all ones",
     {UINT64_MAX, UINT32_MAX, UINT32_MAX, UINT8_MAX, UINT8_MAX},
     -1,
     {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
    {"digits of pi",
     {0x299f31d0a4093822, 0x13198a2e, 0x85a308d3, 0x73, 0x44},
     0x0370243f6a88,
     {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
};

static void philox_gives_its_published_answers(void)
{
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        uint32_t word[4];
        exk_random_block(&known[i].stream, known[i].k, word);
        TEST_ASSERT_EQUAL_HEX32_ARRAY_MESSAGE(known[i].want, word, 4, known[i].name);
    }
}

/* u = (2 j + 1) 2^-53, j the upper 52 bits of two words, written out here in integers. */
static double uniform_of(uint32_t low, uint32_t high)
{
    const uint64_t j = ((uint64_t)high << 32 | low) >> 12;
    return ldexp((double)(2 * j + 1), -53);
}

static void a_normal_is_the_quantile_of_its_words(void)
{
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const uint32_t *w = known[i].want;
        double z[2];
        exk_normal_pair(&known[i].stream, known[i].k, z);
        const double first = exk_normal_quantile(uniform_of(w[0], w[1]));
        const double second = exk_normal_quantile(uniform_of(w[2], w[3]));
        TEST_ASSERT_TRUE(z[0] == first && z[1] == second);
        TEST_ASSERT_TRUE(z[0] == exk_normal(&known[i].stream, known[i].k));
    }
}

/* Each part of a name changes the draw, and only the named streams are alike. */
static void every_part_of_the_name_counts(void)
{
    static const struct {
        const char *name;
        exk_stream stream;
        int64_t k;
    } rows[] = {
        {"itself", {1, 2, 3, 4, 0}, 5},
        {"seed, low word", {2, 2, 3, 4, 0}, 5},
        {"seed, high word", {1 + (UINT64_C(1) << 32), 2, 3, 4, 0}, 5},
        {"series", {1, 3, 3, 4, 0}, 5},
        {"run", {1, 2, 0, 4, 0}, 5},
        {"source", {1, 2, 3, EXK_SOURCE_SENSOR, 0}, 5},
        {"channel", {1, 2, 3, 4, 1}, 5},
        {"k, low word", {1, 2, 3, 4, 0}, 6},
        {"k, bit 32", {1, 2, 3, 4, 0}, 5 + (INT64_C(1) << 32)},
        {"k, bit 47", {1, 2, 3, 4, 0}, 5 + (INT64_C(1) << 47)},
        {"k and series swapped", {1, 5, 3, 4, 0}, 2},
        {"series and run swapped", {1, 3, 2, 4, 0}, 5},
        {"source in the place of k's high bits", {1, 2, 3, 0, 0}, 5 + (INT64_C(4) << 32)},
    };
    const size_t n = sizeof rows / sizeof *rows;
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < n; j++) {
            const bool alike = exk_normal(&rows[i].stream, rows[i].k) ==
                               exk_normal(&rows[j].stream, rows[j].k);
            TEST_ASSERT_EQUAL_MESSAGE(i == j, alike, rows[j].name);
        }
    }
}

/* References: root of erfc(-z / sqrt 2) / 2 = p in 60 digits (mpmath), p the double as it is. The
 * first five rows stand at the seam of centre and middle, exp(-25) at that of middle and tail. */
static const struct {
    double p, want;
} quantiles[] = {
    {0.5, 0.0},
    {0.075, -1.4395314709384559349},
    {0.07499999999999998, -1.439531470938456033},
    {0.925, 1.4395314709384562291},
    {0.9250000000000002, 1.4395314709384570134},
    {0.1, -1.2815515655446004353},
    {0.25, -0.6744897501960817432},
    {0.3, -0.52440051270804081597},
    {0.49, -0.025068908258711058033},
    {0.6, 0.25334710313579974132},
    {0.75, 0.6744897501960817432},
    {0.9, 1.2815515655446005935},
    {0.975, 1.9599639845400538556},
    {0.99, 2.3263478740408407676},
    {0.01, -2.3263478740408410931},
    {0.001, -3.0902323061678135354},
    {1e-05, -4.2648907939228246102},
    {1e-08, -5.6120012441747887279},
    {1.3887943864964021e-11, -6.6579046435011035837},
    {1.3874055921099056e-11, -6.658051731427321521},
    {1e-12, -7.0344838253011319326},
    {1e-16, -8.2220822161304356152},
    {0x1p-53, -8.2095361516013868556},
    {1.0 - 0x1p-53, 8.2095361516013868556},
    {1e-100, -21.273453560965324294},
    {1e-300, -37.047096299361199237},
    {0x1p-1074, -38.467405617144346251},
    {1.0 - 1e-10, 6.3613408896974218642},
};

/* The formula is good to 1e-16 relative; with the roundings of its evaluation the worst of 6000
 * points was 5.6e-16. */
static void the_quantile_matches_sixty_digit_references(void)
{
    for (size_t i = 0; i < sizeof quantiles / sizeof *quantiles; i++) {
        char row[64];
        (void)snprintf(row, sizeof row, "p = %.17g", quantiles[i].p);
        const double z = exk_normal_quantile(quantiles[i].p);
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-15 * fabs(quantiles[i].want), quantiles[i].want, z,
                                          row);
    }
}

/* Independent of any table: the distribution function of the C library gives p back. An error of
 * z by r z changes p by about r z^2 p; 1e-15 for the quantile and for erfc each. */
static void the_distribution_function_gives_p_back(void)
{
    for (double p = 0.5; p > 1e-300; p *= 0.9965) {
        const double z = exk_normal_quantile(p);
        const double back = 0.5 * erfc(-z * sqrt(0.5));
        TEST_ASSERT_DOUBLE_WITHIN((1e-15 + 1e-15 * z * z) * p, p, back);
    }
}

static void the_quantile_rises_and_is_odd(void)
{
    double before = -INFINITY;
    for (int i = 1; i < 4096; i++) {
        const double p = i / 4096.0;
        const double z = exk_normal_quantile(p);
        TEST_ASSERT_TRUE(z > before);
        TEST_ASSERT_TRUE(z == -exk_normal_quantile(1.0 - p));
        before = z;
    }
}

static void outside_the_open_interval_is_nan(void)
{
    static const double outside[] = {0.0, 1.0, -0.0, -1e-300, 1.5, -INFINITY, INFINITY, NAN};
    for (size_t i = 0; i < sizeof outside / sizeof *outside; i++) {
        TEST_ASSERT_TRUE(isnan(exk_normal_quantile(outside[i])));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(philox_gives_its_published_answers);
    RUN_TEST(a_normal_is_the_quantile_of_its_words);
    RUN_TEST(every_part_of_the_name_counts);
    RUN_TEST(the_quantile_matches_sixty_digit_references);
    RUN_TEST(the_distribution_function_gives_p_back);
    RUN_TEST(the_quantile_rises_and_is_odd);
    RUN_TEST(outside_the_open_interval_is_nan);
    return UNITY_END();
}
