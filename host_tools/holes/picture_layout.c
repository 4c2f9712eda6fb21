#include "picture_layout.h"

#include <math.h>
#include <stdlib.h>

#include "exk/units.h"
#include "picture_label.h"

static const picture_box MAP = {78.0, 900.0, 70.0, 690.0};
static const double GAP_X_PX = 58.0; /* between parts: room for the numbers of the axes */
static const double GAP_Y_PX = 34.0;
static const picture_box TARGET = {990.0, 1370.0, 310.0, 690.0};
enum { MAX_IDS = 400 }; /* of more holes none is readable */

bool picture_has_point(const exk_hole_result *result)
{
    return result->drilled && isfinite(result->dx_m) && isfinite(result->dy_m);
}

picture_point picture_hole(const hole_report *report, size_t i)
{
    const double *target_m = report->log->holes[i].target_m;
    return (picture_point){EXK_MM_PER_M * target_m[0], EXK_MM_PER_M * target_m[1]};
}

picture_point picture_tip(const hole_report *report, const picture_layout *layout, size_t i)
{
    const exk_hole_result *r = &report->results[i];
    const picture_point hole = picture_hole(report, i);
    const double scale = EXK_MM_PER_M * layout->enlarged;
    return (picture_point){hole.x_mm + scale * r->dx_m, hole.y_mm + scale * r->dy_m};
}

static double distance(picture_point a, picture_point b)
{
    return hypot(a.x_mm - b.x_mm, a.y_mm - b.y_mm);
}

static double nearest_mm(const hole_report *report, size_t i)
{
    double nearest = INFINITY;
    for (size_t j = 0; j < report->n_holes; j++) {
        const double d = distance(picture_hole(report, i), picture_hole(report, j));
        if (d > 1e-6 && d < nearest) { /* the same place twice is no neighbour */
            nearest = d;
        }
    }
    return nearest;
}

static int rising(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;
    return (x > y) - (x < y);
}

/* A spacing that three holes in four have at least; fallback for a single hole. */
static double spacing_mm(const hole_report *report, double fallback)
{
    double *d = malloc(report->n_holes * sizeof *d);
    if (d == NULL) {
        return fallback;
    }
    for (size_t i = 0; i < report->n_holes; i++) {
        d[i] = nearest_mm(report, i);
    }
    qsort(d, report->n_holes, sizeof *d, rising);
    const double spacing = d[report->n_holes / 4];
    free(d);
    return isfinite(spacing) ? spacing : fallback;
}

typedef struct {
    picture_point low;
    picture_point high;
} extent;

static void include(extent *e, picture_point p, double margin)
{
    e->low.x_mm = fmin(e->low.x_mm, p.x_mm - margin);
    e->low.y_mm = fmin(e->low.y_mm, p.y_mm - margin);
    e->high.x_mm = fmax(e->high.x_mm, p.x_mm + margin);
    e->high.y_mm = fmax(e->high.y_mm, p.y_mm + margin);
}

static extent hole_extent(const hole_report *report)
{
    const picture_point first = picture_hole(report, 0);
    extent e = {first, first};
    for (size_t i = 1; i < report->n_holes; i++) {
        include(&e, picture_hole(report, i), 0.0);
    }
    return e;
}

static double span(const extent *e)
{
    return fmax(e->high.x_mm - e->low.x_mm, e->high.y_mm - e->low.y_mm);
}

static double largest_mm(const hole_report *report)
{
    double largest = 0.0;
    for (size_t i = 0; i < report->n_holes; i++) {
        if (picture_has_point(&report->results[i])) {
            largest = fmax(largest, EXK_MM_PER_M * report->results[i].radial_m);
        }
    }
    return largest;
}

/* Two figures, rounded down: people read the number. */
static double round_down(double x)
{
    const double unit = pow(10.0, floor(log10(x)) - 1.0);
    return floor(x / unit + 1e-9) * unit;
}

/* Circles fill a third of the room between holes, unless the longest vector would then cross the
 * next hole's circle; misses of many tolerances leave of the circles a dot. */
static double choose_enlarged(const hole_report *report, double spacing, double width)
{
    const double tolerance = EXK_MM_PER_M * report->tolerance_m;
    const double worst = largest_mm(report);
    double circle = fmax(fmin(0.30 * spacing, 0.075 * width), 0.015 * width);
    const double reach = fmin(0.85 * spacing, 0.30 * width);
    if (circle * worst > reach * tolerance) {
        circle = fmax(reach * tolerance / worst, 0.002 * width);
    }
    return round_down(circle / tolerance);
}

static double pixels_wide(const picture_box *box)
{
    return box->right - box->left;
}

static double pixels_high(const picture_box *box)
{
    return box->top - box->bottom;
}

/* The extent in the middle of the box, at the scale at which all of it fits. */
static picture_view fit(const picture_box *box, const extent *e)
{
    const double w = e->high.x_mm - e->low.x_mm;
    const double h = e->high.y_mm - e->low.y_mm;
    picture_view view = {.box = *box};
    view.mm_per_px = fmax(w / pixels_wide(box), h / pixels_high(box));
    view.x_mm = 0.5 * (e->low.x_mm + e->high.x_mm - view.mm_per_px * pixels_wide(box));
    view.y_mm = 0.5 * (e->low.y_mm + e->high.y_mm - view.mm_per_px * pixels_high(box));
    return view;
}

static picture_view fit_target(const hole_report *report)
{
    const double half = 1.12 * fmax(EXK_MM_PER_M * report->tolerance_m, largest_mm(report));
    const extent e = {{-half, -half}, {half, half}};
    return fit(&TARGET, &e);
}

int picture_part(const hole_report *report, const picture_layout *layout, size_t i)
{
    const picture_point hole = picture_hole(report, i);
    const double along = (layout->along_y ? hole.y_mm : hole.x_mm) - layout->cut_mm;
    const double part = layout->part_mm > 0.0 ? floor(along / layout->part_mm) : 0.0;
    return (int)fmax(0.0, fmin(part, layout->n_maps - 1));
}

static picture_box part_box(const picture_layout *layout, int part)
{
    const double n = layout->n_maps;
    const double gap = layout->along_y ? GAP_X_PX : GAP_Y_PX;
    const double size =
        ((layout->along_y ? pixels_wide(&MAP) : pixels_high(&MAP)) - (n - 1.0) * gap) / n;
    picture_box box = MAP;
    if (layout->along_y) {
        box.left = MAP.left + part * (size + gap);
        box.right = box.left + size;
    } else {
        box.top = MAP.top - part * (size + gap);
        box.bottom = box.top - size;
    }
    return box;
}

/* Pixels per mm when the holes, each with room round it, are cut into n parts. */
static double scale_with(const extent *e, double room, bool along_y, int n)
{
    const picture_layout trial = {.n_maps = n, .along_y = along_y};
    const picture_box box = part_box(&trial, 0);
    const double w = (e->high.x_mm - e->low.x_mm) / (along_y ? 1 : n) + room;
    const double h = (e->high.y_mm - e->low.y_mm) / (along_y ? n : 1) + room;
    return fmin(pixels_wide(&box) / w, pixels_high(&box) / h);
}

/* More parts only where they make everything a good deal larger. */
static void choose_parts(const extent *e, double spacing, picture_layout *out)
{
    const double w = e->high.x_mm - e->low.x_mm;
    const double h = e->high.y_mm - e->low.y_mm;
    double best = 0.0;
    out->along_y = h > w;
    for (int n = 1; n <= PICTURE_MAX_MAPS; n++) {
        const double scale = scale_with(e, 2.0 * spacing, out->along_y, n);
        if (scale > 1.3 * best) {
            best = scale;
            out->n_maps = n;
        }
    }
    out->cut_mm = out->along_y ? e->low.y_mm : e->low.x_mm;
    out->part_mm = (out->along_y ? h : w) / out->n_maps;
}

/* What part shows: its own length of the job, its circles and points. */
static extent part_extent(const hole_report *report, const picture_layout *layout,
                          const extent *all, int part)
{
    const double circle = EXK_MM_PER_M * report->tolerance_m * layout->enlarged;
    const double begin = layout->cut_mm + part * layout->part_mm;
    extent e = *all;
    *(layout->along_y ? &e.low.y_mm : &e.low.x_mm) = begin;
    *(layout->along_y ? &e.high.y_mm : &e.high.x_mm) = begin + layout->part_mm;
    for (size_t i = 0; i < report->n_holes; i++) {
        if (picture_part(report, layout, i) != part) {
            continue;
        }
        include(&e, picture_hole(report, i), circle);
        if (picture_has_point(&report->results[i])) {
            include(&e, picture_tip(report, layout, i), 0.0);
        }
    }
    const double border = 0.05 * span(&e);
    include(&e, e.low, border);
    include(&e, e.high, border);
    return e;
}

/* Every part at the scale of the one that needs most room. */
static void fit_parts(const hole_report *report, const extent *all, picture_layout *out)
{
    extent e[PICTURE_MAX_MAPS];
    picture_point largest = {0.0, 0.0};
    for (int part = 0; part < out->n_maps; part++) {
        e[part] = part_extent(report, out, all, part);
        largest.x_mm = fmax(largest.x_mm, e[part].high.x_mm - e[part].low.x_mm);
        largest.y_mm = fmax(largest.y_mm, e[part].high.y_mm - e[part].low.y_mm);
    }
    for (int part = 0; part < out->n_maps; part++) {
        const picture_box box = part_box(out, part);
        const picture_point more = {
            0.5 * (largest.x_mm - (e[part].high.x_mm - e[part].low.x_mm)),
            0.5 * (largest.y_mm - (e[part].high.y_mm - e[part].low.y_mm))};
        e[part].low =
            (picture_point){e[part].low.x_mm - more.x_mm, e[part].low.y_mm - more.y_mm};
        e[part].high =
            (picture_point){e[part].high.x_mm + more.x_mm, e[part].high.y_mm + more.y_mm};
        out->map[part] = fit(&box, &e[part]);
    }
}

void picture_layout_make(const hole_report *report, picture_layout *out)
{
    const extent all = hole_extent(report);
    const double width = span(&all) > 0.0 ? span(&all) : 20.0;
    const double spacing = spacing_mm(report, width);
    choose_parts(&all, spacing, out);
    out->enlarged = choose_enlarged(report, spacing, width / out->n_maps);
    fit_parts(report, &all, out);
    out->target = fit_target(report);
    out->ids = NULL;
    if (report->n_holes <= MAX_IDS) {
        picture_ids_place(report, out);
    }
}

void picture_layout_free(picture_layout *layout)
{
    free(layout->ids);
    layout->ids = NULL;
}
