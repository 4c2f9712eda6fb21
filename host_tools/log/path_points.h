/** The path of a run, thinned for a picture: in each stretch of ticks the sample that is furthest off
 *  is kept, so that the largest error of the run is in the picture whatever its length.
 *
 *  Units    millimetres and seconds, base frame.
 *  Memory   path_points_init allocates for the number of samples expected; free releases.
 */
#ifndef EXK_LOG_PATH_POINTS_H
#define EXK_LOG_PATH_POINTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/wire.h"

enum { PATH_POINTS_MAX = 4000 };

typedef struct {
    double time_s;
    double ref_mm[3];
    double tip_mm[3];
    double radial_mm; /* off the reference, in the plane normal to its axis */
    bool judged;
} path_point;

typedef struct {
    path_point *points;
    size_t n_points;
    size_t capacity;
    int64_t stretch; /* samples that share one point */
    int64_t in_stretch;
    double worst_mm;
    bool on_true;
} path_points;

bool path_points_init(path_points *path, int64_t n_samples, size_t n_holes);
void path_points_add(path_points *path, const exk_wire_pose *pose);
void path_points_free(path_points *path);

#endif
