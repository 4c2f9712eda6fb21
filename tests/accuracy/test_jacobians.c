/* Every Jacobian against central differences of the function it belongs to. With a step of
 * 1e-5 the truncation is about 1e-10 and rounding 1e-11: 1e-9 leaves room for both. */
#include <math.h>

#include "exk/machine.h"
#include "exk/pendulum.h"
#include "exk/tripod.h"
#include "exk/universal.h"
#include "uniform.h"
#include "unity.h"

#define STEP 1e-5
#define CLOSE 1e-9

enum { N_POSES = 2000 };

static exk_geometry geo;

void setUp(void)
{
    geo = exk_geometry_default();
}

void tearDown(void)
{
}

static void tripod_by_position_and_by_pose(void)
{
    uniform u = {21};
    exk_tripod tri;
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_init(&tri, &geo));
    for (int n = 0; n < N_POSES; n++) {
        const double o1_m[3] = {uniform_in(&u, -0.35, 0.35), uniform_in(&u, -0.25, 0.4),
                                uniform_in(&u, 0.8, 1.02)};
        exk_tripod_pose pose;
        double J[3][3], K[3][3], low[3], high[3], legs_m[3];
        TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_inverse(&tri, o1_m, &pose, legs_m));
        TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_jacobian(&tri, o1_m, J));
        TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_jacobian_pose(&tri, &pose, K));
        for (int j = 0; j < 3; j++) {
            double at[3] = {o1_m[0], o1_m[1], o1_m[2]};
            at[j] = o1_m[j] - STEP;
            TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_lengths(&tri, at, low));
            at[j] = o1_m[j] + STEP;
            TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_lengths(&tri, at, high));
            for (int i = 0; i < 3; i++) {
                TEST_ASSERT_DOUBLE_WITHIN(CLOSE, (high[i] - low[i]) / (2.0 * STEP), J[i][j]);
            }
            double turn[3] = {pose.alpha_rad, pose.beta_rad, pose.h_m};
            turn[j] -= STEP;
            TEST_ASSERT_EQUAL(
                EXK_OK,
                exk_tripod_legs(&tri, &(exk_tripod_pose){turn[0], turn[1], turn[2]}, low));
            turn[j] += 2.0 * STEP;
            TEST_ASSERT_EQUAL(
                EXK_OK,
                exk_tripod_legs(&tri, &(exk_tripod_pose){turn[0], turn[1], turn[2]}, high));
            for (int i = 0; i < 3; i++) {
                TEST_ASSERT_DOUBLE_WITHIN(CLOSE, (high[i] - low[i]) / (2.0 * STEP), K[i][j]);
            }
        }
    }
}

static void machine_at(const exk_kin *kin, const exk_tool *tool, double legs_m[3])
{
    exk_joints joints;
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_inverse(kin, tool, &joints));
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_legs(kin, &joints, legs_m));
}

static void machine_at_a_fixed_tool_axis(void)
{
    static const double offsets_m[] = {0.0, 0.12, -0.10};
    uniform u = {22};
    for (int n = 0; n < N_POSES; n++) {
        exk_kin kin;
        geo.f_m = offsets_m[n % 3];
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, EXK_KIN_MACHINE, EXK_WRIST_AB, &geo));
        const double lean = uniform_in(&u, 0.0, 0.3), turn = uniform_in(&u, 0.0, 6.3);
        exk_tool tool = {{uniform_in(&u, -0.25, 0.25), uniform_in(&u, -0.05, 0.2),
                          uniform_in(&u, 1.35, 1.5)},
                         {sin(lean) * cos(turn), sin(lean) * sin(turn), cos(lean)}};
        double J[3][3], low[3], high[3];
        TEST_ASSERT_EQUAL(EXK_OK, exk_machine_jacobian(&kin, &tool, J));
        for (int j = 0; j < 3; j++) {
            const double at = tool.tip_m[j];
            tool.tip_m[j] = at - STEP;
            machine_at(&kin, &tool, low);
            tool.tip_m[j] = at + STEP;
            machine_at(&kin, &tool, high);
            tool.tip_m[j] = at;
            for (int i = 0; i < 3; i++) {
                TEST_ASSERT_DOUBLE_WITHIN(CLOSE, (high[i] - low[i]) / (2.0 * STEP), J[i][j]);
            }
        }
    }
}

typedef exk_err (*plane_jacobian)(const exk_kin *, const exk_joints *, double[2][2]);

static void plane_model(exk_kin_model model, plane_jacobian jacobian)
{
    exk_kin kin;
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, model, EXK_WRIST_AB, &geo));
    for (double alpha = -1.0; alpha <= 1.0; alpha += 0.25) {
        for (double beta = -1.0; beta <= 1.0; beta += 0.25) {
            exk_joints joints = {.angle_rad = {alpha, beta}, .h_m = 0.95};
            double J[2][2];
            TEST_ASSERT_EQUAL(EXK_OK, jacobian(&kin, &joints, J));
            for (int j = 0; j < 2; j++) {
                exk_tool low, high;
                const double at = joints.angle_rad[j];
                joints.angle_rad[j] = at - STEP;
                TEST_ASSERT_EQUAL(EXK_OK, exk_kin_forward(&kin, &joints, &low));
                joints.angle_rad[j] = at + STEP;
                TEST_ASSERT_EQUAL(EXK_OK, exk_kin_forward(&kin, &joints, &high));
                joints.angle_rad[j] = at;
                for (int i = 0; i < 2; i++) {
                    TEST_ASSERT_DOUBLE_WITHIN(
                        CLOSE, (high.tip_m[i] - low.tip_m[i]) / (2.0 * STEP), J[i][j]);
                }
            }
        }
    }
}

static void pendulum_and_universal(void)
{
    plane_model(EXK_KIN_PENDULUM, exk_pendulum_jacobian);
    plane_model(EXK_KIN_UNIVERSAL, exk_universal_jacobian);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(tripod_by_position_and_by_pose);
    RUN_TEST(machine_at_a_fixed_tool_axis);
    RUN_TEST(pendulum_and_universal);
    return UNITY_END();
}
