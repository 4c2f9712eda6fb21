/** Built-in jobs and the order in which holes are drilled.
 *
 *  rectangle  corners (-w/2,-h/2) (w/2,-h/2) (w/2,h/2) (-w/2,h/2) about the centre, ids 1 to 4.
 *  grid       rows x columns points spread over width x height, row by row from the lowest y,
 *             every second row backwards (serpentine), ids in that order from 1. A single row or
 *             column stands at the centre.
 *  serpentine a list in rows: sorted by y, a new row where y jumps by more than row_gap_m,
 *             odd rows by rising x, even rows by falling x, ties by id. Ids stay with their holes.
 *  Axis       (0, 0, 1). Units metres, base frame.
 *  Errors     EXK_ERR_ARG (size not finite or not > 0, count < 1, row_gap_m negative, a target not
 *             finite), EXK_ERR_SIZE (array too short).
 *  Memory     the caller lends the array.
 */
#ifndef EXK_JOB_H
#define EXK_JOB_H

#include <stddef.h>

#include "exk/err.h"
#include "exk/hole.h"

typedef struct {
    double width_m;     /* along X */
    double height_m;    /* along Y */
    double center_m[3]; /* of the pattern, base frame */
    int rows;           /* grid only */
    int columns;        /* grid only */
} exk_pattern;

exk_err exk_job_rectangle(const exk_pattern *pattern, exk_hole *holes, size_t capacity,
                          size_t *n_holes);
exk_err exk_job_grid(const exk_pattern *pattern, exk_hole *holes, size_t capacity,
                     size_t *n_holes);
exk_err exk_job_serpentine(exk_hole *holes, size_t n_holes, double row_gap_m);

#endif
