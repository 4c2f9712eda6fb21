/** The path of a run, thinned for a picture. Of each stretch of ticks the first sample stands for the
 *  place, so that the drawn path is as rough as the real one, and the least, mean and largest error are
 *  kept, so that nothing that happened between is hidden. Judged samples are all kept, apart.
 *
 *  Units    millimetres and seconds, base frame.
 *  Memory   the lists grow as samples come; free releases them. Without memory add does nothing more
 *           and `failed` is set.
 */
#ifndef EXK_LOG_PATH_POINTS_H
#define EXK_LOG_PATH_POINTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/wire.h"

enum { PATH_POINTS_MAX = 2000 };

typedef struct {
    double time_s;
    int32_t hole_id; /* the hole on the way to, -1 for none */
    double ref_mm[2];
    double off_mm[2]; /* tip less reference */
    double radial_mm
        [3]; /* off the reference, in the plane normal to its axis: least, mean, most */
} path_point;

typedef struct {
    path_point *at;
    size_t n;
    size_t capacity;
} path_list;

typedef struct {
    path_list path;
    path_list judged;
    int64_t stretch; /* samples that share one point */
    int64_t in_stretch;
    path_point last; /* newest sample */
    double worst_mm;
    bool on_true;
    bool failed;
} path_points;

/** n_samples: how many are expected; more are taken as well. */
void path_points_init(path_points *path, int64_t n_samples);
void path_points_add(path_points *path, const exk_wire_pose *pose);

/** After the last sample: it ends the path, whatever its place in its stretch. */
void path_points_end(path_points *path);
void path_points_free(path_points *path);

#endif
