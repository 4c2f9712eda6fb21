/** What the report's drawings share: axes, ranges, by how much errors are enlarged.
 */
#ifndef STUDY_REPORT_DRAW_H
#define STUDY_REPORT_DRAW_H

#include "report_svg.h"
#include "report_trace.h"

enum { REPORT_PANEL_W = 420, REPORT_PANEL_H = 315 };

typedef struct {
    double low[2]; /* x, y */
    double high[2];
} report_view;

/** Axes left and below, grid, tics in the page's colours; no key, which is the legend's work. */
void report_draw_style(FILE *script, const char *x_label, const char *y_label);

/** Same scale on both axes, over the view. */
void report_draw_plane(FILE *script, const report_view *view);

/** Grows a view that report_view_empty gave; margin is a share of its size. */
report_view report_view_empty(void);
void report_view_add(report_view *view, double x, double y);
void report_view_margin(report_view *view, double margin);

/** Distance of tics of 1, 2 or 5 times a power of ten, for at most n of them over a range. */
double report_tic_step(double range, int n);

/** Largest of 1, 2, 3, 5, 10, 20, ... that keeps largest within room; 1 at least. */
double report_enlargement(double largest, double room);

#endif
