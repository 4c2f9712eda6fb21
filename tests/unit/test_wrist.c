#include "exk/wrist.h"

#include <math.h>
#include <string.h>

#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static const struct {
    const char *name;
    exk_wrist_kind wrist;
    double tau[3];
    exk_err want;
    double t4, t5;
} rows[] = {
    {"AB, tool along w", EXK_WRIST_AB, {0.0, 0.0, 1.0}, EXK_OK, 0.0, 0.0},
    {"AB, tool toward +u", EXK_WRIST_AB, {0.6, 0.0, 0.8}, EXK_OK, 0.0, 0.64350110879328437},
    {"AB, tool toward +v", EXK_WRIST_AB, {0.0, 0.6, 0.8}, EXK_OK, -0.64350110879328437, 0.0},
    {"CA, tool toward +u",
     EXK_WRIST_CA,
     {0.6, 0.0, 0.8},
     EXK_OK,
     1.5707963267948966,
     0.64350110879328437},
    {"CA, tool toward +v",
     EXK_WRIST_CA,
     {0.0, 0.6, 0.8},
     EXK_OK,
     3.1415926535897931,
     0.64350110879328437},
    {"CA, tool along w: t4 is free", EXK_WRIST_CA, {0.0, 0.0, 1.0}, EXK_ERR_SINGULAR, 0, 0},
    {"CA, within 1e-4 rad of it", EXK_WRIST_CA, {9e-5, 0.0, 1.0}, EXK_ERR_SINGULAR, 0, 0},
    {"AB, tool along u: t4 is free", EXK_WRIST_AB, {1.0, 0.0, 0.0}, EXK_ERR_SINGULAR, 0, 0},
    {"AB, tool back at the plate", EXK_WRIST_AB, {0.6, 0.0, -0.8}, EXK_ERR_LIMIT, 0, 0},
    {"CA, tool in the plate", EXK_WRIST_CA, {0.6, 0.8, 0.0}, EXK_ERR_LIMIT, 0, 0},
    {"NaN", EXK_WRIST_AB, {0.0, (double)NAN, 1.0}, EXK_ERR_ARG, 0, 0},
    {"infinite", EXK_WRIST_CA, {0.0, 0.0, (double)INFINITY}, EXK_ERR_ARG, 0, 0},
    {"no such wrist", EXK_WRIST_COUNT, {0.0, 0.0, 1.0}, EXK_ERR_ARG, 0, 0},
};

static void each_direction_has_its_angles_or_its_refusal(void)
{
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        double angles[2] = {7.0, 7.0}, back[3];
        TEST_ASSERT_EQUAL_MESSAGE(
            rows[i].want, exk_wrist_inverse(rows[i].wrist, rows[i].tau, angles), rows[i].name);
        if (rows[i].want != EXK_OK) {
            TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(7.0, angles[0], rows[i].name);
            TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(7.0, angles[1], rows[i].name);
            continue;
        }
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-15, rows[i].t4, angles[0], rows[i].name);
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-15, rows[i].t5, angles[1], rows[i].name);
        TEST_ASSERT_EQUAL(EXK_OK, exk_wrist_forward(rows[i].wrist, angles, back));
        for (int j = 0; j < 3; j++) {
            TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-15, rows[i].tau[j], back[j], rows[i].name);
        }
    }
}

static void forward_refuses_what_is_not_finite(void)
{
    const double nan_t4[2] = {(double)NAN, 0.0}, inf_t5[2] = {0.0, (double)INFINITY};
    const double level[2] = {0.0, 0.0};
    double tau[3];
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_wrist_forward(EXK_WRIST_AB, nan_t4, tau));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_wrist_forward(EXK_WRIST_CA, inf_t5, tau));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_wrist_forward(EXK_WRIST_COUNT, level, tau));
}

static void wrists_have_names(void)
{
    TEST_ASSERT_EQUAL_STRING("AB", exk_wrist_name(EXK_WRIST_AB));
    TEST_ASSERT_EQUAL_STRING("CA", exk_wrist_name(EXK_WRIST_CA));
    TEST_ASSERT_EQUAL_STRING("unknown", exk_wrist_name(EXK_WRIST_COUNT));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(each_direction_has_its_angles_or_its_refusal);
    RUN_TEST(forward_refuses_what_is_not_finite);
    RUN_TEST(wrists_have_names);
    return UNITY_END();
}
