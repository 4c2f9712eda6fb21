#include "picture_label.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "exk/units.h"

static const double ID_GAP_PX = 10.0;
static const double DIGIT_PX = 6.6;    /* width of a digit of an id */
static const double ID_COST_MAX = 4.0; /* dearer places cover something: no id there */
static const double POINT_PX = 9.0;    /* room that a mark takes on each side */

static double circle_mm(const hole_report *report, const picture_layout *layout)
{
    return EXK_MM_PER_M * report->tolerance_m * layout->enlarged;
}

/* A label being placed: its centre and half size, in mm of the view. */
typedef struct {
    picture_point at;
    double half_w;
    double half_h;
} placed;

static double covers(const placed *label, picture_point p, double margin)
{
    const bool inside = fabs(p.x_mm - label->at.x_mm) <= label->half_w + margin &&
                        fabs(p.y_mm - label->at.y_mm) <= label->half_h + margin;
    return inside ? 1.0 : 0.0;
}

static double out_of_view(const placed *label, const picture_view *view)
{
    const double right = view->x_mm + view->mm_per_px * (view->box.right - view->box.left);
    const double top = view->y_mm + view->mm_per_px * (view->box.top - view->box.bottom);
    const bool fits = label->at.x_mm - label->half_w >= view->x_mm &&
                      label->at.x_mm + label->half_w <= right &&
                      label->at.y_mm - label->half_h >= view->y_mm &&
                      label->at.y_mm + label->half_h <= top;
    return fits ? 0.0 : 1e6;
}

static double circle_cost(const placed *label, picture_point centre, double radius)
{
    double cost = covers(label, centre, 0.0);
    for (int j = 0; j < 16; j++) {
        const double turn = 2.0 * EXK_PI * j / 16.0;
        const picture_point on = {centre.x_mm + radius * cos(turn),
                                  centre.y_mm + radius * sin(turn)};
        cost += 0.3 * covers(label, on, 0.0);
    }
    return cost;
}

/* Error vector and point of one hole. */
static double vector_cost(const hole_report *report, const picture_layout *layout,
                          const placed *label, size_t i)
{
    const double margin = POINT_PX * layout->map[0].mm_per_px;
    const picture_point hole = picture_hole(report, i);
    double cost = 0.0;
    if (!picture_has_point(&report->results[i])) {
        return 8.0 * covers(label, hole, margin);
    }
    const picture_point tip = picture_tip(report, layout, i);
    for (int j = 1; j <= 8; j++) {
        const double f = j / 8.0;
        const picture_point on = {hole.x_mm + f * (tip.x_mm - hole.x_mm),
                                  hole.y_mm + f * (tip.y_mm - hole.y_mm)};
        cost += (j == 8 ? 8.0 : 1.0) * covers(label, on, margin);
    }
    return cost;
}

/* What the label would cover of one hole on the map: circle, vector and point, id. */
static double map_cost(const hole_report *report, const picture_layout *layout,
                       const placed *label, size_t i)
{
    const picture_point hole = picture_hole(report, i);
    double cost = circle_cost(label, hole, circle_mm(report, layout)) +
                  vector_cost(report, layout, label, i);
    if (layout->ids != NULL) {
        cost += 3.0 * covers(label, layout->ids[i], 9.0 * layout->map[0].mm_per_px);
    }
    return cost;
}

/* Half the width of an id on the map, mm. */
static double id_half_mm(const hole_report *report, const picture_layout *layout, size_t i)
{
    const int32_t id = report->log->holes[i].id;
    const int digits = snprintf(NULL, 0, "%" PRId32, id);
    return 0.5 * DIGIT_PX * digits * layout->map[0].mm_per_px;
}

/* Would the ids of holes i, at label, and j, already placed, touch? */
static bool ids_touch(const hole_report *report, const picture_layout *layout,
                      const placed *label, picture_point other, size_t j)
{
    const double px = layout->map[0].mm_per_px;
    const double room = label->half_w + id_half_mm(report, layout, j) + 4.0 * px;
    return fabs(other.x_mm - label->at.x_mm) < room &&
           fabs(other.y_mm - label->at.y_mm) < 2.0 * label->half_h;
}

/* What an id would cover: vectors, circles of other holes, ids already placed. */
static double id_cost(const hole_report *report, const picture_layout *layout,
                      const picture_point *ids, const placed *label, size_t i)
{
    double cost = 0.0;
    for (size_t j = 0; j < report->n_holes; j++) {
        cost += vector_cost(report, layout, label, j);
        if (j != i) {
            cost += circle_cost(label, picture_hole(report, j), circle_mm(report, layout));
        }
        if (j < i && ids_touch(report, layout, label, ids[j], j)) {
            cost += 10.0;
        }
    }
    return cost;
}

/* Round the circle, preferred on the side away from the hole's own error. */
static picture_point place_id(const hole_report *report, const picture_layout *layout,
                              const picture_point *ids, size_t i)
{
    const exk_hole_result *r = &report->results[i];
    const picture_point hole = picture_hole(report, i);
    const double px = layout->map[0].mm_per_px;
    placed label = {hole, id_half_mm(report, layout, i), 6.0 * px};
    const double off_the_mark = fmax(label.half_w, label.half_h) + (POINT_PX + 1.0) * px;
    const double away = fmax(circle_mm(report, layout) + ID_GAP_PX * px, off_the_mark);
    const double own = picture_has_point(r) ? atan2(r->dy_m, r->dx_m) : -0.5 * EXK_PI;
    picture_point best = {NAN, NAN};
    double best_cost = ID_COST_MAX;
    for (int turn = 0; turn < 16; turn++) {
        const double angle = own + EXK_PI * (1.0 + turn / 8.0);
        label.at.x_mm = hole.x_mm + away * cos(angle);
        label.at.y_mm = hole.y_mm + away * sin(angle);
        const double cost =
            0.3 * fmin(turn, 16 - turn) + id_cost(report, layout, ids, &label, i);
        if (cost < best_cost) {
            best_cost = cost;
            best = label.at;
        }
    }
    return best;
}

void picture_ids_place(const hole_report *report, picture_layout *layout)
{
    picture_point *ids = malloc(report->n_holes * sizeof *ids);
    for (size_t i = 0; ids != NULL && i < report->n_holes; i++) {
        ids[i] = place_id(report, layout, ids, i);
    }
    layout->ids = ids;
}

static double target_cost(const hole_report *report, const picture_layout *layout,
                          const placed *label, size_t i)
{
    const exk_hole_result *r = &report->results[i];
    const picture_point at = {EXK_MM_PER_M * r->dx_m, EXK_MM_PER_M * r->dy_m};
    return picture_has_point(r) ? 8.0 * covers(label, at, POINT_PX * layout->target.mm_per_px)
                                : 0.0;
}

static double label_cost(const hole_report *report, const picture_layout *layout, bool on_map,
                         const placed *label)
{
    const picture_point middle = {0.0, 0.0};
    const int part = picture_part(report, layout, (size_t)report->accuracy.worst);
    const picture_view *view = on_map ? &layout->map[part] : &layout->target;
    double cost = out_of_view(label, view);
    if (!on_map) {
        cost += circle_cost(label, middle, EXK_MM_PER_M * report->tolerance_m);
    }
    for (size_t i = 0; i < report->n_holes; i++) {
        cost +=
            on_map ? map_cost(report, layout, label, i) : target_cost(report, layout, label, i);
    }
    return cost;
}

/* Where the line from the centre to the point crosses the edge of the label. */
static picture_point foot_of(const placed *label, picture_point tip)
{
    const double dx = tip.x_mm - label->at.x_mm;
    const double dy = tip.y_mm - label->at.y_mm;
    const double fx = fabs(dx) > 0.0 ? label->half_w / fabs(dx) : INFINITY;
    const double fy = fabs(dy) > 0.0 ? label->half_h / fabs(dy) : INFINITY;
    const double f = fmin(1.0, fmin(fx, fy));
    return (picture_point){label->at.x_mm + f * dx, label->at.y_mm + f * dy};
}

static picture_point worst_tip(const hole_report *report, const picture_layout *layout,
                               bool on_map)
{
    const size_t worst = (size_t)report->accuracy.worst;
    const exk_hole_result *r = &report->results[worst];
    return on_map ? picture_tip(report, layout, worst)
                  : (picture_point){EXK_MM_PER_M * r->dx_m, EXK_MM_PER_M * r->dy_m};
}

picture_label picture_worst_place(const hole_report *report, const picture_layout *layout,
                                  bool on_map, double w_px, double h_px)
{
    enum { RINGS = 12, TURNS = 24 };
    const double px = on_map ? layout->map[0].mm_per_px : layout->target.mm_per_px;
    const picture_point tip = worst_tip(report, layout, on_map);
    placed label = {tip, 0.5 * w_px * px, 0.5 * h_px * px};
    placed best = label;
    double best_cost = INFINITY;
    for (int i = 0; i < RINGS * TURNS; i++) {
        const double angle = 2.0 * EXK_PI * (i % TURNS) / TURNS;
        const double gap = (14.0 + 12.0 * (i / TURNS)) * px;
        label.at.x_mm = tip.x_mm + (label.half_w + gap) * cos(angle);
        label.at.y_mm = tip.y_mm + (label.half_h + gap) * sin(angle);
        const double cost = label_cost(report, layout, on_map, &label) + 0.25 * (i / TURNS);
        if (cost < best_cost) {
            best_cost = cost;
            best = label;
        }
    }
    return (picture_label){best.at, foot_of(&best, tip)};
}
