#include <math.h>

#include "exk/axes.h"
#include "exk/job.h"
#include "unity.h"

enum { CAPACITY = 64 };

static exk_hole holes[CAPACITY];
static size_t n_holes;

void setUp(void)
{
    n_holes = 0;
}

void tearDown(void)
{
}

static void expect_hole(size_t i, int32_t id, double x_m, double y_m)
{
    TEST_ASSERT_EQUAL_INT32(id, holes[i].id);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, x_m, holes[i].target_m[EXK_X]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, y_m, holes[i].target_m[EXK_Y]);
}

static void a_rectangle_goes_round_from_its_lower_left_corner(void)
{
    const exk_pattern pattern = {0.3, 0.2, {0.1, 0.0, 0.95}, 1, 1};
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_rectangle(&pattern, holes, 4, &n_holes));
    TEST_ASSERT_EQUAL_UINT(4, n_holes);
    expect_hole(0, 1, -0.05, -0.1);
    expect_hole(1, 2, 0.25, -0.1);
    expect_hole(2, 3, 0.25, 0.1);
    expect_hole(3, 4, -0.05, 0.1);
    TEST_ASSERT_TRUE(holes[3].target_m[EXK_Z] == 0.95);
    TEST_ASSERT_TRUE(holes[3].axis[EXK_Z] == 1.0);
}

static void a_grid_turns_back_in_every_second_row(void)
{
    const exk_pattern pattern = {0.2, 0.1, {0.0, 0.0, 1.0}, 3, 3};
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_grid(&pattern, holes, CAPACITY, &n_holes));
    TEST_ASSERT_EQUAL_UINT(9, n_holes);
    expect_hole(0, 1, -0.1, -0.05);
    expect_hole(2, 3, 0.1, -0.05);
    expect_hole(3, 4, 0.1, 0.0);
    expect_hole(5, 6, -0.1, 0.0);
    expect_hole(6, 7, -0.1, 0.05);
    expect_hole(8, 9, 0.1, 0.05);
}

static void a_single_row_stands_at_the_centre(void)
{
    const exk_pattern pattern = {0.2, 0.1, {0.0, 0.3, 1.0}, 1, 2};
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_grid(&pattern, holes, CAPACITY, &n_holes));
    expect_hole(0, 1, -0.1, 0.3);
    expect_hole(1, 2, 0.1, 0.3);
}

/* Rows one mm apart in y, with 0.1 mm of scatter in each. */
static void serpentine_sorts_rows_and_keeps_ids(void)
{
    const double xy_mm[][2] = {{30, 1.05}, {10, 0.0},  {20, 2.0}, {30, 0.1},  {10, 0.95},
                               {20, 0.05}, {10, 2.05}, {20, 1.0}, {30, 1.95}, {0, 1.0}};
    const int32_t want[] = {1, 5, 3, 0, 7, 4, 9, 6, 2, 8};
    const size_t n = sizeof(want) / sizeof(want[0]);
    for (size_t i = 0; i < n; i++) {
        holes[i] =
            (exk_hole){(int32_t)i, {xy_mm[i][0] * 1e-3, xy_mm[i][1] * 1e-3, 1.0}, {0, 0, 1}};
    }
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_serpentine(holes, n, 0.0005));
    for (size_t i = 0; i < n; i++) {
        TEST_ASSERT_EQUAL_INT32(want[i], holes[i].id);
    }
}

static void serpentine_of_a_grid_changes_nothing(void)
{
    const exk_pattern pattern = {0.28, 0.2, {0.0, 0.0, 1.0}, 7, 9};
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_grid(&pattern, holes, CAPACITY, &n_holes));
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_serpentine(holes, n_holes, 0.001));
    for (size_t i = 0; i < n_holes; i++) {
        TEST_ASSERT_EQUAL_INT32((int32_t)i + 1, holes[i].id);
    }
}

static void holes_at_one_place_go_by_id(void)
{
    for (int i = 0; i < 5; i++) {
        holes[i] = (exk_hole){(i * 3) % 5, {0.1, 0.2, 1.0}, {0, 0, 1}};
    }
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_serpentine(holes, 5, 0.001));
    for (int i = 0; i < 5; i++) {
        TEST_ASSERT_EQUAL_INT32(i, holes[i].id);
    }
}

static void a_size_that_is_no_size_is_refused(void)
{
    const double nan_value = (double)NAN;
    const exk_pattern bad[] = {
        {0.0, 0.2, {0, 0, 1}, 2, 2},         {0.3, -0.2, {0, 0, 1}, 2, 2},
        {nan_value, 0.2, {0, 0, 1}, 2, 2},   {0.3, (double)INFINITY, {0, 0, 1}, 2, 2},
        {0.3, 0.2, {0, nan_value, 1}, 2, 2},
    };
    for (size_t i = 0; i < sizeof(bad) / sizeof(bad[0]); i++) {
        TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_job_rectangle(&bad[i], holes, CAPACITY, &n_holes));
        TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_job_grid(&bad[i], holes, CAPACITY, &n_holes));
    }
    const exk_pattern no_row = {0.3, 0.2, {0, 0, 1}, 0, 2};
    const exk_pattern no_column = {0.3, 0.2, {0, 0, 1}, 2, -1};
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_job_grid(&no_row, holes, CAPACITY, &n_holes));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_job_grid(&no_column, holes, CAPACITY, &n_holes));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_job_serpentine(holes, 1, nan_value));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_job_serpentine(holes, 1, -1.0));
    holes[0].target_m[EXK_X] = nan_value;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_job_serpentine(holes, 1, 0.001));
}

static void an_array_too_short_is_refused(void)
{
    const exk_pattern pattern = {0.3, 0.2, {0, 0, 1}, 5, 5};
    const exk_pattern huge = {0.3, 0.2, {0, 0, 1}, 2147483647, 2147483647};
    TEST_ASSERT_EQUAL(EXK_ERR_SIZE, exk_job_rectangle(&pattern, holes, 3, &n_holes));
    TEST_ASSERT_EQUAL(EXK_ERR_SIZE, exk_job_grid(&pattern, holes, 24, &n_holes));
    TEST_ASSERT_EQUAL(EXK_ERR_SIZE, exk_job_grid(&huge, holes, CAPACITY, &n_holes));
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_grid(&pattern, holes, 25, &n_holes));
}

static void a_pattern_without_an_end_is_refused(void)
{
    exk_hole some[8] = {{1, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}};
    size_t n = 0;
    for (int i = 0; i < 4; i++) {
        exk_pattern pattern = {0.3, 0.2, {0.0, 0.0, 0.95}, 1, 1};
        pattern.width_m = i == 0 ? (double)INFINITY : pattern.width_m;
        pattern.height_m = i == 1 ? (double)INFINITY : pattern.height_m;
        pattern.height_m = i == 2 ? 0.0 : pattern.height_m;
        pattern.center_m[1] = i == 3 ? (double)NAN : 0.0;
        TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_job_rectangle(&pattern, some, 8, &n));
    }
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_job_serpentine(some, 1, (double)INFINITY));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_job_serpentine(some, 1, (double)NAN));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_rectangle_goes_round_from_its_lower_left_corner);
    RUN_TEST(a_grid_turns_back_in_every_second_row);
    RUN_TEST(a_single_row_stands_at_the_centre);
    RUN_TEST(serpentine_sorts_rows_and_keeps_ids);
    RUN_TEST(serpentine_of_a_grid_changes_nothing);
    RUN_TEST(holes_at_one_place_go_by_id);
    RUN_TEST(a_size_that_is_no_size_is_refused);
    RUN_TEST(an_array_too_short_is_refused);
    RUN_TEST(a_pattern_without_an_end_is_refused);
    return UNITY_END();
}
