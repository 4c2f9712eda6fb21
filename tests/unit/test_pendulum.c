#include "exk/pendulum.h"

#include <math.h>
#include <string.h>

#include "unity.h"

/* 1e-15 relative, on lengths of about one metre, twice over. */
#define EXACT 2e-15

static exk_kin kin;

void setUp(void)
{
    const exk_geometry geo = exk_geometry_default();
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, EXK_KIN_PENDULUM, EXK_WRIST_AB, &geo));
}

void tearDown(void)
{
}

static const double L2 = 1.0511898020814319; /* sqrt(0.95^2 + 0.45^2) */

static const struct {
    const char *name;
    double tip_m[3];
    double axis[3];
    exk_err want;
} inverse_rows[] = {
    {"centre", {0.0, 0.0, 0.95}, {0, 0, 1}, EXK_OK},
    {"axis off by rounding", {0.1, 0.1, 0.95}, {1e-10, 0, 1.0 - 1e-10}, EXK_OK},
    {"just inside 0.6 rad", {0.5935, -0.5364, 0.95}, {0, 0, 1}, EXK_OK},
    {"alpha beyond 0.6 rad", {0.5936, 0.0, 0.95}, {0, 0, 1}, EXK_ERR_LIMIT},
    {"beta beyond 0.6 rad", {0.0, -0.5365, 0.95}, {0, 0, 1}, EXK_ERR_LIMIT},
    {"x longer than bar 2", {1.06, 0.0, 0.95}, {0, 0, 1}, EXK_ERR_UNREACHABLE},
    {"y longer than bars 1 and 3", {0.0, 0.96, 0.95}, {0, 0, 1}, EXK_ERR_UNREACHABLE},
    {"tilted tool", {0.0, 0.0, 0.95}, {2e-9, 0, 1}, EXK_ERR_UNREACHABLE},
    {"tool that points back", {0.0, 0.0, 0.95}, {0, 0, -1}, EXK_ERR_UNREACHABLE},
    {"plate at the base", {0.0, 0.0, 0.0}, {0, 0, 1}, EXK_ERR_UNREACHABLE},
    {"plate behind the base", {0.0, 0.0, -0.95}, {0, 0, 1}, EXK_ERR_UNREACHABLE},
    {"height that overflows", {0.0, 0.0, 1e200}, {0, 0, 1}, EXK_ERR_UNREACHABLE},
    {"x that overflows", {1e308, 0.0, 0.95}, {0, 0, 1}, EXK_ERR_UNREACHABLE},
    {"NaN x", {(double)NAN, 0.0, 0.95}, {0, 0, 1}, EXK_ERR_ARG},
    {"infinite y", {0.0, (double)INFINITY, 0.95}, {0, 0, 1}, EXK_ERR_ARG},
    {"NaN z", {0.0, 0.0, (double)NAN}, {0, 0, 1}, EXK_ERR_ARG},
    {"NaN axis", {0.0, 0.0, 0.95}, {0, (double)NAN, 1}, EXK_ERR_ARG},
};

static void the_inverse_tells_its_refusals_apart(void)
{
    for (size_t i = 0; i < sizeof inverse_rows / sizeof inverse_rows[0]; i++) {
        exk_tool tool;
        exk_joints joints, before;
        memcpy(tool.tip_m, inverse_rows[i].tip_m, sizeof tool.tip_m);
        memcpy(tool.axis, inverse_rows[i].axis, sizeof tool.axis);
        memset(&joints, 0x5a, sizeof joints);
        before = joints;
        TEST_ASSERT_EQUAL_MESSAGE(inverse_rows[i].want, exk_kin_inverse(&kin, &tool, &joints),
                                  inverse_rows[i].name);
        if (inverse_rows[i].want != EXK_OK) {
            TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&before, &joints, sizeof joints,
                                             inverse_rows[i].name);
        }
    }
}

static const struct {
    const char *name;
    double alpha, beta, h;
    exk_err want;
} joint_rows[] = {
    {"beyond the inverse's limit, still drawn", 1.0, 1.0, 0.95, EXK_OK},
    {"alpha of 90 deg", 1.5708, 0.0, 0.95, EXK_ERR_UNREACHABLE},
    {"beta a turn too far", 0.0, 6.2, 0.95, EXK_ERR_UNREACHABLE},
    {"no height", 0.0, 0.0, 0.0, EXK_ERR_UNREACHABLE},
    {"height that overflows", 0.0, 0.0, 1e300, EXK_ERR_UNREACHABLE},
    {"NaN alpha", (double)NAN, 0.0, 0.95, EXK_ERR_ARG},
    {"infinite beta", 0.0, (double)-INFINITY, 0.95, EXK_ERR_ARG},
    {"NaN height", 0.0, 0.0, (double)NAN, EXK_ERR_ARG},
};

static void forward_legs_and_jacobian_check_finiteness_and_domain(void)
{
    for (size_t i = 0; i < sizeof joint_rows / sizeof joint_rows[0]; i++) {
        const char *name = joint_rows[i].name;
        const exk_joints joints = {.angle_rad = {joint_rows[i].alpha, joint_rows[i].beta},
                                   .h_m = joint_rows[i].h};
        exk_tool tool;
        double legs_m[EXK_N_LEGS], J[2][2];
        const exk_err want = joint_rows[i].want;
        TEST_ASSERT_EQUAL_MESSAGE(want, exk_kin_forward(&kin, &joints, &tool), name);
        TEST_ASSERT_EQUAL_MESSAGE(want, exk_kin_legs(&kin, &joints, legs_m), name);
        TEST_ASSERT_EQUAL_MESSAGE(want, exk_pendulum_jacobian(&kin, &joints, J), name);
    }
}

static void published_points_come_out(void)
{
    exk_joints joints = {.angle_rad = {1.0, 1.0}, .h_m = 0.95};
    exk_tool tool;
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_forward(&kin, &joints, &tool));
    TEST_ASSERT_DOUBLE_WITHIN(5e-5, 0.8845, tool.tip_m[0]);
    TEST_ASSERT_DOUBLE_WITHIN(5e-5, 0.7994, tool.tip_m[1]);
    TEST_ASSERT_DOUBLE_WITHIN(EXACT, 0.95 * cos(1.0), tool.tip_m[2]);
    TEST_ASSERT_EQUAL_DOUBLE(1.0, tool.axis[2]);

    joints = (exk_joints){.angle_rad = {1e-3, 1e-3}, .h_m = 0.95};
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_forward(&kin, &joints, &tool));
    TEST_ASSERT_DOUBLE_WITHIN(5e-7, 1.051e-3, tool.tip_m[0]); /* mm per mrad at the centre */
    TEST_ASSERT_DOUBLE_WITHIN(5e-7, 0.950e-3, tool.tip_m[1]);
}

static void height_sets_both_bars(void)
{
    const exk_tool tool = {.tip_m = {0.2, -0.1, 0.95}, .axis = {0.0, 0.0, 1.0}};
    exk_joints joints;
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_inverse(&kin, &tool, &joints));
    TEST_ASSERT_DOUBLE_WITHIN(EXACT, asin(0.2 / L2), joints.angle_rad[EXK_ALPHA]);
    TEST_ASSERT_DOUBLE_WITHIN(EXACT, asin(-0.1 / 0.95), joints.angle_rad[EXK_BETA]);
    TEST_ASSERT_EQUAL_DOUBLE(0.95, joints.h_m);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, joints.wrist_rad[0]);
}

/* On the centre line the drawn plate is the machine's home pose (docs/kinematics.md section 1). */
static void legs_of_the_level_plate(void)
{
    exk_joints joints = {.angle_rad = {0.0, 0.0}, .h_m = 0.95};
    double legs_m[EXK_N_LEGS];
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_legs(&kin, &joints, legs_m));
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.987623410, legs_m[0]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1.051189802, legs_m[1]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.987623410, legs_m[2]);

    joints.angle_rad[EXK_ALPHA] = 0.1;
    joints.angle_rad[EXK_BETA] = -0.2;
    const double x = L2 * sin(0.1), y = 0.95 * sin(-0.2), z = 0.95 * cos(-0.2);
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
    RUN_TEST(published_points_come_out);
    RUN_TEST(height_sets_both_bars);
    RUN_TEST(legs_of_the_level_plate);
    return UNITY_END();
}
