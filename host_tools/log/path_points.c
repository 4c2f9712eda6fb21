#include "path_points.h"

#include <math.h>
#include <stdlib.h>

#include "exk/units.h"

enum { LEAST, MEAN, MOST };

void path_points_init(path_points *path, int64_t n_samples)
{
    *path = (path_points){.stretch = n_samples / PATH_POINTS_MAX + 1};
}

void path_points_free(path_points *path)
{
    free(path->path.at);
    free(path->judged.at);
    *path = (path_points){.stretch = 1};
}

static bool push(path_list *list, const path_point *p)
{
    if (list->n == list->capacity) {
        const size_t wider = list->capacity > 0 ? 2 * list->capacity : 256;
        path_point *at = realloc(list->at, wider * sizeof *at);
        if (at == NULL) {
            return false;
        }
        list->at = at;
        list->capacity = wider;
    }
    list->at[list->n++] = *p;
    return true;
}

static path_point point_of(const exk_wire_pose *pose)
{
    const exk_sample *s = &pose->sample;
    const exk_tool *tool = s->has_true ? &s->real : &s->est;
    double d_m[2];
    exk_plane_error(tool->tip_m, s->ref.tip_m, s->ref.axis, d_m);
    const double radial_mm = EXK_MM_PER_M * hypot(d_m[0], d_m[1]);
    path_point p = {.time_s = 1e-6 * (double)s->time_us,
                    .hole_id = s->hole_id,
                    .radial_mm = {radial_mm, radial_mm, radial_mm}};
    for (int i = 0; i < 2; i++) {
        p.ref_mm[i] = EXK_MM_PER_M * s->ref.tip_m[i];
        p.off_mm[i] = EXK_MM_PER_M * (tool->tip_m[i] - s->ref.tip_m[i]);
    }
    return p;
}

static bool is_number(const path_point *p)
{
    return isfinite(p->radial_mm[MEAN]) && isfinite(p->ref_mm[0]) && isfinite(p->ref_mm[1]) &&
           isfinite(p->off_mm[0]) && isfinite(p->off_mm[1]);
}

/* The n-th sample of a stretch joins its point. */
static void join(path_point *point, double radial_mm, int64_t n)
{
    point->radial_mm[LEAST] = fmin(point->radial_mm[LEAST], radial_mm);
    point->radial_mm[MEAN] += (radial_mm - point->radial_mm[MEAN]) / (double)n;
    point->radial_mm[MOST] = fmax(point->radial_mm[MOST], radial_mm);
}

void path_points_add(path_points *path, const exk_wire_pose *pose)
{
    const path_point p = point_of(pose);
    if (!is_number(&p) || path->failed) {
        return;
    }
    bool ok = true;
    if (path->in_stretch == 0) {
        ok = push(&path->path, &p);
    } else {
        join(&path->path.at[path->path.n - 1], p.radial_mm[MEAN], path->in_stretch + 1);
    }
    if (pose->sample.judged) {
        ok = push(&path->judged, &p) && ok;
    }
    path->failed = !ok;
    path->in_stretch = (path->in_stretch + 1) % path->stretch;
    path->last = p;
    path->on_true = pose->sample.has_true;
    path->worst_mm = fmax(path->worst_mm, p.radial_mm[MEAN]);
}

void path_points_end(path_points *path)
{
    const bool is_there = path->stretch == 1 || path->in_stretch == 1;
    if (path->path.n > 0 && !is_there && !path->failed) {
        path->failed = !push(&path->path, &path->last);
    }
    path->in_stretch = 0;
}
