#include "exk/geometry.h"

#include <float.h>
#include <stddef.h>

#include "exk/units.h"

/* The bounds of a ratio are decimals; d1..d5 reach us rounded to binary. */
#define RATIO_SLACK 1e-9
#define ANGLE_LIMIT_RAD (60.0 * EXK_RAD_PER_DEG)

enum { N_LENGTHS = 10, N_RATIOS = 4 };

exk_geometry exk_geometry_default(void)
{
    return (exk_geometry){
        .d1_m = 0.900,
        .d2_m = 0.720,
        .d3_m = 0.360,
        .d4_m = 0.270,
        .d5_m = 0.700,
        .l_min_m = 0.650,
        .angle_max_rad = 35.0 * EXK_RAD_PER_DEG,
        .z0_m = 0.950,
        .e_m = 0.200,
        .f_m = 0.0,
        .t_m = 0.300,
    };
}

typedef struct {
    exk_geometry_fault *faults;
    size_t capacity;
    size_t n;
} fault_list;

/* Written so that a NaN value is a fault. */
static void add_faults(const exk_geometry_fault *rows, int n_rows, double slack,
                       fault_list *list)
{
    for (int i = 0; i < n_rows && list->n < list->capacity; i++) {
        if (!(rows[i].value >= rows[i].min - slack && rows[i].value <= rows[i].max + slack)) {
            list->faults[list->n++] = rows[i];
        }
    }
}

static void check_lengths(const exk_geometry *geo, fault_list *list)
{
    const exk_geometry_fault rows[N_LENGTHS + 1] = {
        {"d1", geo->d1_m, EXK_LENGTH_MIN_M, EXK_LENGTH_MAX_M},
        {"d2", geo->d2_m, EXK_LENGTH_MIN_M, EXK_LENGTH_MAX_M},
        {"d3", geo->d3_m, EXK_LENGTH_MIN_M, EXK_LENGTH_MAX_M},
        {"d4", geo->d4_m, EXK_LENGTH_MIN_M, EXK_LENGTH_MAX_M},
        {"d5", geo->d5_m, EXK_LENGTH_MIN_M, EXK_LENGTH_MAX_M},
        {"l_min", geo->l_min_m, EXK_LENGTH_MIN_M, EXK_LENGTH_MAX_M},
        {"z0", geo->z0_m, EXK_LENGTH_MIN_M, EXK_LENGTH_MAX_M},
        {"e", geo->e_m, 0.0, EXK_LENGTH_MAX_M},
        {"f", geo->f_m, -EXK_LENGTH_MAX_M, EXK_LENGTH_MAX_M},
        {"t", geo->t_m, 0.0, EXK_LENGTH_MAX_M},
        {"angle_max", geo->angle_max_rad, DBL_MIN, ANGLE_LIMIT_RAD},
    };
    add_faults(rows, N_LENGTHS + 1, 0.0, list);
}

static void check_ratios(const exk_geometry *geo, fault_list *list)
{
    const exk_geometry_fault rows[N_RATIOS] = {
        {"p1 = d1/(2 d5)", geo->d1_m / (2.0 * geo->d5_m), 0.5, 0.8},
        {"p2 = d2/d1", geo->d2_m / geo->d1_m, 0.5, 1.0},
        {"p3 = 2 d3/d1", 2.0 * geo->d3_m / geo->d1_m, 0.5, 1.0},
        {"p4 = d4/d3", geo->d4_m / geo->d3_m, 0.75, 0.75},
    };
    add_faults(rows, N_RATIOS, RATIO_SLACK, list);
}

size_t exk_geometry_faults(const exk_geometry *geo, exk_geometry_fault *faults, size_t capacity)
{
    fault_list list = {faults, capacity, 0};
    check_lengths(geo, &list);
    if (list.n == 0) {
        check_ratios(geo, &list);
    }
    return list.n;
}

exk_err exk_geometry_check(const exk_geometry *geo, exk_geometry_fault *fault)
{
    exk_geometry_fault first;
    if (exk_geometry_faults(geo, &first, 1) == 0) {
        return EXK_OK;
    }
    if (fault != NULL) {
        *fault = first;
    }
    return EXK_ERR_ARG;
}
