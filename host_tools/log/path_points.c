#include "path_points.h"

#include <math.h>
#include <stdlib.h>

#include "exk/units.h"

enum { SPARE = 64 }; /* a judged sample opens two points; a log without its job has some too */

bool path_points_init(path_points *path, int64_t n_samples, size_t n_holes)
{
    *path = (path_points){.stretch = n_samples / PATH_POINTS_MAX + 1};
    path->capacity = (size_t)(n_samples / path->stretch) + 2 * n_holes + SPARE;
    path->points = calloc(path->capacity, sizeof *path->points);
    return path->points != NULL;
}

void path_points_free(path_points *path)
{
    free(path->points);
    path->points = NULL;
    path->n_points = path->capacity = 0;
}

static path_point point_of(const exk_wire_pose *pose)
{
    const exk_sample *s = &pose->sample;
    const exk_tool *tool = s->has_true ? &s->real : &s->est;
    double d_m[2];
    exk_plane_error(tool->tip_m, s->ref.tip_m, s->ref.axis, d_m);
    path_point p = {.time_s = 1e-6 * (double)s->time_us,
                    .radial_mm = EXK_MM_PER_M * hypot(d_m[0], d_m[1]),
                    .judged = s->judged};
    for (int i = 0; i < 3; i++) {
        p.ref_mm[i] = EXK_MM_PER_M * s->ref.tip_m[i];
        p.tip_mm[i] = EXK_MM_PER_M * tool->tip_m[i];
    }
    return p;
}

static bool is_number(const path_point *p)
{
    return isfinite(p->radial_mm) && isfinite(p->ref_mm[0]) && isfinite(p->ref_mm[1]);
}

/* Opens a new point, or replaces the newest by a worse one of its stretch; judged ones stay. */
void path_points_add(path_points *path, const exk_wire_pose *pose)
{
    const path_point p = point_of(pose);
    if (!is_number(&p)) {
        return;
    }
    path_point *newest = path->n_points > 0 ? &path->points[path->n_points - 1] : NULL;
    const bool open = newest == NULL || newest->judged || p.judged || path->in_stretch == 0;
    path->in_stretch = (path->in_stretch + 1) % path->stretch;
    path->on_true = pose->sample.has_true;
    path->worst_mm = fmax(path->worst_mm, p.radial_mm);
    if (open && path->n_points < path->capacity) {
        path->points[path->n_points++] = p;
    } else if (!open && p.radial_mm > newest->radial_mm) {
        *newest = p;
    }
}
