#include <math.h>

#include "path_points.h"
#include "unity.h"

static path_points points;

void setUp(void)
{
    path_points_init(&points, 0);
}

void tearDown(void)
{
    path_points_free(&points);
}

/* Tick k of a path along X, the tip error_mm beside it along Y. */
static void add(int64_t k, double error_mm, bool judged)
{
    exk_wire_pose pose = {.sample = {.k = k, .time_us = 1000 * k, .judged = judged}};
    exk_sample *s = &pose.sample;
    s->has_true = true;
    s->hole_id = 7;
    s->ref = (exk_tool){.tip_m = {1e-3 * (double)k, 0.0, 0.95}, .axis = {0.0, 0.0, 1.0}};
    s->real = s->ref;
    s->real.tip_m[1] += 1e-3 * error_mm;
    path_points_add(&points, &pose);
}

static void expect_radial(const path_point *p, double least, double mean, double most)
{
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, least, p->radial_mm[0]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, mean, p->radial_mm[1]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, most, p->radial_mm[2]);
}

static void test_a_short_path_is_kept_whole(void)
{
    path_points_init(&points, 5);
    for (int k = 0; k < 5; k++) {
        add(k, 0.01 * k, k == 3);
    }
    path_points_end(&points);
    TEST_ASSERT_EQUAL_size_t(5, points.path.n);
    TEST_ASSERT_EQUAL_size_t(1, points.judged.n);
    TEST_ASSERT_EQUAL_INT32(7, points.judged.at[0].hole_id);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.003, points.judged.at[0].time_s);
    expect_radial(&points.path.at[4], 0.04, 0.04, 0.04);
}

static void test_a_stretch_keeps_least_mean_and_most(void)
{
    path_points_init(&points, 2 * PATH_POINTS_MAX);
    TEST_ASSERT_EQUAL_INT64(3, points.stretch);
    const double error_mm[] = {0.02, 0.08, 0.05, 0.01, 0.01, 0.01, 0.03, 0.04};
    for (int k = 0; k < 8; k++) {
        add(k, error_mm[k], false);
    }
    path_points_end(&points);
    TEST_ASSERT_EQUAL_size_t(4, points.path.n); /* three stretches and the last sample */
    expect_radial(&points.path.at[0], 0.02, 0.05, 0.08);
    expect_radial(&points.path.at[1], 0.01, 0.01, 0.01);
    expect_radial(&points.path.at[3], 0.04, 0.04, 0.04);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 3.0, points.path.at[1].ref_mm[0]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.02, points.path.at[0].off_mm[1]); /* its first sample */
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.08, points.worst_mm);
}

/* Many holes on a long path, as in a rib: none is lost, and the path goes on to its end. */
static void test_every_judged_sample_stays_and_so_does_the_end(void)
{
    const int n = 200000;
    path_points_init(&points, n);
    for (int k = 0; k < n; k++) {
        add(k, 0.01, k % 100 == 99);
    }
    path_points_end(&points);
    TEST_ASSERT_EQUAL_size_t(2000, points.judged.n);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1e-3 * (n - 1), points.judged.at[1999].time_s);
    TEST_ASSERT_TRUE(points.path.n <= PATH_POINTS_MAX + 1);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1e-3 * (n - 1), points.path.at[points.path.n - 1].time_s);
    for (size_t i = 1; i + 1 < points.path.n; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1e-3 * (double)points.stretch,
                                  points.path.at[i].time_s - points.path.at[i - 1].time_s);
    }
}

/* One spike of one sample in a million, and two judged samples that are not the worst near them. */
static void test_the_worst_sample_survives_thinning(void)
{
    enum { N = 1000000, SPIKE = 654321 };
    double most_mm = 0.0;
    path_points_init(&points, N);
    for (int64_t k = 0; k < N; k++) {
        const bool judged = k == 1000 || k == 900001;
        add(k, k == SPIKE ? 5.0 : judged ? 0.0 : 1e-3, judged);
    }
    path_points_end(&points);
    for (size_t i = 0; i < points.path.n; i++) {
        most_mm = fmax(most_mm, points.path.at[i].radial_mm[2]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 5.0, most_mm);
    TEST_ASSERT_EQUAL_size_t(2, points.judged.n);
}

static void test_what_is_no_number_is_left_out(void)
{
    path_points_init(&points, 3);
    add(0, 0.01, false);
    add(1, NAN, true);
    add(2, INFINITY, false);
    path_points_end(&points);
    TEST_ASSERT_EQUAL_size_t(1, points.path.n);
    TEST_ASSERT_EQUAL_size_t(0, points.judged.n);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.01, points.worst_mm);
}

static void test_nothing_added_is_nothing_drawn(void)
{
    path_points_end(&points);
    TEST_ASSERT_EQUAL_size_t(0, points.path.n);
    TEST_ASSERT_FALSE(points.failed);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_short_path_is_kept_whole);
    RUN_TEST(test_a_stretch_keeps_least_mean_and_most);
    RUN_TEST(test_every_judged_sample_stays_and_so_does_the_end);
    RUN_TEST(test_the_worst_sample_survives_thinning);
    RUN_TEST(test_what_is_no_number_is_left_out);
    RUN_TEST(test_nothing_added_is_nothing_drawn);
    return UNITY_END();
}
