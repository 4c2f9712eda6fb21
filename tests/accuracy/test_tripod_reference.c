/* The 200 poses of a joint-chain solver, see tests/data/README.md for their origin. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exk/tripod.h"
#include "unity.h"

enum { N_POSES = 200, N_COLUMNS = 36 };
enum { X = 1, ALPHA = 4, BETA = 5, L1 = 6, R11 = 9, B1 = 18, J11 = 27 };

static double poses[N_POSES][N_COLUMNS];
static exk_tripod tri;

static void read_row(char *line, double *row)
{
    char *cell = line;
    for (int i = 0; i < N_COLUMNS; i++) {
        char *end;
        row[i] = strtod(cell, &end);
        TEST_ASSERT_TRUE_MESSAGE(end != cell, "a cell is not a number");
        cell = end + 1;
    }
}

static void read_poses(void)
{
    static const char head[] = "id,x,y,z,alpha,beta,l1,l2,l3,R11,";
    FILE *file = fopen(EXK_TEST_DATA "/tripod_poses.csv", "r");
    TEST_ASSERT_NOT_NULL_MESSAGE(file, "tests/data/tripod_poses.csv is missing");
    char line[2048];
    int n = -1;
    while (fgets(line, sizeof line, file) != NULL) {
        if (line[0] == '#') {
            continue;
        }
        if (n < 0) {
            TEST_ASSERT_EQUAL_STRING_LEN(head, line, sizeof head - 1);
        } else {
            TEST_ASSERT_TRUE(n < N_POSES);
            read_row(line, poses[n]);
        }
        n++;
    }
    fclose(file);
    TEST_ASSERT_EQUAL(N_POSES, n);
}

void setUp(void)
{
    const exk_geometry geo = exk_geometry_default();
    TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_init(&tri, &geo));
}

void tearDown(void)
{
}

static void keep_worst(double *worst, double got, double want)
{
    const double miss = fabs(got - want);
    if (!(miss <= *worst)) {
        *worst = miss;
    }
}

static void lengths_and_angles_within_1e_12(void)
{
    double worst_m = 0.0, worst_rad = 0.0;
    for (int i = 0; i < N_POSES; i++) {
        exk_tripod_pose pose;
        double legs_m[3], lengths[3];
        TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_inverse(&tri, &poses[i][X], &pose, legs_m));
        TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_lengths(&tri, &poses[i][X], lengths));
        TEST_ASSERT_EQUAL_MEMORY(lengths, legs_m, sizeof legs_m);
        for (int j = 0; j < 3; j++) {
            keep_worst(&worst_m, legs_m[j], poses[i][L1 + j]);
        }
        keep_worst(&worst_rad, pose.alpha_rad, poses[i][ALPHA]);
        keep_worst(&worst_rad, pose.beta_rad, poses[i][BETA]);
    }
    printf("200 reference poses: lengths %.1e m, angles %.1e rad\n", worst_m, worst_rad);
    TEST_ASSERT_TRUE(worst_m <= 1e-12);
    TEST_ASSERT_TRUE(worst_rad <= 1e-12);
}

static void jacobian_within_1e_9(void)
{
    double worst = 0.0;
    for (int i = 0; i < N_POSES; i++) {
        double J[3][3];
        TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_jacobian(&tri, &poses[i][X], J));
        for (int j = 0; j < 9; j++) {
            keep_worst(&worst, J[j / 3][j % 3], poses[i][J11 + j]);
        }
    }
    printf("200 reference poses: Jacobian %.1e\n", worst);
    TEST_ASSERT_TRUE(worst <= 1e-9);
}

static void forward_returns_to_the_pose(void)
{
    double worst_m = 0.0, worst_rad = 0.0;
    int most = 0;
    for (int i = 0; i < N_POSES; i++) {
        exk_tripod_pose pose;
        exk_tripod_report report;
        double o1_m[3];
        TEST_ASSERT_EQUAL(EXK_OK,
                          exk_tripod_forward(&tri, &poses[i][L1], NULL, &pose, &report));
        TEST_ASSERT_EQUAL(EXK_OK, exk_tripod_position(&tri, &pose, o1_m));
        for (int j = 0; j < 3; j++) {
            keep_worst(&worst_m, o1_m[j], poses[i][X + j]);
        }
        keep_worst(&worst_rad, pose.alpha_rad, poses[i][ALPHA]);
        keep_worst(&worst_rad, pose.beta_rad, poses[i][BETA]);
        most = report.n_iter > most ? report.n_iter : most;
    }
    printf("200 reference poses: forward %.1e m, %.1e rad, %d steps at most\n", worst_m,
           worst_rad, most);
    TEST_ASSERT_TRUE(worst_m <= 1e-12);
    TEST_ASSERT_TRUE(worst_rad <= 1e-12);
}

int main(void)
{
    UNITY_BEGIN();
    read_poses();
    RUN_TEST(lengths_and_angles_within_1e_12);
    RUN_TEST(jacobian_within_1e_9);
    RUN_TEST(forward_returns_to_the_pose);
    return UNITY_END();
}
