#include "exk/machine.h"

#include <math.h>
#include <string.h>

#include "unity.h"

static exk_kin machine_with(exk_wrist_kind wrist, double f_m)
{
    exk_geometry geo = exk_geometry_default();
    exk_kin kin;
    geo.f_m = f_m;
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, EXK_KIN_MACHINE, wrist, &geo));
    return kin;
}

void setUp(void)
{
}

void tearDown(void)
{
}

static const struct {
    const char *name;
    exk_wrist_kind wrist;
    double f_m;
    double tip_m[3];
    double axis[3];
    exk_err want;
} inverse_rows[] = {
    {"centre, AB", EXK_WRIST_AB, 0.0, {0.0, 0.0, 1.45}, {0, 0, 1}, EXK_OK},
    {"centre, CA: t4 is free",
     EXK_WRIST_CA,
     0.0,
     {0.0, 0.0, 1.45},
     {0, 0, 1},
     EXK_ERR_SINGULAR},
    {"off centre, CA", EXK_WRIST_CA, 0.0, {0.15, 0.1, 1.45}, {0, 0, 1}, EXK_OK},
    {"leg beyond the stroke", EXK_WRIST_AB, 0.0, {0.0, 0.0, 1.9}, {0, 0, 1}, EXK_ERR_LIMIT},
    {"angle beyond its limit", EXK_WRIST_AB, 0.0, {0.85, 0.0, 1.3}, {0, 0, 1}, EXK_ERR_LIMIT},
    {"tool back at the plate", EXK_WRIST_AB, 0.0, {0.0, 0.0, 0.85}, {0, 0, -1}, EXK_ERR_LIMIT},
    {"too far", EXK_WRIST_AB, 0.0, {0.0, 0.0, 9.0}, {0, 0, 1}, EXK_ERR_UNREACHABLE},
    {"behind the base", EXK_WRIST_AB, 0.0, {0.0, 0.0, -1.0}, {0, 0, 1}, EXK_ERR_UNREACHABLE},
    {"wrist centre nearer to O than e",
     EXK_WRIST_AB,
     0.0,
     {0.0, 0.0, 0.45},
     {0, 0, 1},
     EXK_ERR_UNREACHABLE},
    {"wrist centre nearer to X than f",
     EXK_WRIST_AB,
     0.2,
     {0.0, 0.0, 0.4},
     {0, 0, 1},
     EXK_ERR_UNREACHABLE},
    {"h = 0", EXK_WRIST_AB, 0.0, {0.0, 0.0, 0.5}, {0, 0, 1}, EXK_ERR_SINGULAR},
    {"axis not a unit vector", EXK_WRIST_AB, 0.0, {0, 0, 1.45}, {0, 0, 1.0001}, EXK_ERR_ARG},
    {"no axis", EXK_WRIST_AB, 0.0, {0, 0, 1.45}, {0, 0, 0}, EXK_ERR_ARG},
    {"NaN axis", EXK_WRIST_AB, 0.0, {0, 0, 1.45}, {0, 0, (double)NAN}, EXK_ERR_ARG},
    {"huge axis", EXK_WRIST_AB, 0.0, {0, 0, 1.45}, {0, 1e300, 1}, EXK_ERR_ARG},
    {"NaN tip", EXK_WRIST_AB, 0.0, {0, (double)NAN, 1.45}, {0, 0, 1}, EXK_ERR_ARG},
    {"infinite tip", EXK_WRIST_CA, 0.1, {0, 0, (double)INFINITY}, {0, 0, 1}, EXK_ERR_ARG},
};

static void the_inverse_tells_its_refusals_apart(void)
{
    for (size_t i = 0; i < sizeof inverse_rows / sizeof inverse_rows[0]; i++) {
        const char *name = inverse_rows[i].name;
        const exk_kin kin = machine_with(inverse_rows[i].wrist, inverse_rows[i].f_m);
        exk_tool tool;
        exk_joints joints, before;
        double J[3][3];
        memcpy(tool.tip_m, inverse_rows[i].tip_m, sizeof tool.tip_m);
        memcpy(tool.axis, inverse_rows[i].axis, sizeof tool.axis);
        memset(&joints, 0x5a, sizeof joints);
        before = joints;
        const exk_err got = exk_kin_inverse(&kin, &tool, &joints);
        TEST_ASSERT_EQUAL_MESSAGE(inverse_rows[i].want, got, name);
        if (got != EXK_OK) {
            TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&before, &joints, sizeof joints, name);
        }
        const exk_err tilted = exk_machine_jacobian(&kin, &tool, J);
        if (got == EXK_OK || got == EXK_ERR_ARG) { /* the Jacobian asks no wrist */
            TEST_ASSERT_EQUAL_MESSAGE(got, tilted, name);
        }
    }
}

static const struct {
    const char *name;
    exk_joints joints;
    exk_err forward, legs;
} joint_rows[] = {
    {"home", {{0.0, 0.0}, 0.95, {0.0, 0.0}}, EXK_OK, EXK_OK},
    {"beyond the angle limit", {{0.7, 0.0}, 0.95, {0.0, 0.0}}, EXK_OK, EXK_ERR_LIMIT},
    {"beyond the stroke", {{0.0, 0.0}, 1.5, {0.0, 0.0}}, EXK_OK, EXK_ERR_LIMIT},
    {"90 deg", {{1.6, 0.0}, 0.95, {0.0, 0.0}}, EXK_ERR_UNREACHABLE, EXK_ERR_UNREACHABLE},
    {"NaN alpha", {{(double)NAN, 0.0}, 0.95, {0.0, 0.0}}, EXK_ERR_ARG, EXK_ERR_ARG},
    {"NaN h", {{0.0, 0.0}, (double)NAN, {0.0, 0.0}}, EXK_ERR_ARG, EXK_ERR_ARG},
    {"NaN wrist", {{0.0, 0.0}, 0.95, {0.0, (double)NAN}}, EXK_ERR_ARG, EXK_OK},
};

static void forward_and_legs_check_finiteness_and_domain(void)
{
    const exk_kin kin = machine_with(EXK_WRIST_AB, 0.0);
    for (size_t i = 0; i < sizeof joint_rows / sizeof joint_rows[0]; i++) {
        exk_tool tool;
        double legs_m[EXK_N_LEGS];
        TEST_ASSERT_EQUAL_MESSAGE(joint_rows[i].forward,
                                  exk_kin_forward(&kin, &joint_rows[i].joints, &tool),
                                  joint_rows[i].name);
        TEST_ASSERT_EQUAL_MESSAGE(joint_rows[i].legs,
                                  exk_kin_legs(&kin, &joint_rows[i].joints, legs_m),
                                  joint_rows[i].name);
    }
}

/* Home with the wrist straight: the tool stands e + t below the plate (section 1). */
static void home_hangs_the_tool_under_the_plate(void)
{
    const exk_kin kin = machine_with(EXK_WRIST_AB, 0.1);
    const exk_joints home = {{0.0, 0.0}, 0.95, {0.0, 0.0}};
    exk_tool tool;
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_forward(&kin, &home, &tool));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.0, tool.tip_m[0]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.1, tool.tip_m[1]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.95 + 0.2 + 0.3, tool.tip_m[2]);
    TEST_ASSERT_EQUAL_DOUBLE(1.0, tool.axis[2]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_inverse_tells_its_refusals_apart);
    RUN_TEST(forward_and_legs_check_finiteness_and_domain);
    RUN_TEST(home_hangs_the_tool_under_the_plate);
    return UNITY_END();
}
