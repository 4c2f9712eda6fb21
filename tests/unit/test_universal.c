#include "exk/universal.h"

#include <math.h>
#include <string.h>

#include "unity.h"

/* A few roundings of lengths of about one metre. */
#define EXACT 2e-15

static exk_kin kin;

void setUp(void)
{
    const exk_geometry geo = exk_geometry_default();
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, EXK_KIN_UNIVERSAL, EXK_WRIST_AB, &geo));
}

void tearDown(void)
{
}

static const struct {
    const char *name;
    double x, y, z, axis_z;
    exk_err want;
} inverse_rows[] = {
    {"centre", 0.0, 0.0, 0.95, 1.0, EXK_OK},
    {"inside", 0.4, -0.4, 0.95, 1.0, EXK_OK},
    {"alpha beyond 0.6 rad", 0.5365, 0.0, 0.95, 1.0, EXK_ERR_LIMIT},
    {"beta beyond 0.6 rad", 0.0, 0.5365, 0.95, 1.0, EXK_ERR_LIMIT},
    {"outside the sphere of radius R", 0.7, 0.7, 0.95, 1.0, EXK_ERR_UNREACHABLE},
    {"on the sphere's equator", 0.95, 0.0, 0.95, 1.0, EXK_ERR_UNREACHABLE},
    {"behind the base", 0.0, 0.0, -0.95, 1.0, EXK_ERR_UNREACHABLE},
    {"tool off its length", 0.0, 0.0, 0.95, 1.1, EXK_ERR_UNREACHABLE},
    {"x and y that overflow", 1e200, 1e200, 0.95, 1.0, EXK_ERR_UNREACHABLE},
    {"NaN", (double)NAN, 0.0, 0.95, 1.0, EXK_ERR_ARG},
    {"infinite", 0.0, (double)INFINITY, 0.95, 1.0, EXK_ERR_ARG},
};

static void the_inverse_tells_its_refusals_apart(void)
{
    for (size_t i = 0; i < sizeof inverse_rows / sizeof inverse_rows[0]; i++) {
        const exk_tool tool = {
            .tip_m = {inverse_rows[i].x, inverse_rows[i].y, inverse_rows[i].z},
            .axis = {0.0, 0.0, inverse_rows[i].axis_z}};
        exk_joints joints;
        TEST_ASSERT_EQUAL_MESSAGE(inverse_rows[i].want, exk_kin_inverse(&kin, &tool, &joints),
                                  inverse_rows[i].name);
    }
}

static void forward_legs_and_jacobian_check_finiteness_and_domain(void)
{
    static const struct {
        double alpha, beta, h;
        exk_err want;
    } rows[] = {
        {1.0, 1.0, 0.95, EXK_OK},
        {0.0, -1.5708, 0.95, EXK_ERR_UNREACHABLE},
        {0.0, 0.0, -0.95, EXK_ERR_UNREACHABLE},
        {(double)NAN, 0.0, 0.95, EXK_ERR_ARG},
        {0.0, 0.0, (double)INFINITY, EXK_ERR_ARG},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const exk_joints joints = {.angle_rad = {rows[i].alpha, rows[i].beta},
                                   .h_m = rows[i].h};
        exk_tool tool;
        double legs_m[EXK_N_LEGS], J[2][2];
        TEST_ASSERT_EQUAL(rows[i].want, exk_kin_forward(&kin, &joints, &tool));
        TEST_ASSERT_EQUAL(rows[i].want, exk_kin_legs(&kin, &joints, legs_m));
        TEST_ASSERT_EQUAL(rows[i].want, exk_universal_jacobian(&kin, &joints, J));
    }
}

static void the_published_point_comes_out(void)
{
    const exk_joints joints = {.angle_rad = {1.0, 1.0}, .h_m = 0.95};
    exk_tool tool;
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_forward(&kin, &joints, &tool));
    TEST_ASSERT_DOUBLE_WITHIN(5e-4, 0.799, tool.tip_m[0]);
    TEST_ASSERT_DOUBLE_WITHIN(5e-4, 0.432, tool.tip_m[1]);
    TEST_ASSERT_DOUBLE_WITHIN(EXACT, 0.95,
                              hypot(hypot(tool.tip_m[0], tool.tip_m[1]), tool.tip_m[2]));
    TEST_ASSERT_EQUAL_DOUBLE(1.0, tool.axis[2]);
}

static void legs_are_the_distances_of_the_level_plate(void)
{
    const exk_joints joints = {.angle_rad = {0.2, 0.1}, .h_m = 0.95};
    const double x = 0.95 * sin(0.2), arm = 0.95 * cos(0.2);
    const double y = arm * sin(0.1), z = arm * cos(0.1);
    double legs_m[EXK_N_LEGS];
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_legs(&kin, &joints, legs_m));
    TEST_ASSERT_DOUBLE_WITHIN(EXACT, hypot(hypot(x - 0.18 + 0.45, y), z), legs_m[0]);
    TEST_ASSERT_DOUBLE_WITHIN(EXACT, hypot(hypot(x, y + 0.27 - 0.72), z), legs_m[1]);
    TEST_ASSERT_DOUBLE_WITHIN(EXACT, hypot(hypot(x + 0.18 - 0.45, y), z), legs_m[2]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_inverse_tells_its_refusals_apart);
    RUN_TEST(forward_legs_and_jacobian_check_finiteness_and_domain);
    RUN_TEST(the_published_point_comes_out);
    RUN_TEST(legs_are_the_distances_of_the_level_plate);
    return UNITY_END();
}
