#include "exk/tripod.h"

#include <math.h>
#include <string.h>

#include "exk/units.h"
#include "unity.h"

static exk_tripod tri;

void setUp(void)
{
    const exk_geometry geo = exk_geometry_default();
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_init(&tri, &geo));
}

void tearDown(void)
{
}

static void init_refuses_a_bad_geometry(void)
{
    exk_geometry geo = exk_geometry_default();
    geo.d3_m = 0.5;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_tripod_init(&tri, &geo));
}

static const struct {
    const char *name;
    double o1_m[3];
    exk_err want;
} position_rows[] = {
    {"home", {0.0, 0.0, 0.95}, EXK_OK},
    {"corner of the usable area", {0.36, -0.25, 0.95}, EXK_OK},
    {"leg 1 too long", {0.5, 0.0, 1.1}, EXK_ERR_LIMIT},
    {"legs 1 and 3 too short", {0.0, 0.0, 0.55}, EXK_ERR_LIMIT},
    {"alpha beyond 35 deg", {0.66, 0.0, 0.9}, EXK_ERR_LIMIT},
    {"beta beyond 35 deg", {0.0, 0.72, 0.9}, EXK_ERR_LIMIT},
    {"alpha beyond 90 deg, so beyond the singular surface", {0.3, 0.7, 0.2}, EXK_ERR_SINGULAR},
    {"beyond the singular surface, negative beta", {0.85, -0.06, 0.21}, EXK_ERR_SINGULAR},
    {"h = 0: O1 on the line through A2 along v", {0.0, 0.36, 0.36}, EXK_ERR_SINGULAR},
    {"r = 0: O1 on the X axis", {0.2, 0.0, 0.0}, EXK_ERR_SINGULAR},
    {"behind the base", {0.0, 0.0, -0.95}, EXK_ERR_UNREACHABLE},
    {"in the base plane", {0.0, 0.9, 0.0}, EXK_ERR_UNREACHABLE},
    {"farther than any leg", {0.0, 0.0, 2.1}, EXK_ERR_UNREACHABLE},
    {"a square that overflows", {1e200, 0.0, 0.95}, EXK_ERR_UNREACHABLE},
    {"NaN x", {(double)NAN, 0.0, 0.95}, EXK_ERR_ARG},
    {"NaN z", {0.0, 0.0, (double)NAN}, EXK_ERR_ARG},
    {"infinite y", {0.0, (double)-INFINITY, 0.95}, EXK_ERR_ARG},
};

static void position_calls_tell_their_refusals_apart(void)
{
    for (size_t i = 0; i < sizeof position_rows / sizeof position_rows[0]; i++) {
        const char *name = position_rows[i].name;
        const double *o1_m = position_rows[i].o1_m;
        const exk_err want = position_rows[i].want;
        double lengths[3] = {7.0, 7.0, 7.0}, legs_m[3] = {7.0, 7.0, 7.0}, J[3][3];
        exk_tripod_pose pose = {7.0, 7.0, 7.0};
        TEST_ASSERT_EQUAL_MESSAGE(want, exk_tripod_lengths(&tri, o1_m, lengths), name);
        TEST_ASSERT_EQUAL_MESSAGE(want, exk_tripod_inverse(&tri, o1_m, &pose, legs_m), name);
        TEST_ASSERT_EQUAL_MESSAGE(want, exk_tripod_jacobian(&tri, o1_m, J), name);
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(lengths, legs_m, sizeof legs_m, name);
        TEST_ASSERT_EQUAL_MESSAGE(want != EXK_OK, legs_m[0] == 7.0 && pose.h_m == 7.0, name);
    }
}

static const struct {
    const char *name;
    exk_tripod_pose pose;
    exk_err want;     /* of legs and the Jacobian */
    exk_err position; /* of position and the passive joints, which check no limit */
} pose_rows[] = {
    {"home", {0.0, 0.0, 0.95}, EXK_OK, EXK_OK},
    {"angle beyond the limit", {0.62, 0.0, 0.95}, EXK_ERR_LIMIT, EXK_OK},
    {"leg beyond the stroke", {0.0, 0.0, 1.4}, EXK_ERR_LIMIT, EXK_OK},
    {"beyond the singular surface", {1.1, -0.3, 0.95}, EXK_ERR_SINGULAR, EXK_OK},
    {"r below zero", {0.0, -1.0, 0.5}, EXK_ERR_UNREACHABLE, EXK_ERR_UNREACHABLE},
    {"h below zero", {0.0, 0.0, -0.95}, EXK_ERR_UNREACHABLE, EXK_ERR_UNREACHABLE},
    {"h that overflows", {0.0, 0.0, 1e200}, EXK_ERR_UNREACHABLE, EXK_ERR_UNREACHABLE},
    {"a turn too far", {2.0 * EXK_PI, 0.0, 0.95}, EXK_ERR_UNREACHABLE, EXK_ERR_UNREACHABLE},
    {"NaN beta", {0.0, (double)NAN, 0.95}, EXK_ERR_ARG, EXK_ERR_ARG},
    {"infinite h", {0.0, 0.0, (double)INFINITY}, EXK_ERR_ARG, EXK_ERR_ARG},
};

static void pose_calls_tell_their_refusals_apart(void)
{
    for (size_t i = 0; i < sizeof pose_rows / sizeof pose_rows[0]; i++) {
        const char *name = pose_rows[i].name;
        const exk_tripod_pose *pose = &pose_rows[i].pose;
        double legs_m[3], o1_m[3], J[3][3];
        exk_tripod_passive passive;
        TEST_ASSERT_EQUAL_MESSAGE(pose_rows[i].want, exk_tripod_legs(&tri, pose, legs_m), name);
        TEST_ASSERT_EQUAL_MESSAGE(pose_rows[i].want, exk_tripod_jacobian_pose(&tri, pose, J),
                                  name);
        TEST_ASSERT_EQUAL_MESSAGE(pose_rows[i].position, exk_tripod_position(&tri, pose, o1_m),
                                  name);
        TEST_ASSERT_EQUAL_MESSAGE(pose_rows[i].position,
                                  exk_tripod_passive_joints(&tri, pose, &passive), name);
    }
}

static const struct {
    const char *name;
    double legs_m[3];
    exk_err want;
} length_rows[] = {
    {"home", {0.987623410, 1.051189802, 0.987623410}, EXK_OK},
    {"a leg beyond the stroke", {1.36, 1.0, 1.0}, EXK_ERR_LIMIT},
    {"a leg too short", {1.0, 0.64, 1.0}, EXK_ERR_LIMIT},
    {"a negative leg", {1.0, 1.0, -1.0}, EXK_ERR_LIMIT},
    {"in the stroke, alpha beyond its limit", {1.34, 1.1, 0.7}, EXK_ERR_LIMIT},
    {"NaN", {1.0, (double)NAN, 1.0}, EXK_ERR_ARG},
    {"infinite", {(double)INFINITY, 1.0, 1.0}, EXK_ERR_ARG},
};

static void the_forward_solver_tells_its_refusals_apart(void)
{
    for (size_t i = 0; i < sizeof length_rows / sizeof length_rows[0]; i++) {
        exk_tripod_pose pose = {7.0, 7.0, 7.0};
        exk_tripod_report report;
        const exk_err got =
            exk_tripod_forward(&tri, length_rows[i].legs_m, NULL, &pose, &report);
        TEST_ASSERT_EQUAL_MESSAGE(length_rows[i].want, got, length_rows[i].name);
        TEST_ASSERT_EQUAL_MESSAGE(got != EXK_OK, pose.h_m == 7.0, length_rows[i].name);
        TEST_ASSERT_EQUAL(got,
                          exk_tripod_forward(&tri, length_rows[i].legs_m, NULL, &pose, NULL));
    }
}

static void the_report_says_what_was_done(void)
{
    const double legs_m[3] = {0.987623410, 1.051189802, 0.987623410};
    const exk_tripod_pose home = {0.0, 0.0, 0.95};
    exk_tripod_pose pose;
    exk_tripod_report report;
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_forward(&tri, legs_m, &home, &pose, &report));
    TEST_ASSERT_EQUAL(0, report.cold);
    TEST_ASSERT_INT_WITHIN(1, 1, report.n_iter);
    TEST_ASSERT_TRUE(report.residual_m <= 1e-12);

    const double beyond_m[3] = {2.0, 1.0, 1.0};
    TEST_ASSERT_EQUAL(EXK_ERR_LIMIT, exk_tripod_forward(&tri, beyond_m, &home, &pose, &report));
    TEST_ASSERT_EQUAL(0, report.n_iter);
    TEST_ASSERT_TRUE(isinf(report.residual_m));
}

/* A start of another branch, of no branch, or not a number must not reach the answer. */
static void a_bad_start_gives_the_same_pose(void)
{
    static const exk_tripod_pose starts[] = {
        {(double)NAN, 0.0, 0.95}, {0.0, (double)INFINITY, 0.95},
        {0.0, 0.0, -0.95},        {0.0, 0.0, (double)NAN},
        {EXK_PI, 0.0, 0.95},      {0.0, EXK_PI, 0.95},
        {1.4, -1.4, 0.1},         {2.0 * EXK_PI, 0.0, 0.95},
        {-3.0, 2.0, 50.0},        {0.0, 0.0, 1e-12},
        {1e6, -1e6, 99.0},        {0.5, -0.6, 0.4},
        {0.0, 0.0, 101.0},
    };
    const double o1_m[3] = {0.2, -0.15, 0.9};
    exk_tripod_pose want, pose;
    double legs_m[3];
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_inverse(&tri, o1_m, &want, legs_m));
    for (size_t i = 0; i < sizeof starts / sizeof starts[0]; i++) {
        exk_tripod_report report;
        TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_forward(&tri, legs_m, &starts[i], &pose, &report));
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, want.alpha_rad, pose.alpha_rad);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, want.beta_rad, pose.beta_rad);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, want.h_m, pose.h_m);
    }
}

/* docs/kinematics.md section 6.2 prints six decimals; section 1 gives nine. */
static void home_comes_out_as_published(void)
{
    static const double want[3][3] = {
        {0.455639, 0.0, 0.961905}, {0.0, -0.684938, 0.903738}, {-0.455639, 0.0, 0.961905}};
    const double home_m[3] = {0.0, 0.0, 0.95};
    double legs_m[3], J[3][3];
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_lengths(&tri, home_m, legs_m));
    TEST_ASSERT_DOUBLE_WITHIN(5e-10, 0.987623410, legs_m[0]);
    TEST_ASSERT_DOUBLE_WITHIN(5e-10, 1.051189802, legs_m[1]);
    TEST_ASSERT_DOUBLE_WITHIN(5e-10, 0.987623410, legs_m[2]);
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_jacobian(&tri, home_m, J));
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(5e-7, want[i / 3][i % 3], J[i / 3][i % 3]);
    }
    const double det = J[0][0] * (J[1][1] * J[2][2] - J[1][2] * J[2][1]) -
                       J[0][1] * (J[1][0] * J[2][2] - J[1][2] * J[2][0]) +
                       J[0][2] * (J[1][0] * J[2][1] - J[1][1] * J[2][0]);
    TEST_ASSERT_DOUBLE_WITHIN(5e-7, -0.600392, det);
}

/* Section 6.3: a d2 h^3 at home; zero at |tan(alpha)| = h/b for beta = 0, and nearer in for
 * negative beta (68, 58.5, 50.5, 44 deg, printed to half a degree). */
static void G_changes_sign_where_published(void)
{
    const exk_tripod_pose home = {0.0, 0.0, 0.95};
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.45 * 0.72 * 0.95 * 0.95 * 0.95,
                              exk_tripod_G(&tri, &home));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1.0, exk_tripod_margin(&tri, &home));
    const double edge = atan(0.95 / 0.18);
    static const struct {
        double beta_deg, alpha_deg, within_deg;
    } zeros[] = {
        {-10.0, 68.0, 0.5}, {-20.0, 58.5, 0.5}, {-30.0, 50.5, 0.5}, {-40.0, 44.0, 0.5}};
    TEST_ASSERT_TRUE(exk_tripod_G(&tri, &(exk_tripod_pose){edge - 1e-6, 0.0, 0.95}) > 0.0);
    TEST_ASSERT_TRUE(exk_tripod_G(&tri, &(exk_tripod_pose){edge + 1e-6, 0.0, 0.95}) < 0.0);
    for (size_t i = 0; i < sizeof zeros / sizeof zeros[0]; i++) {
        const double beta = zeros[i].beta_deg * EXK_RAD_PER_DEG;
        const double in = (zeros[i].alpha_deg - zeros[i].within_deg) * EXK_RAD_PER_DEG;
        const double out = (zeros[i].alpha_deg + zeros[i].within_deg) * EXK_RAD_PER_DEG;
        TEST_ASSERT_TRUE(exk_tripod_G(&tri, &(exk_tripod_pose){in, beta, 0.95}) > 0.0);
        TEST_ASSERT_TRUE(exk_tripod_G(&tri, &(exk_tripod_pose){-out, beta, 0.95}) < 0.0);
    }
    TEST_ASSERT_TRUE(isnan(exk_tripod_G(&tri, &(exk_tripod_pose){0.0, (double)NAN, 0.95})));
}

/* det dl/d(alpha, beta, h) = -2 G/(l1 l2 l3), an identity. */
static void the_determinant_is_G(void)
{
    for (double alpha = -0.5; alpha <= 0.5; alpha += 0.25) {
        for (double beta = -0.4; beta <= 0.4; beta += 0.2) {
            const exk_tripod_pose pose = {alpha, beta, 0.9};
            double J[3][3], legs_m[3];
            if (exk_tripod_legs(&tri, &pose, legs_m) != EXK_OK) {
                continue;
            }
            TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_jacobian_pose(&tri, &pose, J));
            const double det = J[0][0] * (J[1][1] * J[2][2] - J[1][2] * J[2][1]) -
                               J[0][1] * (J[1][0] * J[2][2] - J[1][2] * J[2][0]) +
                               J[0][2] * (J[1][0] * J[2][1] - J[1][1] * J[2][0]);
            const double want =
                -2.0 * exk_tripod_G(&tri, &pose) / (legs_m[0] * legs_m[1] * legs_m[2]);
            TEST_ASSERT_DOUBLE_WITHIN(1e-13, want, det);
        }
    }
}

/* Section 7: the U and R angles place B1 and B3; leg 2 is seen along Y. */
static void passive_joints_rebuild_the_legs(void)
{
    const exk_tripod_pose pose = {0.25, -0.2, 0.95};
    const double sa = sin(0.25), ca = cos(0.25), sb = sin(-0.2), cb = cos(-0.2);
    exk_tripod_passive p;
    double legs_m[3], o1_m[3];
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_passive_joints(&tri, &pose, &p));
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_legs(&tri, &pose, legs_m));
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_position(&tri, &pose, o1_m));
    const double r = o1_m[2] / cb;
    TEST_ASSERT_EQUAL_DOUBLE(0.2, p.u_first_rad);
    TEST_ASSERT_DOUBLE_WITHIN(1e-14, o1_m[0] - 0.18 * ca,
                              -0.45 + legs_m[0] * sin(p.u1_second_rad));
    TEST_ASSERT_DOUBLE_WITHIN(1e-14, r + 0.18 * sa, legs_m[0] * cos(p.u1_second_rad));
    TEST_ASSERT_DOUBLE_WITHIN(1e-14, o1_m[0] + 0.18 * ca,
                              0.45 + legs_m[2] * sin(p.u3_second_rad));
    TEST_ASSERT_DOUBLE_WITHIN(1e-14, r - 0.18 * sa, legs_m[2] * cos(p.u3_second_rad));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.25, p.u1_second_rad + p.b1_rad);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.25, p.u3_second_rad + p.b3_rad);
    const double b2z_m = o1_m[2] - 0.27 * sb; /* B2 = O1 + d4 v, A2 in the base plane */
    TEST_ASSERT_DOUBLE_WITHIN(1e-14, atan2(o1_m[0], b2z_m), p.leg2_x_rad);
}

/* Section 10, T: at constant r, equal angles move y more than x. */
static void model_T_moves_y_more_for_positive_angles(void)
{
    const double r = 0.95, alpha = 0.1, beta = 0.1;
    const double h = (r - 0.72 * sin(beta)) / cos(alpha);
    const exk_tripod_pose pose = {alpha, beta, h};
    double o1_m[3];
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_position(&tri, &pose, o1_m));
    TEST_ASSERT_DOUBLE_WITHIN(5e-5, 0.0881, o1_m[0]);
    TEST_ASSERT_DOUBLE_WITHIN(5e-5, 0.0948, o1_m[1]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, r, hypot(o1_m[1], o1_m[2]));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(init_refuses_a_bad_geometry);
    RUN_TEST(position_calls_tell_their_refusals_apart);
    RUN_TEST(pose_calls_tell_their_refusals_apart);
    RUN_TEST(the_forward_solver_tells_its_refusals_apart);
    RUN_TEST(the_report_says_what_was_done);
    RUN_TEST(a_bad_start_gives_the_same_pose);
    RUN_TEST(home_comes_out_as_published);
    RUN_TEST(G_changes_sign_where_published);
    RUN_TEST(the_determinant_is_G);
    RUN_TEST(passive_joints_rebuild_the_legs);
    RUN_TEST(model_T_moves_y_more_for_positive_angles);
    return UNITY_END();
}
