#include <math.h>
#include <string.h>

#include "exk/quantile.h"
#include "exk/stats.h"
#include "unity.h"

/* Half a unit of the last printed digit of the figure compared with. */
#define PRINTED(unit) (0.5 * (unit))

void setUp(void)
{
}

void tearDown(void)
{
}

static void moments_of_a_known_list(void)
{
    static const double x[] = {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0};
    exk_moments m;
    exk_moments_reset(&m);
    for (size_t i = 0; i < 8; i++) {
        exk_moments_add(&m, x[i]);
    }
    TEST_ASSERT_EQUAL_UINT64(8, m.n);
    TEST_ASSERT_DOUBLE_WITHIN(1e-14, 5.0, m.mean);
    TEST_ASSERT_DOUBLE_WITHIN(1e-14, 32.0 / 7.0, exk_moments_variance(&m));
    TEST_ASSERT_DOUBLE_WITHIN(1e-14, sqrt(32.0 / 7.0), exk_moments_std(&m));
}

static void moments_keep_digits_beside_a_large_offset(void)
{
    exk_moments m = {0};
    for (int i = 0; i < 1000; i++) {
        exk_moments_add(&m, 1e9 + (i % 2 == 0 ? -1.0 : 1.0));
    }
    /* one rounding of 1e9 is 1.2e-7; a naive sum of squares would be off by about 100 */
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1000.0 / 999.0, exk_moments_variance(&m));
}

static void merged_halves_equal_one_stream(void)
{
    for (int cut = 0; cut <= 20; cut++) {
        exk_moments all = {0};
        exk_moments a = {0};
        exk_moments b = {0};
        for (int i = 0; i < 20; i++) {
            const double x = sin(3.0 * i) * i;
            exk_moments_add(&all, x);
            exk_moments_add(i < cut ? &a : &b, x);
        }
        exk_moments_merge(&a, &b);
        TEST_ASSERT_EQUAL_UINT64(all.n, a.n);
        TEST_ASSERT_DOUBLE_WITHIN(1e-13, all.mean, a.mean);
        TEST_ASSERT_DOUBLE_WITHIN(1e-10, all.m2, a.m2);
    }
}

static void too_few_values_have_no_variance(void)
{
    exk_moments m = {0};
    TEST_ASSERT_DOUBLE_IS_NAN(exk_moments_variance(&m));
    exk_moments_add(&m, 1.0);
    TEST_ASSERT_DOUBLE_IS_NAN(exk_moments_std(&m));
    exk_moments_add(&m, NAN);
    TEST_ASSERT_DOUBLE_IS_NAN(m.mean);
}

/* Quantiles from the tables printed in any textbook, ten digits. */
static void normal_quantiles(void)
{
    static const struct {
        double p;
        double z;
    } rows[] = {{0.5, 0.0},           {0.975, 1.9599639845}, {0.95, 1.6448536270},
                {0.8, 0.8416212336},  {0.9, 1.2815515655},   {0.99865, 2.9999769927},
                {1e-9, -5.9978070150}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(PRINTED(1e-10) * 2.0, rows[i].z,
                                  exk_normal_quantile(rows[i].p));
    }
    for (double p = 1e-300; p < 0.5; p *= 7.0) {
        const double back = 0.5 * erfc(-exk_normal_quantile(p) / sqrt(2.0));
        TEST_ASSERT_DOUBLE_WITHIN(1e-11 * p, p, back); /* z^2 ~ 1400 amplifies one rounding */
    }
    TEST_ASSERT_DOUBLE_IS_NAN(exk_normal_quantile(0.0));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_normal_quantile(1.0));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_normal_quantile(NAN));
}

/* The published machines, 45 holes each: per cent with one decimal. */
static void wilson_intervals_of_the_three_machines(void)
{
    static const struct {
        const char *name;
        uint64_t k;
        uint64_t n;
        double low;
        double high;
    } rows[] = {
        {"Mazak, 45 of 45", 45, 45, 92.1, 100.0},
        {"Exechon model, 37 of 45", 37, 45, 68.7, 90.7},
        {"Loxin, 36 of 45", 36, 45, 66.2, 89.1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const exk_interval got = exk_wilson(rows[i].k, rows[i].n, 0.95);
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(PRINTED(0.1), rows[i].low, 100.0 * got.low,
                                          rows[i].name);
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(PRINTED(0.1), rows[i].high, 100.0 * got.high,
                                          rows[i].name);
    }
}

static void wilson_ends_are_exact_and_mirrored(void)
{
    TEST_ASSERT_TRUE(exk_wilson(0, 7, 0.95).low == 0.0);
    TEST_ASSERT_TRUE(exk_wilson(7, 7, 0.95).high == 1.0);
    for (uint64_t k = 0; k <= 30; k++) {
        const exk_interval a = exk_wilson(k, 30, 0.9);
        const exk_interval b = exk_wilson(30 - k, 30, 0.9);
        TEST_ASSERT_DOUBLE_WITHIN(1e-14, a.low, 1.0 - b.high);
        TEST_ASSERT_TRUE(a.low >= 0.0 && a.low < a.high && a.high <= 1.0);
    }
    TEST_ASSERT_DOUBLE_IS_NAN(exk_wilson(0, 0, 0.95).low);
    TEST_ASSERT_DOUBLE_IS_NAN(exk_wilson(8, 7, 0.95).high);
    TEST_ASSERT_DOUBLE_IS_NAN(exk_wilson(3, 7, NAN).low);
}

static void sample_sizes(void)
{
    TEST_ASSERT_EQUAL_UINT64(29956, exk_no_miss_size(0.9999, 0.95));
    /* 99.73 %: 1108.03 holes before rounding, so 1108 falls short of 95 % by a hair. */
    TEST_ASSERT_EQUAL_UINT64(1109, exk_no_miss_size(0.9973, 0.95));
    TEST_ASSERT_TRUE(pow(0.9973, 1108.0) > 0.05);
    TEST_ASSERT_TRUE(pow(0.9973, 1109.0) < 0.05);
    /* "about 4,900 each" to tell 82.2 % from 80.0 %, power 80 % */
    TEST_ASSERT_DOUBLE_WITHIN(
        PRINTED(100.0), 4900.0,
        (double)exk_two_proportions_size(37.0 / 45.0, 36.0 / 45.0, 0.95, 0.8));
    TEST_ASSERT_DOUBLE_WITHIN(PRINTED(0.1), 93.6, 100.0 * exk_no_miss_bound(45, 0.95));
}

static void sizes_of_senseless_questions_are_zero(void)
{
    TEST_ASSERT_EQUAL_UINT64(0, exk_no_miss_size(1.0, 0.95));
    TEST_ASSERT_EQUAL_UINT64(0, exk_no_miss_size(NAN, 0.95));
    TEST_ASSERT_EQUAL_UINT64(0, exk_no_miss_size(0.9, 0.0));
    TEST_ASSERT_EQUAL_UINT64(0, exk_two_proportions_size(0.8, 0.8, 0.95, 0.8));
    TEST_ASSERT_EQUAL_UINT64(0, exk_two_proportions_size(0.8, NAN, 0.95, 0.8));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_no_miss_bound(0, 0.95));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_no_miss_bound(5, 1.0));
}

/* The table of section 2: sigma in mm with five decimals from the mean, per cent inside. */
static void rayleigh_of_the_three_machines(void)
{
    static const struct {
        const char *name;
        double sigma_mm;
        double inside_percent;
    } rows[] = {{"Mazak", 0.00911, 99.6}, {"Loxin", 0.01952, 69.3}, {"Exechon", 0.01884, 71.9}};
    size_t n = 0;
    const exk_reference *refs = exk_references(&n);
    TEST_ASSERT_EQUAL_size_t(3, n);
    for (size_t i = 0; i < n; i++) {
        const double sigma_m = exk_rayleigh_sigma_of_mean(refs[i].mean_m);
        TEST_ASSERT_EQUAL_STRING(rows[i].name, refs[i].name);
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(PRINTED(1e-5), rows[i].sigma_mm, 1e3 * sigma_m,
                                          rows[i].name);
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(PRINTED(0.1), rows[i].inside_percent,
                                          100.0 * exk_rayleigh_inside(0.03e-3, sigma_m),
                                          rows[i].name);
    }
}

/* Ppk 1.00 needs sigma 8.25 um (mean 10.3), 1.33 needs 6.75 (8.5), 1.67 needs 5.68 (7.1). */
static void capability_of_a_radial_error(void)
{
    static const struct {
        double ppk;
        double sigma_um;
        double mean_um;
    } rows[] = {{1.00, 8.25, 10.3}, {1.33, 6.75, 8.5}, {1.67, 5.68, 7.1}};
    for (size_t i = 0; i < 3; i++) {
        const double sigma_um = exk_rayleigh_sigma_for(30.0, rows[i].ppk);
        TEST_ASSERT_DOUBLE_WITHIN(PRINTED(0.01), rows[i].sigma_um, sigma_um);
        TEST_ASSERT_DOUBLE_WITHIN(PRINTED(0.1), rows[i].mean_um,
                                  sigma_um * sqrt(acos(-1.0) / 2.0));
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, rows[i].ppk, exk_rayleigh_ppk(30.0, sigma_um));
    }
    TEST_ASSERT_TRUE(exk_rayleigh_ppk(30.0, 9.11) < 1.0); /* even Mazak */
    TEST_ASSERT_TRUE(isinf(exk_rayleigh_ppk(30.0, 0.0)));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rayleigh_ppk(30.0, NAN));
}

static void rayleigh_quantile_inverts_the_distribution(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(PRINTED(1e-4), 1.1774, exk_rayleigh_quantile(0.5, 1.0));
    for (double p = 0.0; p < 1.0; p += 0.01) {
        const double r = exk_rayleigh_quantile(p, 0.7);
        TEST_ASSERT_DOUBLE_WITHIN(1e-14, p, exk_rayleigh_inside(r, 0.7));
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 1.0, exk_rayleigh_inside(0.0, 0.0));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rayleigh_inside(NAN, 1.0));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rayleigh_inside(1.0, -1.0));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rayleigh_quantile(1.0, 1.0));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rayleigh_quantile(0.5, NAN));
}

static void rayleigh_fit_of_exact_quantiles(void)
{
    enum { N = 2000 };
    double r[N];
    for (int i = 0; i < N; i++) {
        r[i] = exk_rayleigh_quantile((i + 0.5) / N, 0.01);
    }
    /* midpoint sum of -2 ln(1-p): short of its integral by about ln(2)/N in the square */
    TEST_ASSERT_DOUBLE_WITHIN(0.01 * 0.7 / N, 0.01, exk_rayleigh_fit(r, N));
    r[7] = NAN;
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rayleigh_fit(r, N));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rayleigh_fit(r, 0));
}

static void pose_accuracy_of_a_cross(void)
{
    static const double dx[] = {4.0, 2.0, 3.0, 3.0};
    static const double dy[] = {4.0, 4.0, 5.0, 3.0};
    const exk_pose_figures f = exk_pose_accuracy(dx, dy, 4);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 3.0, f.mean_dx);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 4.0, f.mean_dy);
    TEST_ASSERT_DOUBLE_WITHIN(1e-14, 5.0, f.ap);
    TEST_ASSERT_DOUBLE_WITHIN(1e-14, 1.0, f.rp); /* all at distance 1: no deviation */
    const exk_pose_figures line =
        exk_pose_accuracy((double[]){0.0, 0.0, 3.0}, (double[]){0.0, 0.0, 0.0}, 3);
    /* distances 1, 1, 2 from the mean point: mean 4/3, deviation sqrt(1/3) */
    TEST_ASSERT_DOUBLE_WITHIN(1e-14, 4.0 / 3.0 + sqrt(3.0), line.rp);
    TEST_ASSERT_DOUBLE_IS_NAN(exk_pose_accuracy(dx, dy, 1).rp);
    TEST_ASSERT_DOUBLE_IS_NAN(exk_pose_accuracy(dx, dy, 0).ap);
}

static void published_figures_are_those_of_the_study(void)
{
    size_t n = 0;
    const exk_reference *refs = exk_references(&n);
    static const double mean_mm[] = {0.011417, 0.024466, 0.023614};
    static const double percent[] = {100.0, 80.0, 82.2};
    for (size_t i = 0; i < n; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, mean_mm[i], 1e3 * refs[i].mean_m);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, percent[i], 100.0 * refs[i].correct_rate);
        TEST_ASSERT_TRUE(strlen(refs[i].source) > 0);
    }
    TEST_ASSERT_DOUBLE_WITHIN(PRINTED(0.001), refs[2].correct_rate,
                              (double)refs[2].n_inside / (double)refs[2].n_holes);
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 0.06, exk_true_position(0.03));
}

static void rician_of_no_offset_is_rayleigh(void)
{
    const exk_rician r = {0.0, 0.0188};
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.0188 * sqrt(acos(-1.0) / 2.0), exk_rician_mean(r));
    TEST_ASSERT_DOUBLE_WITHIN(1e-10, exk_rayleigh_inside(0.03, r.sigma),
                              exk_rician_inside(0.03, r));
}

static void rician_of_much_offset_is_normal(void)
{
    /* far from the centre the radial error is the part along the offset: mean v + s^2/2v */
    const exk_rician r = {20.0, 1.0};
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, 20.025, exk_rician_mean(r));
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, 0.5 * erfc(0.025 / sqrt(2.0)), exk_rician_inside(20.0, r));
}

static void rician_fit_returns_what_made_the_moments(void)
{
    static const exk_rician rows[] = {{0.0, 2.0}, {1.0, 2.0}, {5.0, 0.5}};
    for (size_t i = 0; i < 3; i++) {
        const double v2 = rows[i].offset * rows[i].offset, s2 = rows[i].sigma * rows[i].sigma;
        const exk_rician fit = exk_rician_fit(v2 + 2.0 * s2, 4.0 * s2 * (s2 + v2));
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, rows[i].offset, fit.offset);
        TEST_ASSERT_DOUBLE_WITHIN(1e-6, rows[i].sigma, fit.sigma);
    }
    /* more scatter than Rayleigh's: no offset explains it */
    TEST_ASSERT_EQUAL_DOUBLE(0.0, exk_rician_fit(1.0, 2.0).offset);
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rician_fit(0.0, 1.0).sigma);
}

static void rician_of_the_published_figures(void)
{
    /* control limits, section 2: offset 22.5 um, sigma 7.0 um give mean 0.0236 and 82.6 % */
    const exk_rician r = exk_rician_of_mean_and_inside(0.023614, 0.03, 0.826);
    TEST_ASSERT_DOUBLE_WITHIN(PRINTED(0.0002), 0.0225, r.offset);
    TEST_ASSERT_DOUBLE_WITHIN(PRINTED(0.0002), 0.0070, r.sigma);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.023614, exk_rician_mean(r));
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.826, exk_rician_inside(0.03, r));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rician_of_mean_and_inside(0.023614, 0.03, 0.5).sigma);
}

static void senseless_figures_give_no_number(void)
{
    static const exk_rician bad[] = {
        {-1.0, 1.0}, {1.0, 0.0}, {(double)NAN, 1.0}, {1.0, (double)NAN}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        TEST_ASSERT_DOUBLE_IS_NAN(exk_rician_mean(bad[i]));
        TEST_ASSERT_DOUBLE_IS_NAN(exk_rician_inside(1.0, bad[i]));
    }
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rician_mean((exk_rician){30.1, 1.0})); /* beyond 30 sigma */
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rician_inside(-1.0, (exk_rician){1.0, 1.0}));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rician_fit(1.0, -1.0).sigma);
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rician_fit(1.0, (double)NAN).sigma);
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rician_of_mean_and_inside(0.0, 1.0, 0.9).sigma);
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rician_of_mean_and_inside(1.0, 1.0, 0.9).sigma);
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rician_of_mean_and_inside(1.0, 2.0, 0.1).sigma);
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rician_of_mean_and_inside(1.0, 1.01, 0.999).sigma);
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rayleigh_quantile(-0.1, 1.0));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rayleigh_quantile(1.0, 1.0));
    TEST_ASSERT_DOUBLE_IS_NAN(exk_rayleigh_quantile(0.5, -1.0));
    for (int i = 0; i < 4; i++) {
        double p[4] = {0.1, 0.2, 0.95, 0.8};
        p[i] = 1.0;
        TEST_ASSERT_EQUAL_UINT64(0, exk_two_proportions_size(p[0], p[1], p[2], p[3]));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(moments_of_a_known_list);
    RUN_TEST(moments_keep_digits_beside_a_large_offset);
    RUN_TEST(merged_halves_equal_one_stream);
    RUN_TEST(too_few_values_have_no_variance);
    RUN_TEST(normal_quantiles);
    RUN_TEST(wilson_intervals_of_the_three_machines);
    RUN_TEST(wilson_ends_are_exact_and_mirrored);
    RUN_TEST(sample_sizes);
    RUN_TEST(sizes_of_senseless_questions_are_zero);
    RUN_TEST(rayleigh_of_the_three_machines);
    RUN_TEST(capability_of_a_radial_error);
    RUN_TEST(rayleigh_quantile_inverts_the_distribution);
    RUN_TEST(rayleigh_fit_of_exact_quantiles);
    RUN_TEST(pose_accuracy_of_a_cross);
    RUN_TEST(published_figures_are_those_of_the_study);
    RUN_TEST(rician_of_no_offset_is_rayleigh);
    RUN_TEST(rician_of_much_offset_is_normal);
    RUN_TEST(rician_fit_returns_what_made_the_moments);
    RUN_TEST(rician_of_the_published_figures);
    RUN_TEST(senseless_figures_give_no_number);
    return UNITY_END();
}
