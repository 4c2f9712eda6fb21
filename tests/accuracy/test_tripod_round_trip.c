/* Forward of inverse over random positions; which of them are reachable is decided by the points
 * of the plate (plate_points.h), not by the code under test. */
#include <math.h>
#include <stdio.h>

#include "exk/tripod.h"
#include "plate_points.h"
#include "uniform.h"
#include "unity.h"

enum { N_REACHABLE = 1000000 };

/* Nearer to a limit than this, rounding decides, and either answer is right. */
#define EDGE 1e-12

static exk_geometry geo;
static exk_tripod tri;

void setUp(void)
{
    geo = exk_geometry_default();
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_init(&tri, &geo));
}

void tearDown(void)
{
}

static void draw_position(uniform *u, double o1_m[3])
{
    o1_m[0] = uniform_in(u, -0.85, 0.85);
    o1_m[1] = uniform_in(u, -0.75, 0.85);
    o1_m[2] = uniform_in(u, 0.45, 1.4);
}

typedef struct {
    double legs_m, back_m, residual_m;
    int steps_cold, steps_warm;
    long n_cold, n_warm;
} worst_case;

static double most(double a, double b)
{
    return b <= a ? a : b; /* keeps a NaN */
}

static void go_and_return(const double o1_m[3], exk_tripod_pose *last, worst_case *worst)
{
    double legs_m[3], points_m[3], alpha, beta, back_m[3];
    exk_tripod_pose pose, cold, warm;
    exk_tripod_report report;
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_inverse(&tri, o1_m, &pose, legs_m));
    plate_angles(&geo, o1_m, &alpha, &beta);
    plate_legs(&geo, o1_m, alpha, beta, points_m);
    worst->legs_m = most(worst->legs_m, distance(legs_m, points_m));

    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_forward(&tri, legs_m, NULL, &cold, &report));
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_position(&tri, &cold, back_m));
    worst->back_m = most(worst->back_m, distance(o1_m, back_m));
    worst->residual_m = most(worst->residual_m, report.residual_m);
    worst->steps_cold = report.n_iter > worst->steps_cold ? report.n_iter : worst->steps_cold;
    worst->n_cold += report.n_iter;

    /* from the pose a millimetre off, and from one anywhere in the workspace */
    const exk_tripod_pose near = {pose.alpha_rad + 1e-3, pose.beta_rad - 1e-3, pose.h_m + 1e-3};
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_forward(&tri, legs_m, &near, &warm, &report));
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_position(&tri, &warm, back_m));
    worst->back_m = most(worst->back_m, distance(o1_m, back_m));
    worst->steps_warm = report.n_iter > worst->steps_warm ? report.n_iter : worst->steps_warm;
    worst->n_warm += report.n_iter;
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_forward(&tri, legs_m, last, &warm, &report));
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_position(&tri, &warm, back_m));
    worst->back_m = most(worst->back_m, distance(o1_m, back_m));
    *last = pose;
}

static void a_million_reachable_positions_return(void)
{
    uniform u = {2024};
    worst_case worst = {0};
    exk_tripod_pose last = {0.0, 0.0, 0.95};
    long n_outside = 0;
    for (long n = 0; n < N_REACHABLE;) {
        double o1_m[3];
        draw_position(&u, o1_m);
        const double room = plate_room(&geo, o1_m);
        if (room > EDGE) {
            go_and_return(o1_m, &last, &worst);
            n++;
        } else if (room < -EDGE) {
            double legs_m[3];
            const exk_err err = exk_tripod_lengths(&tri, o1_m, legs_m);
            TEST_ASSERT_TRUE(err == EXK_ERR_LIMIT || err == EXK_ERR_SINGULAR);
            n_outside++;
        }
    }
    printf("%d reachable positions: legs %.1e m from the points of the plate, back within "
           "%.1e m, residual %.1e m,\n  Newton steps cold %d at most (mean %.2f), "
           "1 mrad and 1 mm off %d (mean %.2f); %ld positions outside refused\n",
           N_REACHABLE, worst.legs_m, worst.back_m, worst.residual_m, worst.steps_cold,
           (double)worst.n_cold / N_REACHABLE, worst.steps_warm,
           (double)worst.n_warm / N_REACHABLE, n_outside);
    TEST_ASSERT_TRUE(worst.legs_m < 1e-14);
    TEST_ASSERT_TRUE(worst.back_m < 1e-10);
    TEST_ASSERT_TRUE(worst.residual_m < 1e-9);
    TEST_ASSERT_TRUE(worst.steps_cold <= EXK_TRIPOD_STEPS_MAX);
    TEST_ASSERT_TRUE(worst.steps_warm <= 3);
    TEST_ASSERT_TRUE(n_outside > 0);
}

/* Machines drawn inside the published ratios, of any size: none fails either. */
static void other_machines_return_too(void)
{
    enum { N_MACHINES = 200, N_EACH = 200 };
    uniform u = {7};
    double worst = 0.0;
    int steps = 0, n_machines = 0;
    while (n_machines < N_MACHINES) {
        const double size = exp(uniform_in(&u, log(0.2), log(20.0)));
        geo.d1_m = size;
        geo.d5_m = size / (2.0 * uniform_in(&u, 0.5, 0.8));
        geo.d2_m = size * uniform_in(&u, 0.5, 1.0);
        geo.d3_m = size * uniform_in(&u, 0.25, 0.5);
        geo.d4_m = 0.75 * geo.d3_m;
        geo.l_min_m = geo.d5_m * uniform_in(&u, 0.6, 1.2);
        geo.z0_m = geo.l_min_m + 0.5 * geo.d5_m;
        TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_init(&tri, &geo));
        n_machines++;
        for (int n = 0; n < N_EACH;) {
            const double o1_m[3] = {uniform_in(&u, -0.6, 0.6) * size,
                                    uniform_in(&u, -0.5, 0.7) * size,
                                    uniform_in(&u, 0.3, 2.0) * size};
            exk_tripod_pose pose;
            exk_tripod_report report;
            double legs_m[3], back_m[3];
            if (exk_tripod_inverse(&tri, o1_m, &pose, legs_m) != EXK_OK) {
                continue;
            }
            TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_forward(&tri, legs_m, NULL, &pose, &report));
            TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_position(&tri, &pose, back_m));
            worst = most(worst, distance(o1_m, back_m) / size);
            steps = report.n_iter > steps ? report.n_iter : steps;
            n++;
        }
    }
    printf("%d machines x %d positions: back within %.1e of d1, %d Newton steps at most\n",
           N_MACHINES, N_EACH, worst, steps);
    TEST_ASSERT_TRUE(worst < 1e-10);
    TEST_ASSERT_TRUE(steps <= EXK_TRIPOD_STEPS_MAX);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_million_reachable_positions_return);
    RUN_TEST(other_machines_return_too);
    return UNITY_END();
}
