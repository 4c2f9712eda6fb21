#include <math.h>

#include "path_points.h"
#include "unity.h"

static path_points path;

void setUp(void)
{
}

void tearDown(void)
{
    path_points_free(&path);
}

/* The sample of tick k, off its reference by error_m along X. */
static exk_wire_pose pose(int64_t k, double error_m, bool judged)
{
    exk_wire_pose p = {.seq = k};
    p.sample.k = k;
    p.sample.time_us = 1000 * k;
    p.sample.judged = judged;
    p.sample.has_true = true;
    p.sample.ref.axis[EXK_Z] = 1.0;
    p.sample.real = p.sample.ref;
    p.sample.real.tip_m[EXK_X] = error_m;
    return p;
}

static void add(int64_t k, double error_m, bool judged)
{
    const exk_wire_pose p = pose(k, error_m, judged);
    path_points_add(&path, &p);
}

static void a_short_run_is_kept_whole(void)
{
    TEST_ASSERT_TRUE(path_points_init(&path, 100, 2));
    for (int64_t k = 0; k < 100; k++) {
        add(k, 1e-6 * (double)k, k == 50);
    }
    TEST_ASSERT_EQUAL(100, path.n_points);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.099, path.worst_mm);
    TEST_ASSERT_TRUE(path.points[50].judged);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.05, path.points[50].time_s);
}

/* One spike of one sample in a million, and two judged samples that are not the worst near them. */
static void the_worst_and_the_judged_samples_survive_thinning(void)
{
    enum { N = 1000000, SPIKE = 654321 };
    double worst_mm = 0.0;
    int n_judged = 0;
    TEST_ASSERT_TRUE(path_points_init(&path, N, 2));
    for (int64_t k = 0; k < N; k++) {
        const bool judged = k == 1000 || k == 900001;
        add(k, k == SPIKE ? 5e-3 : judged ? 0.0 : 1e-6, judged);
    }
    TEST_ASSERT_LESS_OR_EQUAL(PATH_POINTS_MAX + 4, path.n_points);
    TEST_ASSERT_GREATER_THAN(PATH_POINTS_MAX / 2, path.n_points);
    for (size_t i = 0; i < path.n_points; i++) {
        worst_mm = fmax(worst_mm, path.points[i].radial_mm);
        n_judged += path.points[i].judged;
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 5.0, worst_mm);
    TEST_ASSERT_EQUAL(2, n_judged);
}

static void samples_that_are_not_numbers_are_left_out(void)
{
    TEST_ASSERT_TRUE(path_points_init(&path, 10, 0));
    add(0, NAN, false);
    add(1, INFINITY, false);
    add(2, 1e-6, false);
    TEST_ASSERT_EQUAL(1, path.n_points);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1e-3, path.worst_mm);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_short_run_is_kept_whole);
    RUN_TEST(the_worst_and_the_judged_samples_survive_thinning);
    RUN_TEST(samples_that_are_not_numbers_are_left_out);
    return UNITY_END();
}
