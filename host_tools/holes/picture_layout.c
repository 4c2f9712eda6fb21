#include "picture_layout.h"

#include <math.h>
#include <stdlib.h>

#include "exk/units.h"
#include "picture_label.h"

static const picture_box MAP = {78.0, 900.0, 70.0, 690.0};
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

void picture_layout_make(const hole_report *report, picture_layout *out)
{
    extent e = hole_extent(report);
    const double alone = span(&e) > 0.0 ? span(&e) : 20.0;
    const double spacing = spacing_mm(report, alone);
    out->enlarged = choose_enlarged(report, spacing, alone);
    const double circle = EXK_MM_PER_M * report->tolerance_m * out->enlarged;
    for (size_t i = 0; i < report->n_holes; i++) {
        include(&e, picture_hole(report, i), circle);
        if (picture_has_point(&report->results[i])) {
            include(&e, picture_tip(report, out, i), 0.0);
        }
    }
    const double border = 0.05 * span(&e);
    include(&e, e.low, border);
    include(&e, e.high, border);
    out->map = fit(&MAP, &e);
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
