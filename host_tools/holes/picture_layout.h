/** Where things go in the picture: ranges, enlargement, and places for labels.
 *
 *  Units   millimetres of the part for the map; pixels for labels.
 *  Memory  make allocates the places of the ids; picture_layout_free releases them.
 */
#ifndef EXK_HOLES_PICTURE_LAYOUT_H
#define EXK_HOLES_PICTURE_LAYOUT_H

#include <stdbool.h>
#include <stddef.h>

#include "report.h"

enum { PICTURE_W = 1400, PICTURE_H = 800 };

typedef struct {
    double x_mm;
    double y_mm;
} picture_point;

/** A box of the picture, pixels from the lower left corner. */
typedef struct {
    double left;
    double right;
    double bottom;
    double top;
} picture_box;

/** A box and the mm it shows, the same scale in x and y. */
typedef struct {
    picture_box box;
    double x_mm; /* at the left edge */
    double y_mm; /* at the lower edge */
    double mm_per_px;
} picture_view;

enum { PICTURE_MAX_MAPS = 4 };

/** A long job is cut into parts of one scale: along x they are stacked, along y side by side. */
typedef struct {
    picture_view map[PICTURE_MAX_MAPS];
    int n_maps;
    bool along_y;
    double cut_mm;       /* where the first part begins, */
    double part_mm;      /* and how long each is */
    picture_view target; /* all errors in one circle, not enlarged */
    double enlarged;     /* errors on the map are this many times their size */
    picture_point *ids;  /* centre of each hole's id on the map, NaN: no room; NULL: no ids */
} picture_layout;

void picture_layout_make(const hole_report *report, picture_layout *out);
void picture_layout_free(picture_layout *layout);

/** Whether a hole has a position that can be drawn. */
bool picture_has_point(const exk_hole_result *result);

/** Which map a hole is on. */
int picture_part(const hole_report *report, const picture_layout *layout, size_t i);

/** Centre and drawn tip of a hole on its map. */
picture_point picture_hole(const hole_report *report, size_t i);
picture_point picture_tip(const hole_report *report, const picture_layout *layout, size_t i);

/** A label beside the worst hole's point: its centre, and where the line to the point leaves it. */
typedef struct {
    picture_point centre;
    picture_point foot;
} picture_label;

/** Place of a label of w x h pixels near the worst hole's point where it covers least. */
picture_label picture_worst_place(const hole_report *report, const picture_layout *layout,
                                  bool on_map, double w_px, double h_px);

#endif
