#include <math.h>

#include "exk/geometry.h"
#include "exk/units.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static const struct {
    const char *what;
    exk_geometry change; /* a field that is not zero replaces the default's */
    const char *name;    /* NULL: accepted */
    double value;
} rows[] = {
    {"the default machine", {.d1_m = 0.0}, NULL, 0.0},
    {"p1 on its lower bound", {.d5_m = 0.9}, NULL, 0.0},
    {"p1 on its upper bound", {.d5_m = 0.5625}, NULL, 0.0},
    {"p2 on its lower bound", {.d2_m = 0.45}, NULL, 0.0},
    {"p2 on its upper bound", {.d2_m = 0.9}, NULL, 0.0},
    {"p3 on its lower bound", {.d3_m = 0.225, .d4_m = 0.16875}, NULL, 0.0},
    {"p3 on its upper bound", {.d3_m = 0.45, .d4_m = 0.3375}, NULL, 0.0},
    {"a wrist centre aside of the plate axis", {.f_m = -0.1}, NULL, 0.0},
    {"the largest angle", {.angle_max_rad = 60.0 * EXK_RAD_PER_DEG}, NULL, 0.0},
    {"p1 too small", {.d5_m = 0.91}, "p1 = d1/(2 d5)", 0.9 / 1.82},
    {"p1 too large", {.d5_m = 0.55}, "p1 = d1/(2 d5)", 0.9 / 1.1},
    {"p2 too small", {.d2_m = 0.44}, "p2 = d2/d1", 0.44 / 0.9},
    {"p2 too large", {.d2_m = 0.91}, "p2 = d2/d1", 0.91 / 0.9},
    {"p3 too small", {.d3_m = 0.22, .d4_m = 0.165}, "p3 = 2 d3/d1", 0.44 / 0.9},
    {"p3 too large", {.d3_m = 0.46, .d4_m = 0.345}, "p3 = 2 d3/d1", 0.92 / 0.9},
    {"p4 off", {.d4_m = 0.2701}, "p4 = d4/d3", 0.2701 / 0.36},
    {"d1 negative", {.d1_m = -0.9}, "d1", -0.9},
    {"d2 NaN", {.d2_m = (double)NAN}, "d2", (double)NAN},
    {"d3 infinite", {.d3_m = (double)INFINITY}, "d3", (double)INFINITY},
    {"d4 tiny", {.d4_m = 1e-300}, "d4", 1e-300},
    {"d5 huge", {.d5_m = 1e300}, "d5", 1e300},
    {"l_min negative", {.l_min_m = -0.1}, "l_min", -0.1},
    {"z0 negative", {.z0_m = -1.0}, "z0", -1.0},
    {"e negative", {.e_m = -1e-9}, "e", -1e-9},
    {"f NaN", {.f_m = (double)NAN}, "f", (double)NAN},
    {"t huge", {.t_m = 101.0}, "t", 101.0},
    {"angle negative", {.angle_max_rad = -0.1}, "angle_max", -0.1},
    {"angle beyond 60 deg", {.angle_max_rad = 1.05}, "angle_max", 1.05},
    {"angle NaN", {.angle_max_rad = (double)NAN}, "angle_max", (double)NAN},
};

static void replace(double *field, double value)
{
    if (value != 0.0) {
        *field = value;
    }
}

static exk_geometry changed(const exk_geometry *change)
{
    exk_geometry geo = exk_geometry_default();
    replace(&geo.d1_m, change->d1_m);
    replace(&geo.d2_m, change->d2_m);
    replace(&geo.d3_m, change->d3_m);
    replace(&geo.d4_m, change->d4_m);
    replace(&geo.d5_m, change->d5_m);
    replace(&geo.l_min_m, change->l_min_m);
    replace(&geo.angle_max_rad, change->angle_max_rad);
    replace(&geo.z0_m, change->z0_m);
    replace(&geo.e_m, change->e_m);
    replace(&geo.f_m, change->f_m);
    replace(&geo.t_m, change->t_m);
    return geo;
}

static void each_row_is_judged_and_named(void)
{
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const exk_geometry geo = changed(&rows[i].change);
        exk_geometry_fault fault = {.name = "untouched"};
        const exk_err want = rows[i].name == NULL ? EXK_OK : EXK_ERR_ARG;
        TEST_ASSERT_EQUAL_MESSAGE(want, exk_geometry_check(&geo, &fault), rows[i].what);
        TEST_ASSERT_EQUAL_MESSAGE(want, exk_geometry_check(&geo, NULL), rows[i].what);
        if (want == EXK_OK) {
            TEST_ASSERT_EQUAL_STRING_MESSAGE("untouched", fault.name, rows[i].what);
            continue;
        }
        TEST_ASSERT_EQUAL_STRING_MESSAGE(rows[i].name, fault.name, rows[i].what);
        TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(rows[i].value, fault.value, rows[i].what);
        TEST_ASSERT_FALSE_MESSAGE(fault.value >= fault.min && fault.value <= fault.max,
                                  rows[i].what);
    }
}

static void zero_is_allowed_for_the_offsets_alone(void)
{
    exk_geometry geo = exk_geometry_default();
    geo.e_m = geo.t_m = geo.f_m = 0.0;
    TEST_ASSERT_EQUAL(EXK_OK, exk_geometry_check(&geo, NULL));
    geo.angle_max_rad = 0.0;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_geometry_check(&geo, NULL));
    geo = exk_geometry_default();
    geo.l_min_m = 0.0;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_geometry_check(&geo, NULL));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(each_row_is_judged_and_named);
    RUN_TEST(zero_is_allowed_for_the_offsets_alone);
    return UNITY_END();
}
