#include "exk/kinematics.h"

#include <string.h>

#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static void init_refuses_what_it_does_not_know(void)
{
    const exk_geometry good = exk_geometry_default();
    exk_geometry bad = good;
    exk_kin kin, before;
    memset(&kin, 0x5a, sizeof kin);
    memcpy(&before, &kin, sizeof kin);
    bad.d3_m = 0.5;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_kin_init(&kin, EXK_KIN_COUNT, EXK_WRIST_AB, &good));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_kin_init(&kin, (exk_kin_model)-1, EXK_WRIST_AB, &good));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_kin_init(&kin, EXK_KIN_MACHINE, EXK_WRIST_COUNT, &good));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_kin_init(&kin, EXK_KIN_MACHINE, EXK_WRIST_AB, &bad));
    TEST_ASSERT_EQUAL_MEMORY(&before, &kin, sizeof kin);
}

static void every_model_has_a_name_and_all_operations(void)
{
    static const char *const names[EXK_KIN_COUNT] = {"pendulum", "universal", "machine"};
    const exk_geometry geo = exk_geometry_default();
    for (int i = 0; i < EXK_KIN_COUNT; i++) {
        exk_kin kin;
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, (exk_kin_model)i, EXK_WRIST_CA, &geo));
        TEST_ASSERT_EQUAL_STRING(names[i], exk_kin_name((exk_kin_model)i));
        TEST_ASSERT_EQUAL_STRING(names[i], kin.ops->name);
        TEST_ASSERT_EQUAL(EXK_WRIST_CA, kin.wrist);
        TEST_ASSERT_NOT_NULL(kin.ops->inverse);
        TEST_ASSERT_NOT_NULL(kin.ops->forward);
        TEST_ASSERT_NOT_NULL(kin.ops->legs);
    }
    TEST_ASSERT_EQUAL_STRING("unknown", exk_kin_name(EXK_KIN_COUNT));
}

/* The three models agree on the centre line and there alone (docs/kinematics.md section 0). */
static void the_models_agree_on_the_centre_line(void)
{
    const exk_geometry geo = exk_geometry_default();
    for (int i = 0; i < EXK_KIN_COUNT; i++) {
        exk_kin kin;
        const double reach_m = i == EXK_KIN_MACHINE ? geo.e_m + geo.t_m : 0.0;
        const exk_tool tool = {{0.0, 0.0, 0.9 + reach_m}, {0.0, 0.0, 1.0}};
        exk_joints joints;
        exk_tool back;
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kin, (exk_kin_model)i, EXK_WRIST_AB, &geo));
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_inverse(&kin, &tool, &joints));
        TEST_ASSERT_EQUAL_DOUBLE(0.0, joints.angle_rad[EXK_ALPHA]);
        TEST_ASSERT_EQUAL_DOUBLE(0.0, joints.angle_rad[EXK_BETA]);
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.9, joints.h_m);
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_forward(&kin, &joints, &back));
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, tool.tip_m[2], back.tip_m[2]);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(init_refuses_what_it_does_not_know);
    RUN_TEST(every_model_has_a_name_and_all_operations);
    RUN_TEST(the_models_agree_on_the_centre_line);
    return UNITY_END();
}
