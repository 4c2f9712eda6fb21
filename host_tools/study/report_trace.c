#include "report_trace.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "exk/units.h"
#include "task.h"

static void push(void *ctx, const exk_sample *sample)
{
    report_trace *trace = ctx;
    if (trace->n_points == trace->capacity) {
        return;
    }
    report_point *point = &trace->points[trace->n_points++];
    for (int i = 0; i < 2; i++) {
        point->ref_mm[i] = EXK_MM_PER_M * sample->ref.tip_m[i];
        point->off_mm[i] = EXK_MM_PER_M * (sample->real.tip_m[i] - sample->ref.tip_m[i]);
    }
}

static void copy_holes(report_trace *trace, const study_lab *lab)
{
    for (size_t i = 0; i < trace->n_holes; i++) {
        const exk_hole_result *result = &lab->series.results[i];
        const double *target_m = lab->rig->holes[i].target_m;
        trace->holes[i] = (report_hole){
            .target_mm = {EXK_MM_PER_M * target_m[0], EXK_MM_PER_M * target_m[1]},
            .off_mm = {EXK_MM_PER_M * result->dx_m, EXK_MM_PER_M * result->dy_m},
            .radial_mm = EXK_MM_PER_M * result->radial_m,
            .inside = result->inside,
        };
    }
}

static void restrict_to(exk_rig *rig, int axis)
{
    exk_twin_config *twin = &rig->profile.twin;
    for (size_t i = 0; i < twin->n_disturbances && axis != REPORT_AS_PROFILED; i++) {
        for (int j = 0; j < EXK_N_AXES; j++) {
            twin->disturbance[i].channel[j] = j == axis;
        }
    }
}

static int run_series(report_trace *trace, study_lab *lab, int n_runs)
{
    exk_accuracy accuracy = {.n_drilled = 0};
    lab->series.on_sample = push;
    lab->series.sample_ctx = trace;
    study_lab_begin(lab, 0);
    for (int run = 1; run <= n_runs; run++) {
        trace->n_points = 0;
        const int code = study_lab_run(lab, 0, run, &accuracy);
        if (code != STUDY_GOOD) {
            return code;
        }
        if (run < n_runs && exk_series_learn(&lab->series) != EXK_OK) {
            return STUDY_MISS;
        }
    }
    trace->last_point_mm = EXK_MM_PER_M * accuracy.last_point_m;
    copy_holes(trace, lab);
    return STUDY_GOOD;
}

static int allocate(report_trace *trace, const study_lab *lab)
{
    *trace = (report_trace){.capacity = lab->series.n,
                            .n_holes = lab->rig->n_holes,
                            .tolerance_mm = EXK_MM_PER_M * lab->rig->profile.job.tolerance_m};
    trace->points = calloc(trace->capacity, sizeof *trace->points);
    trace->holes = calloc(trace->n_holes, sizeof *trace->holes);
    if (trace->points == NULL || trace->holes == NULL) {
        fprintf(stderr, "exk-study: out of memory\n");
        return STUDY_IO;
    }
    return STUDY_GOOD;
}

int report_trace_open(report_trace *trace, const char *folder, study_experiment which,
                      int n_runs, int axis)
{
    study_lab lab;
    *trace = (report_trace){.n_points = 0};
    const study_variant variant = study_as_published();
    int code = study_lab_open(&lab, folder, which, &variant);
    if (code != STUDY_GOOD) {
        return code;
    }
    restrict_to(lab.rig, axis);
    code = allocate(trace, &lab);
    if (code == STUDY_GOOD) {
        code = run_series(trace, &lab, n_runs);
    }
    study_lab_close(&lab);
    return code;
}

void report_trace_close(report_trace *trace)
{
    free(trace->points);
    free(trace->holes);
    *trace = (report_trace){.n_points = 0};
}

double report_trace_largest_mm(const report_trace *trace)
{
    double largest_mm = 0.0;
    for (size_t i = 0; i < trace->n_points; i++) {
        const double *off_mm = trace->points[i].off_mm;
        largest_mm = fmax(largest_mm, hypot(off_mm[0], off_mm[1]));
    }
    return largest_mm;
}
