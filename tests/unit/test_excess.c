/* What a refused place is beyond: each leg at either end, each angle on either side, and nothing where
 * something else is wrong. */
#include "exk/excess.h"

#include <math.h>

#include "unity.h"

static exk_geometry geo;
static exk_kin kin;
static exk_excess excess;

void setUp(void)
{
    geo = exk_geometry_default();
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, EXK_KIN_MACHINE, EXK_WRIST_AB, &geo));
}

void tearDown(void)
{
}

static exk_joints at(double alpha, double beta, double h)
{
    return (exk_joints){.angle_rad = {alpha, beta}, .h_m = h};
}

static void each_leg_and_angle_is_named(void)
{
    const double l_max = geo.l_min_m + geo.d5_m;
    const struct {
        exk_joints joints;
        bool is_leg;
        int index;
        double limit;
    } rows[] = {
        {at(0.3, 0.0, 1.22), true, 0, l_max},
        {at(-0.3, 0.0, 1.22), true, 2, l_max},
        {at(0.0, 0.0, 1.28), true, 1, l_max},
        {at(-0.4, 0.0, 0.7), true, 0, geo.l_min_m},
        {at(0.4, 0.0, 0.7), true, 2, geo.l_min_m},
        {at(0.62, 0.0, 1.0), false, EXK_ALPHA, geo.angle_max_rad},
        {at(0.1, -0.62, 1.0), false, EXK_BETA, -geo.angle_max_rad},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        double legs_m[EXK_N_LEGS];
        TEST_ASSERT_EQUAL(EXK_ERR_LIMIT, exk_kin_legs(&kin, &rows[i].joints, legs_m));
        TEST_ASSERT_TRUE(exk_excess_of_joints(&kin, &rows[i].joints, &excess));
        TEST_ASSERT_EQUAL_INT(rows[i].is_leg, excess.is_leg);
        TEST_ASSERT_EQUAL_INT(rows[i].index, excess.index);
        TEST_ASSERT_EQUAL_DOUBLE(rows[i].limit, excess.limit);
        TEST_ASSERT_TRUE(rows[i].limit == geo.l_min_m
                             ? excess.value < excess.limit
                             : fabs(excess.value) > fabs(excess.limit));
    }
}

/* The leg is as long as the equations say, by the distance of its ends. */
static void the_value_is_that_of_the_place(void)
{
    const exk_joints joints = at(0.0, 0.0, 1.3);
    const double k_m = geo.d2_m - geo.d4_m;
    TEST_ASSERT_TRUE(exk_excess_of_joints(&kin, &joints, &excess));
    TEST_ASSERT_EQUAL_INT(1, excess.index);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, hypot(1.3, k_m), excess.value);
}

static void a_tool_is_named_by_its_joints(void)
{
    const exk_tool tool = {.tip_m = {1.0, 0.0, 1.445}, .axis = {0.0, 0.0, 1.0}};
    exk_joints joints;
    TEST_ASSERT_EQUAL(EXK_ERR_LIMIT, exk_kin_inverse(&kin, &tool, &joints));
    TEST_ASSERT_TRUE(exk_excess_of_tool(&kin, &tool, &excess));
    TEST_ASSERT_FALSE(excess.is_leg);
    TEST_ASSERT_EQUAL_INT(EXK_ALPHA, excess.index);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, atan2(1.0, 1.445 - geo.t_m), excess.value);
}

static void nothing_is_named_where_nothing_is_beyond(void)
{
    const exk_tool good = {.tip_m = {0.1, 0.0, 1.445}, .axis = {0.0, 0.0, 1.0}};
    const exk_tool bad = {.tip_m = {(double)NAN, 0.0, 1.445}, .axis = {0.0, 0.0, 1.0}};
    const exk_joints off = at(0.0, 0.0, -1.0);
    TEST_ASSERT_FALSE(exk_excess_of_tool(&kin, &good, &excess));
    TEST_ASSERT_FALSE(exk_excess_of_tool(&kin, &bad, &excess));
    TEST_ASSERT_FALSE(exk_excess_of_joints(&kin, &off, &excess));
    const exk_joints wide = at(1.0, 0.0, 0.95);
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, EXK_KIN_PENDULUM, EXK_WRIST_AB, &geo));
    TEST_ASSERT_FALSE(exk_excess_of_joints(&kin, &wide, &excess));
    TEST_ASSERT_FALSE(exk_excess_of_tool(&kin, &good, &excess));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(each_leg_and_angle_is_named);
    RUN_TEST(the_value_is_that_of_the_place);
    RUN_TEST(a_tool_is_named_by_its_joints);
    RUN_TEST(nothing_is_named_where_nothing_is_beyond);
    return UNITY_END();
}
