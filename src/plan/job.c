#include "exk/job.h"

#include <math.h>
#include <stdbool.h>

#include "exk/axes.h"
#include "exk/vec3.h"

static exk_hole hole_at(const exk_pattern *pattern, int32_t id, double dx_m, double dy_m)
{
    exk_hole hole = {.id = id, .axis = {0.0, 0.0, 1.0}};
    hole.target_m[EXK_X] = pattern->center_m[EXK_X] + dx_m;
    hole.target_m[EXK_Y] = pattern->center_m[EXK_Y] + dy_m;
    hole.target_m[EXK_Z] = pattern->center_m[EXK_Z];
    return hole;
}

static bool size_is_good(const exk_pattern *pattern)
{
    return pattern->width_m > 0.0 && isfinite(pattern->width_m) && pattern->height_m > 0.0 &&
           isfinite(pattern->height_m) && exk_finite3(pattern->center_m);
}

exk_err exk_job_rectangle(const exk_pattern *pattern, exk_hole *holes, size_t capacity,
                          size_t *n_holes)
{
    if (!size_is_good(pattern)) {
        return EXK_ERR_ARG;
    }
    if (capacity < 4) {
        return EXK_ERR_SIZE;
    }
    const double w = 0.5 * pattern->width_m;
    const double h = 0.5 * pattern->height_m;
    holes[0] = hole_at(pattern, 1, -w, -h);
    holes[1] = hole_at(pattern, 2, w, -h);
    holes[2] = hole_at(pattern, 3, w, h);
    holes[3] = hole_at(pattern, 4, -w, h);
    *n_holes = 4;
    return EXK_OK;
}

/* Offset of place i of n over a length about its centre; a single place stands at the centre. */
static double spread(double length_m, int i, int n)
{
    return n == 1 ? 0.0 : length_m * ((double)i / (double)(n - 1) - 0.5);
}

exk_err exk_job_grid(const exk_pattern *pattern, exk_hole *holes, size_t capacity,
                     size_t *n_holes)
{
    const int rows = pattern->rows;
    const int columns = pattern->columns;
    if (!size_is_good(pattern) || rows < 1 || columns < 1) {
        return EXK_ERR_ARG;
    }
    if ((size_t)rows > capacity / (size_t)columns) {
        return EXK_ERR_SIZE;
    }
    size_t n = 0;
    for (int row = 0; row < rows; row++) {
        for (int i = 0; i < columns; i++) {
            const int column = row % 2 == 0 ? i : columns - 1 - i;
            holes[n] =
                hole_at(pattern, (int32_t)(n + 1), spread(pattern->width_m, column, columns),
                        spread(pattern->height_m, row, rows));
            n++;
        }
    }
    *n_holes = n;
    return EXK_OK;
}

/* What a sort compares: sign * coordinate, then the id, so that the order is total. */
typedef struct {
    int axis;
    double sign;
} sort_key;

static bool comes_before(const exk_hole *a, const exk_hole *b, sort_key key)
{
    const double va = key.sign * a->target_m[key.axis];
    const double vb = key.sign * b->target_m[key.axis];
    return va < vb || (va == vb && a->id < b->id);
}

/* Shell sort: in place and without heap, which the library's qsort does not promise. */
static void sort_holes(exk_hole *holes, size_t n, sort_key key)
{
    for (size_t gap = n / 2; gap > 0; gap /= 2) {
        for (size_t i = gap; i < n; i++) {
            const exk_hole moving = holes[i];
            size_t j = i;
            for (; j >= gap && comes_before(&moving, &holes[j - gap], key); j -= gap) {
                holes[j] = holes[j - gap];
            }
            holes[j] = moving;
        }
    }
}

static size_t row_end(const exk_hole *holes, size_t begin, size_t n, double row_gap_m)
{
    size_t end = begin + 1;
    while (end < n &&
           holes[end].target_m[EXK_Y] - holes[end - 1].target_m[EXK_Y] <= row_gap_m) {
        end++;
    }
    return end;
}

exk_err exk_job_serpentine(exk_hole *holes, size_t n_holes, double row_gap_m)
{
    if (!(row_gap_m >= 0.0) || !isfinite(row_gap_m)) {
        return EXK_ERR_ARG;
    }
    for (size_t i = 0; i < n_holes; i++) {
        if (!exk_finite3(holes[i].target_m)) {
            return EXK_ERR_ARG;
        }
    }
    sort_holes(holes, n_holes, (sort_key){EXK_Y, 1.0});
    double sign = 1.0;
    for (size_t begin = 0; begin < n_holes; sign = -sign) {
        const size_t end = row_end(holes, begin, n_holes, row_gap_m);
        sort_holes(holes + begin, end - begin, (sort_key){EXK_X, sign});
        begin = end;
    }
    return EXK_OK;
}
