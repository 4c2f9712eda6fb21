/* The table of check values (docs/kinematics.md section 8) and the five-axis round trip. */
#include <math.h>
#include <stdio.h>

#include "exk/machine.h"
#include "exk/pendulum.h"
#include "exk/units.h"
#include "plate_points.h"
#include "uniform.h"
#include "unity.h"

enum { N_EACH = 20000 };

static exk_geometry geo;

void setUp(void)
{
    geo = exk_geometry_default();
}

void tearDown(void)
{
}

/* Tool along Z, hole plane z = 1.45; degrees and metres as printed. */
static const struct {
    double x_m, y_m, alpha, beta, l1, l2, l3, ab4, ab5, ca4, ca5;
} table[] = {
    {0.15, 0.10, 7.8216, 4.9697, 1.057053, 1.007012, 0.943526, 5.0162, -7.7920, -57.423, 9.259},
    {-0.15, 0.10, -7.8216, 4.9697, 0.943526, 1.007012, 1.057053, 5.0162, 7.7920, 57.423, 9.259},
    {0.15, -0.10, 7.0281, -4.9697, 1.055338, 1.119193, 0.945135, -5.0072, -7.0016, -125.401,
     8.601},
    {0.30, 0.20, 16.0339, 9.8658, 1.149942, 0.989086, 0.925887, 10.2568, -15.7905, -57.803,
     18.758},
    {0.30, -0.20, 13.0857, -9.8658, 1.143175, 1.207781, 0.931915, -10.1235, -12.8889, -127.529,
     16.336},
};

#define DEG(x) ((x) / EXK_RAD_PER_DEG)

static void the_table_of_check_values(void)
{
    exk_kin ab, ca;
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&ab, EXK_KIN_MACHINE, EXK_WRIST_AB, &geo));
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&ca, EXK_KIN_MACHINE, EXK_WRIST_CA, &geo));
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        const exk_tool tool = {{table[i].x_m, table[i].y_m, 1.45}, {0.0, 0.0, 1.0}};
        exk_joints joints;
        double legs_m[3];
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_inverse(&ab, &tool, &joints));
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_legs(&ab, &joints, legs_m));
        TEST_ASSERT_DOUBLE_WITHIN(5.1e-5, table[i].alpha, DEG(joints.angle_rad[EXK_ALPHA]));
        TEST_ASSERT_DOUBLE_WITHIN(5.1e-5, table[i].beta, DEG(joints.angle_rad[EXK_BETA]));
        TEST_ASSERT_DOUBLE_WITHIN(5.1e-7, table[i].l1, legs_m[0]);
        TEST_ASSERT_DOUBLE_WITHIN(5.1e-7, table[i].l2, legs_m[1]);
        TEST_ASSERT_DOUBLE_WITHIN(5.1e-7, table[i].l3, legs_m[2]);
        TEST_ASSERT_DOUBLE_WITHIN(5.1e-5, table[i].ab4, DEG(joints.wrist_rad[0]));
        TEST_ASSERT_DOUBLE_WITHIN(5.1e-5, table[i].ab5, DEG(joints.wrist_rad[1]));
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_inverse(&ca, &tool, &joints));
        TEST_ASSERT_DOUBLE_WITHIN(5.1e-4, table[i].ca4, DEG(joints.wrist_rad[0]));
        TEST_ASSERT_DOUBLE_WITHIN(5.1e-4, table[i].ca5, DEG(joints.wrist_rad[1]));
    }
}

static double most(double a, double b)
{
    return b <= a ? a : b; /* keeps a NaN */
}

/* One tool within 45 deg of Z; returns false where it is outside the workspace. */
static bool go_and_return(const exk_kin *kin, uniform *u, double *worst, double *legs_worst)
{
    const double lean = uniform_in(u, 0.02, 0.785), turn = uniform_in(u, 0.0, 6.2832);
    const exk_tool tool = {
        {uniform_in(u, -0.6, 0.6), uniform_in(u, -0.6, 0.6), uniform_in(u, 1.1, 1.7)},
        {sin(lean) * cos(turn), sin(lean) * sin(turn), cos(lean)}};
    exk_joints joints;
    exk_tool back;
    double legs_m[3], points_m[3], o1_m[3];
    if (exk_kin_inverse(kin, &tool, &joints) != EXK_OK) {
        return false;
    }
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_forward(kin, &joints, &back));
    *worst = most(*worst, distance(tool.tip_m, back.tip_m));
    *worst = most(*worst, distance(tool.axis, back.axis));

    /* the legs once more, from the plate's points */
    const double alpha = joints.angle_rad[EXK_ALPHA], beta = joints.angle_rad[EXK_BETA];
    const exk_tripod_pose pose = {alpha, beta, joints.h_m};
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_legs(kin, &joints, legs_m));
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_position(&kin->tripod, &pose, o1_m));
    plate_legs(&kin->geo, o1_m, alpha, beta, points_m);
    *legs_worst = most(*legs_worst, distance(legs_m, points_m));
    return true;
}

static void five_axis_round_trip(void)
{
    static const double offsets_m[] = {0.0, 0.12, -0.10};
    uniform u = {31};
    double worst = 0.0, legs_worst = 0.0;
    for (int wrist = 0; wrist < EXK_WRIST_COUNT; wrist++) {
        for (int i = 0; i < 3; i++) {
            exk_kin kin;
            geo.f_m = offsets_m[i];
            TEST_ASSERT_EQUAL(EXK_OK,
                              exk_kin_init(&kin, EXK_KIN_MACHINE, (exk_wrist_kind)wrist, &geo));
            for (long n = 0, tries = 0; n < N_EACH; tries++) {
                TEST_ASSERT_TRUE_MESSAGE(tries < 20L * N_EACH, "hardly a tool is reachable");
                n += go_and_return(&kin, &u, &worst, &legs_worst);
            }
        }
    }
    printf("%d five-axis poses: tip and axis back within %.1e, legs %.1e m\n", 6 * N_EACH,
           worst, legs_worst);
    TEST_ASSERT_TRUE(worst < 1e-12);
    TEST_ASSERT_TRUE(legs_worst < 1e-12);
}

/* Section 10: P against the exact tripod at beta = 0 falls short by these milliradians. */
static void model_P_falls_short_of_the_machine_as_published(void)
{
    static const double x_m[] = {0.05, 0.1, 0.2, 0.3}, short_mrad[] = {5.0, 9.6, 16.1, 16.5};
    exk_kin p;
    exk_tripod tri;
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&p, EXK_KIN_PENDULUM, EXK_WRIST_AB, &geo));
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_init(&tri, &geo));
    for (int i = 0; i < 4; i++) {
        const exk_tool tool = {{x_m[i], 0.0, 0.95}, {0.0, 0.0, 1.0}};
        exk_joints joints;
        exk_tripod_pose pose;
        double legs_m[3];
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_inverse(&p, &tool, &joints));
        TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_inverse(&tri, tool.tip_m, &pose, legs_m));
        TEST_ASSERT_DOUBLE_WITHIN(0.051, short_mrad[i],
                                  1e3 * (pose.alpha_rad - joints.angle_rad[EXK_ALPHA]));
    }
}

/* P and U return to the (x, y) they came from. */
static void plane_models_return(void)
{
    uniform u = {32};
    for (int model = EXK_KIN_PENDULUM; model <= EXK_KIN_UNIVERSAL; model++) {
        exk_kin kin;
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, (exk_kin_model)model, EXK_WRIST_AB, &geo));
        for (int n = 0; n < N_EACH; n++) {
            const exk_tool tool = {{uniform_in(&u, -0.37, 0.37), uniform_in(&u, -0.37, 0.37),
                                    uniform_in(&u, 0.8, 1.1)},
                                   {0.0, 0.0, 1.0}};
            exk_joints joints;
            exk_tool back;
            TEST_ASSERT_EQUAL(EXK_OK, exk_kin_inverse(&kin, &tool, &joints));
            TEST_ASSERT_EQUAL(EXK_OK, exk_kin_forward(&kin, &joints, &back));
            TEST_ASSERT_DOUBLE_WITHIN(1e-15, tool.tip_m[0], back.tip_m[0]);
            TEST_ASSERT_DOUBLE_WITHIN(1e-15, tool.tip_m[1], back.tip_m[1]);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_table_of_check_values);
    RUN_TEST(five_axis_round_trip);
    RUN_TEST(model_P_falls_short_of_the_machine_as_published);
    RUN_TEST(plane_models_return);
    return UNITY_END();
}
