/* A million inputs that have no answer, each refused; random lengths, each refused or answered
 * by a pose that really has them. What is refused is known before the call. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "exk/kinematics.h"
#include "exk/tripod.h"
#include "plate_points.h"
#include "uniform.h"
#include "unity.h"

enum { N_BAD = 1000000, N_LENGTHS = 300000 };

static exk_geometry geo;
static exk_tripod tri;
static exk_kin kins[EXK_KIN_COUNT];

void setUp(void)
{
    geo = exk_geometry_default();
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_init(&tri, &geo));
    for (int i = 0; i < EXK_KIN_COUNT; i++) {
        TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&kins[i], (exk_kin_model)i, EXK_WRIST_AB, &geo));
    }
}

void tearDown(void)
{
}

/* NaN of either sign and payload, infinities, and any other bit pattern that is not finite. */
static double not_finite(uniform *u)
{
    const uint64_t bits =
        UINT64_C(0x7ff0000000000000) |
        (uniform_bits(u) & (uniform_bits(u) % 3 == 0 ? UINT64_C(0x8000000000000000)
                                                     : UINT64_C(0x800fffffffffffff)));
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* Any finite double, every exponent alike. */
static double any_finite(uniform *u)
{
    double value;
    do {
        const uint64_t bits = uniform_bits(u);
        memcpy(&value, &bits, sizeof value);
    } while (!isfinite(value));
    return value;
}

static void poison(uniform *u, double *values, int n)
{
    values[uniform_bits(u) % (uint64_t)n] = not_finite(u);
}

/* A position with no pose inside the limits, by the points of the plate alone. */
static void draw_unreachable(uniform *u, double o1_m[3])
{
    do {
        const int kind = (int)(uniform_bits(u) % 3);
        for (int i = 0; i < 3; i++) {
            o1_m[i] = kind == 0 ? any_finite(u) : uniform_in(u, -2.5, 2.5);
        }
        if (kind == 2) {
            o1_m[2] = -fabs(o1_m[2]);
        }
    } while (o1_m[2] > 0.0 && !(plate_room(&geo, o1_m) < -1e-12));
}

static void refuse_position(const double o1_m[3], bool finite)
{
    exk_tripod_pose pose;
    double legs_m[3], J[3][3];
    const exk_err err = exk_tripod_inverse(&tri, o1_m, &pose, legs_m);
    TEST_ASSERT_TRUE(finite ? err != EXK_OK && err != EXK_ERR_ARG : err == EXK_ERR_ARG);
    TEST_ASSERT_EQUAL(err, exk_tripod_lengths(&tri, o1_m, legs_m));
    TEST_ASSERT_EQUAL(err, exk_tripod_jacobian(&tri, o1_m, J));

    /* The same point as a tool tip: another plate, so beyond 3.5 m alone is known to be refused,
     * and that by the machine, whose legs are bounded. P and U have plates of any height. */
    const exk_tool tool = {{o1_m[0], o1_m[1], o1_m[2]}, {0.0, 0.0, 1.0}};
    exk_joints joints;
    for (int i = 0; i < EXK_KIN_COUNT; i++) {
        const exk_err got = exk_kin_inverse(&kins[i], &tool, &joints);
        TEST_ASSERT_EQUAL(finite, got != EXK_ERR_ARG);
        if (o1_m[2] <= 0.0 || (i == EXK_KIN_MACHINE && exk_norm3(o1_m) > 3.5)) {
            TEST_ASSERT_TRUE(got != EXK_OK);
        } else if (got == EXK_OK) {
            TEST_ASSERT_TRUE(isfinite(joints.angle_rad[0]) && isfinite(joints.angle_rad[1]) &&
                             isfinite(joints.h_m));
        }
    }
}

static void a_million_bad_positions_are_refused(void)
{
    uniform u = {11};
    for (long n = 0; n < N_BAD; n++) {
        double o1_m[3];
        draw_unreachable(&u, o1_m);
        const bool finite = n % 2 == 0;
        if (!finite) {
            poison(&u, o1_m, 3);
        }
        refuse_position(o1_m, finite);
    }
    printf("%d positions, half unreachable, half not finite: all refused\n", N_BAD);
}

static void a_million_bad_lengths_are_refused(void)
{
    uniform u = {12};
    for (long n = 0; n < N_BAD; n++) {
        double legs_m[3];
        for (int i = 0; i < 3; i++) {
            legs_m[i] = uniform_in(&u, 0.65, 1.35);
        }
        const bool finite = n % 2 == 0;
        if (finite) {
            double bad;
            do {
                bad = n % 4 == 0 ? any_finite(&u) : uniform_in(&u, -3.0, 3.0);
            } while (bad >= 0.65 && bad <= 1.35);
            legs_m[uniform_bits(&u) % 3] = bad;
        } else {
            poison(&u, legs_m, 3);
        }
        exk_tripod_pose pose;
        TEST_ASSERT_EQUAL(finite ? EXK_ERR_LIMIT : EXK_ERR_ARG,
                          exk_tripod_forward(&tri, legs_m, NULL, &pose, NULL));
    }
    printf("%d length triples outside the stroke or not finite: all refused\n", N_BAD);
}

static void random_joints_never_give_a_NaN_under_OK(void)
{
    uniform u = {13};
    for (long n = 0; n < N_BAD; n++) {
        double values[5];
        for (int i = 0; i < 5; i++) {
            values[i] = n % 3 == 0 ? any_finite(&u) : uniform_in(&u, -2.0, 2.0);
        }
        if (n % 3 == 1) {
            poison(&u, values, 3);
        }
        const exk_joints joints = {{values[0], values[1]}, values[2], {values[3], values[4]}};
        for (int i = 0; i < EXK_KIN_COUNT; i++) {
            exk_tool tool;
            double legs_m[3];
            const exk_err err = exk_kin_forward(&kins[i], &joints, &tool);
            TEST_ASSERT_EQUAL(n % 3 == 1, err == EXK_ERR_ARG);
            TEST_ASSERT_TRUE(err != EXK_OK ||
                             (exk_finite3(tool.tip_m) && exk_finite3(tool.axis)));
            TEST_ASSERT_TRUE(exk_kin_legs(&kins[i], &joints, legs_m) != EXK_OK ||
                             exk_finite3(legs_m));
        }
    }
}

/* In the stroke, most triples have their one pose beyond the angle limits or on another branch.
 * An OK must be the working branch, inside the limits, with those very lengths; and a pose that
 * exists must be found: each OK from a far start equals the cold one. */
static void an_OK_is_the_working_assembly(void)
{
    uniform u = {14};
    long count[EXK_ERR_COUNT] = {0};
    for (long n = 0; n < N_LENGTHS; n++) {
        double legs_m[3], o1_m[3], points_m[3];
        for (int i = 0; i < 3; i++) {
            legs_m[i] = uniform_in(&u, 0.65, 1.35);
        }
        const exk_tripod_pose far = {uniform_in(&u, -3.0, 3.0), uniform_in(&u, -3.0, 3.0),
                                     uniform_in(&u, 0.01, 2.0)};
        exk_tripod_pose cold, warm;
        exk_tripod_report report;
        const exk_err err = exk_tripod_forward(&tri, legs_m, NULL, &cold, &report);
        count[err]++;
        const exk_err again = exk_tripod_forward(&tri, legs_m, &far, &warm, &report);
        TEST_ASSERT_TRUE(err != EXK_OK || again == EXK_OK);
        if (again != EXK_OK) {
            continue;
        }
        TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_position(&tri, &warm, o1_m));
        TEST_ASSERT_TRUE(plate_room(&geo, o1_m) >= -1e-9);
        plate_legs(&geo, o1_m, warm.alpha_rad, warm.beta_rad, points_m);
        TEST_ASSERT_TRUE(distance(points_m, legs_m) <= 2e-9);
        TEST_ASSERT_EQUAL_MESSAGE(EXK_OK, err, "a far start found what the cold start missed");
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, cold.alpha_rad, warm.alpha_rad);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, cold.beta_rad, warm.beta_rad);
    }
    printf("%d random triples in the stroke:", N_LENGTHS);
    for (int i = 0; i < EXK_ERR_COUNT; i++) {
        if (count[i] > 0) {
            printf(" %ld %s;", count[i], exk_err_name((exk_err)i));
        }
    }
    printf("\n");
    TEST_ASSERT_TRUE(count[EXK_OK] > 0 && count[EXK_OK] < N_LENGTHS);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_million_bad_positions_are_refused);
    RUN_TEST(a_million_bad_lengths_are_refused);
    RUN_TEST(random_joints_never_give_a_NaN_under_OK);
    RUN_TEST(an_OK_is_the_working_assembly);
    return UNITY_END();
}
