/** A run judged: every hole, and the figures over all of them.
 *
 *  Judged    on the true tool tip when every sample of the log has it, else on the estimated one.
 *  Statistic figures are over the holes that were drilled; correct_rate is over all holes of the
 *            job, so a hole that was never reached counts as not inside.
 *  Errors    make: 0, or 2 with a reason (no job in the log, no hole, a job that cannot be judged).
 *  Memory    make allocates results; hole_report_free releases them. log is borrowed.
 */
#ifndef EXK_HOLES_REPORT_H
#define EXK_HOLES_REPORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/accuracy.h"
#include "exk/log.h"
#include "exk/stats.h"

typedef struct {
    const exk_run_log *log;
    const char *source; /* file name or bus, as said to people */
    const char *noise;  /* frozen, fresh, mixed, none, replay, or unknown */
    bool has_profile;
    int64_t n_lost; /* between the first sample and the last, and before the first one seen */
    bool on_true;
    double tolerance_m;
    exk_hole_result *results; /* index = drilling order */
    size_t n_holes;
    size_t
        n_early; /* holes judged before the last sample of their dwell: that one is missing */
    exk_accuracy accuracy;
    double correct_rate;
    exk_interval wilson;
    double sigma_m;         /* Rayleigh */
    double expected_inside; /* with that sigma */
    double ppk;
    exk_pose_figures pose; /* metres */
    double max_tilt_rad;
} hole_report;

/** tolerance_m: 0 takes the job's. */
int hole_report_make(hole_report *report, const exk_run_log *log, const char *source,
                     double tolerance_m, char *why, size_t why_size);
void hole_report_free(hole_report *report);

/** True when every hole of the job is inside and no sample was lost. */
bool hole_report_good(const hole_report *report);

/** No minus before what prints as 0.00. */
double hole_tidy(double x);

#endif
