/** Trial 0 of an experiment, sample by sample and hole by hole, as the study's runs would log it.
 *
 *  Points   X and Y of reference and true tip at every tick, mm.
 *  Holes    target and error in the plane, in drilling order, mm.
 *  Errors   an exit code after a message on stderr.
 *  Memory   open allocates, close releases.
 */
#ifndef STUDY_REPORT_TRACE_H
#define STUDY_REPORT_TRACE_H

#include "experiments.h"

typedef struct {
    double ref_mm[2];
    double off_mm[2]; /* true tip less reference */
} report_point;

typedef struct {
    double target_mm[2];
    double off_mm[2];
    double radial_mm;
    bool inside;
} report_hole;

typedef struct {
    report_point *points;
    size_t n_points;
    size_t capacity;
    report_hole *holes;
    size_t n_holes;
    double tolerance_mm;
    double last_point_mm;
} report_trace;

enum { REPORT_AS_PROFILED = -1 };

/** The last of n_runs runs of trial 0, with learning between them. axis: the disturbances act on this
 *  angle alone, or on those of the profile (REPORT_AS_PROFILED). */
int report_trace_open(report_trace *trace, const char *folder, study_experiment which,
                      int n_runs, int axis);
void report_trace_close(report_trace *trace);

/** Largest distance from the reference; of points. */
double report_trace_largest_mm(const report_trace *trace);

#endif
