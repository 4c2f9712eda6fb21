#include <math.h>
#include <string.h>

#include "exk/accuracy.h"
#include "exk/vec3.h"
#include "unity.h"

static const double TOLERANCE_M = 0.03e-3;
static exk_hole holes[3];
static exk_hole_result results[3];
static exk_judge judge;

void setUp(void)
{
    for (int i = 0; i < 3; i++) {
        holes[i] = (exk_hole){.id = 10 + i, .target_m = {0.1 * i, 0.2, 1.0}, .axis = {0, 0, 1}};
    }
    TEST_ASSERT_EQUAL(EXK_OK, exk_judge_init(&judge, holes, 3, TOLERANCE_M, results));
}

void tearDown(void)
{
}

/* One sample dx, dy beside the target of a hole. */
static exk_judged_point point(int64_t k, int32_t hole, bool dwell, double dx_m, double dy_m)
{
    exk_judged_point p = {.k = k, .hole = hole, .dwell = dwell};
    const exk_hole *h = &holes[hole >= 0 && hole < 3 ? hole : 0];
    exk_copy3(h->target_m, p.ref.tip_m);
    exk_copy3(h->axis, p.ref.axis);
    exk_copy3(h->axis, p.tool.axis);
    exk_copy3(h->target_m, p.tool.tip_m);
    p.tool.tip_m[0] += dx_m;
    p.tool.tip_m[1] += dy_m;
    return p;
}

static int32_t push(int64_t k, int32_t hole, bool dwell, double dx_m, double dy_m)
{
    const exk_judged_point p = point(k, hole, dwell, dx_m, dy_m);
    return exk_judge_push(&judge, &p);
}

static void init_refuses(void)
{
    static const double bad_tolerance[] = {0.0, -1e-3, NAN, INFINITY};
    for (size_t i = 0; i < 4; i++) {
        TEST_ASSERT_EQUAL(EXK_ERR_ARG,
                          exk_judge_init(&judge, holes, 3, bad_tolerance[i], results));
    }
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_judge_init(NULL, holes, 3, 1e-3, results));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_judge_init(&judge, NULL, 3, 1e-3, results));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_judge_init(&judge, holes, 3, 1e-3, NULL));
    TEST_ASSERT_EQUAL(EXK_ERR_SIZE, exk_judge_init(&judge, holes, 0, 1e-3, results));
    TEST_ASSERT_EQUAL(EXK_ERR_SIZE,
                      exk_judge_init(&judge, holes, (size_t)INT32_MAX + 1, 1e-3, results));
    holes[2].target_m[1] = NAN;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_judge_init(&judge, holes, 3, 1e-3, results));
    holes[2].target_m[1] = 0.2;
    holes[1].axis[2] = 1.00001;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_judge_init(&judge, holes, 3, 1e-3, results));
    holes[1].axis[2] = NAN;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_judge_init(&judge, holes, 3, 1e-3, results));
}

static void the_last_sample_of_the_dwell_counts(void)
{
    TEST_ASSERT_EQUAL_INT32(-1, push(0, 0, false, 1.0, 1.0));
    TEST_ASSERT_EQUAL_INT32(-1, push(1, 0, true, 9e-3, 0.0));
    TEST_ASSERT_EQUAL_INT32(-1, push(2, 0, true, 3e-6, -4e-6));
    TEST_ASSERT_FALSE(results[0].drilled);
    TEST_ASSERT_EQUAL_INT32(0, push(3, 0, false, 7e-3, 0.0)); /* the stroke */
    TEST_ASSERT_TRUE(results[0].drilled);
    TEST_ASSERT_TRUE(results[0].inside);
    TEST_ASSERT_EQUAL_INT64(2, results[0].k);
    TEST_ASSERT_DOUBLE_WITHIN(1e-16, 3e-6, results[0].dx_m);
    TEST_ASSERT_DOUBLE_WITHIN(1e-16, -4e-6, results[0].dy_m);
    TEST_ASSERT_DOUBLE_WITHIN(1e-16, 5e-6, results[0].radial_m);
    TEST_ASSERT_EQUAL_INT32(-1, push(4, 1, false, 0.0, 0.0));
}

static void a_missed_stroke_closes_with_the_next_dwell(void)
{
    push(5, 0, true, 1e-6, 0.0);
    TEST_ASSERT_EQUAL_INT32(0, push(500, 1, true, 2e-6, 0.0));
    TEST_ASSERT_EQUAL_INT64(5, results[0].k);
    TEST_ASSERT_EQUAL_INT32(1, push(501, 2, false, 0.0, 0.0));
    TEST_ASSERT_DOUBLE_WITHIN(1e-16, 2e-6, results[1].dx_m);
}

/* Every 7th sample only: whatever of the dwell was kept last still counts. */
static void a_decimated_run_is_judged_on_the_last_one_kept(void)
{
    for (int64_t k = 0; k < 300; k += 7) {
        const int32_t hole = (int32_t)(k / 100);
        const int64_t within = k % 100;
        push(k, hole, within >= 40 && within < 60, 1e-6 * (double)within, 0.0);
    }
    for (int64_t i = 0; i < 3; i++) {
        const int64_t last = (100 * i + 59) / 7 * 7;
        TEST_ASSERT_TRUE(results[i].drilled);
        TEST_ASSERT_EQUAL_INT64(last, results[i].k);
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1e-6 * (double)(last % 100), results[i].dx_m);
    }
}

static void a_hole_without_a_dwell_sample_is_not_drilled(void)
{
    exk_accuracy sum;
    push(0, 0, true, 0.0, 0.0);
    push(1, 1, false, 0.0, 0.0);
    push(2, 2, true, 0.0, 0.0);
    exk_judge_summary(&judge, &sum);
    TEST_ASSERT_EQUAL_size_t(1, sum.n_drilled);
    TEST_ASSERT_FALSE(results[1].drilled);
    TEST_ASSERT_FALSE(results[2].drilled);
    TEST_ASSERT_EQUAL_INT32(2, exk_judge_end(&judge));
    TEST_ASSERT_EQUAL_INT32(-1, exk_judge_end(&judge));
    TEST_ASSERT_TRUE(results[2].drilled);
}

static void a_second_dwell_judges_again(void)
{
    push(0, 0, true, 1e-6, 0.0);
    push(1, 0, false, 0.0, 0.0);
    push(2, 0, true, 40e-6, 0.0);
    TEST_ASSERT_FALSE(results[0].drilled);
    TEST_ASSERT_EQUAL_INT32(0, push(3, 0, false, 0.0, 0.0));
    TEST_ASSERT_FALSE(results[0].inside);
    TEST_ASSERT_EQUAL_INT64(2, results[0].k);
}

static void an_index_outside_the_list_judges_nothing(void)
{
    static const int32_t bad[] = {-1, 3, INT32_MAX, INT32_MIN};
    exk_accuracy sum;
    for (size_t i = 0; i < 4; i++) {
        TEST_ASSERT_EQUAL_INT32(-1, push((int64_t)i, bad[i], true, 0.0, 0.0));
    }
    TEST_ASSERT_EQUAL_INT32(-1, exk_judge_end(&judge));
    exk_judge_summary(&judge, &sum);
    TEST_ASSERT_EQUAL_size_t(0, sum.n_drilled);
    TEST_ASSERT_EQUAL_INT32(-1, sum.worst);
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 0.0, sum.mean_m);
}

static void inside_includes_the_limit(void)
{
    static const struct {
        const char *name;
        double dx_m;
        bool inside;
    } rows[] = {{"on target", 0.0, true},
                {"just within", 0.0299e-3, true},
                {"just beyond", 0.0301e-3, false},
                {"infinite", INFINITY, false},
                {"not a number", NAN, false}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        setUp();
        push(0, 0, true, rows[i].dx_m, 0.0);
        exk_judge_end(&judge);
        TEST_ASSERT_EQUAL_MESSAGE(rows[i].inside, results[0].inside, rows[i].name);
    }
    /* 3, 4, 5: the distance and the limit are the same double */
    holes[0].target_m[1] = 0.0;
    TEST_ASSERT_EQUAL(EXK_OK, exk_judge_init(&judge, holes, 1, 5.0, results));
    push(0, 0, true, 3.0, 4.0);
    exk_judge_end(&judge);
    TEST_ASSERT_TRUE(results[0].inside);
}

static void nan_cannot_hide(void)
{
    exk_accuracy sum;
    push(0, 0, true, 1e-6, 0.0);
    push(1, 1, true, NAN, 0.0);
    push(2, 2, true, 90e-6, 0.0);
    exk_judge_end(&judge);
    exk_judge_summary(&judge, &sum);
    TEST_ASSERT_EQUAL_size_t(3, sum.n_drilled);
    TEST_ASSERT_EQUAL_size_t(1, sum.n_inside);
    TEST_ASSERT_EQUAL_INT32(1, sum.worst);
    TEST_ASSERT_DOUBLE_IS_NAN(sum.max_m);
    TEST_ASSERT_DOUBLE_IS_NAN(sum.mean_m);
    TEST_ASSERT_DOUBLE_IS_NAN(sum.rms_path_m);
}

static void summary_of_three_holes(void)
{
    exk_accuracy sum;
    push(0, 0, true, 10e-6, 0.0);
    push(1, 1, true, 0.0, 50e-6);
    push(2, 2, true, -30e-6, 0.0);
    push(3, 2, false, 3e-6, 4e-6);
    exk_judge_summary(&judge, &sum);
    TEST_ASSERT_EQUAL_size_t(3, sum.n_drilled);
    TEST_ASSERT_EQUAL_INT32(1, sum.worst);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 30e-6, sum.mean_m);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 50e-6, sum.max_m);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 5e-6, sum.last_point_m);
    const double mean_sq = (100.0 + 2500.0 + 900.0 + 25.0) / 4.0;
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1e-6 * sqrt(mean_sq), sum.rms_path_m);
}

/* A tip off along the axis is no error; across it, dx and dy follow e1 and e2. */
static void tilted_axes(void)
{
    static const struct {
        const char *name;
        double axis[3];
        double off[3];
        double d[2];
    } rows[] = {
        {"Z: X and Y", {0, 0, 1}, {1, 2, 3}, {1, 2}},
        {"-Z: X and -Y", {0, 0, -1}, {1, 2, 3}, {1, -2}},
        {"Y: X and -Z", {0, 1, 0}, {1, 2, 3}, {1, -3}},
        {"X: Y stands in", {1, 0, 0}, {1, 2, 3}, {2, 3}},
        {"-X: Y stands in", {-1, 0, 0}, {1, 2, 3}, {2, -3}},
        {"tilted in XZ, along", {0.6, 0, 0.8}, {6, 0, 8}, {0, 0}},
        {"tilted in XZ, across", {0.6, 0, 0.8}, {0.8, 5, -0.6}, {1, 5}},
        {"tilted in YZ", {0, 0.6, 0.8}, {2, 0.8, -0.6}, {2, 1}},
    };
    static const double target[3] = {100.0, -50.0, 700.0};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        double tip[3];
        double d[2];
        exk_add_scaled3(target, 1.0, rows[i].off, tip);
        exk_plane_error(tip, target, rows[i].axis, d);
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-12, rows[i].d[0], d[0], rows[i].name);
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-12, rows[i].d[1], d[1], rows[i].name);
    }
}

static void radial_is_the_distance_from_the_axis_for_any_axis(void)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    static const double tip[3] = {0.3, -0.2, 0.7};
    for (int i = 0; i < 400; i++) {
        const double polar = acos(-1.0) * (i / 20) / 19.0;
        const double turn = 2.0 * acos(-1.0) * (i % 20) / 20.0;
        const double axis[3] = {sin(polar) * cos(turn), sin(polar) * sin(turn), cos(polar)};
        double d[2];
        double c[3];
        exk_plane_error(tip, zero, axis, d);
        exk_cross3(tip, axis, c);
        TEST_ASSERT_DOUBLE_WITHIN(1e-14, exk_norm3(c), sqrt(d[0] * d[0] + d[1] * d[1]));
    }
}

static void tilt_is_the_angle_between_tool_and_hole(void)
{
    exk_judged_point p = point(0, 0, true, 0.0, 0.0);
    p.tool.axis[0] = sin(0.01);
    p.tool.axis[2] = cos(0.01);
    exk_judge_push(&judge, &p);
    TEST_ASSERT_EQUAL_INT32(0, exk_judge_end(&judge));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.01, results[0].tilt_rad);
}

static void a_run_of_no_sample_has_no_errors(void)
{
    exk_accuracy out;
    TEST_ASSERT_EQUAL(EXK_OK, exk_judge_init(&judge, holes, 1, 1e-3, results));
    exk_judge_summary(&judge, &out);
    TEST_ASSERT_EQUAL_INT(0, out.n_drilled);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, out.rms_path_m);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(init_refuses);
    RUN_TEST(a_run_of_no_sample_has_no_errors);
    RUN_TEST(the_last_sample_of_the_dwell_counts);
    RUN_TEST(a_missed_stroke_closes_with_the_next_dwell);
    RUN_TEST(a_decimated_run_is_judged_on_the_last_one_kept);
    RUN_TEST(a_hole_without_a_dwell_sample_is_not_drilled);
    RUN_TEST(a_second_dwell_judges_again);
    RUN_TEST(an_index_outside_the_list_judges_nothing);
    RUN_TEST(inside_includes_the_limit);
    RUN_TEST(nan_cannot_hide);
    RUN_TEST(summary_of_three_holes);
    RUN_TEST(tilted_axes);
    RUN_TEST(radial_is_the_distance_from_the_axis_for_any_axis);
    RUN_TEST(tilt_is_the_angle_between_tool_and_hole);
    return UNITY_END();
}
