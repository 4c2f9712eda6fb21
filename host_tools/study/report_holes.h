/** Holes of a trace as marks: inside and outside differ in colour and in shape.
 *
 *  Data     blocks $inside, $outside (x y dx dy order radial, mm) and $all (x y) of a script.
 */
#ifndef STUDY_REPORT_HOLES_H
#define STUDY_REPORT_HOLES_H

#include "report_page.h"
#include "report_trace.h"

void report_put_holes(FILE *script, const report_trace *trace);

/** Continues a plot command with a dot for each hole inside and a cross for each outside. */
void report_put_marks(FILE *script, const report_trace *trace, const char *using);

typedef struct {
    const report_trace *trace;
    double enlarged;
    bool start; /* a square round the first hole */
} report_map;

/** Targets with their tolerance circles and the holes as drilled; ctx is a report_map. */
void report_draw_map(FILE *script, const void *ctx);

void report_hole_legend(report_page *page, double tolerance_mm);

/** Largest error or the tolerance, whichever is more; how far one may be drawn: half the way to
 *  the next target. */
double report_worst_mm(const report_trace *trace);
double report_room_mm(const report_trace *trace);
size_t report_n_inside(const report_trace *trace);

#endif
