#include "report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "exk/profile.h"
#include "noise_word.h"

static const double CONFIDENCE = 0.95;

static bool all_true(const exk_run_log *log)
{
    for (size_t i = 0; i < log->n_samples; i++) {
        if (!log->samples[i].has_true) {
            return false;
        }
    }
    return true;
}

static void read_profile(hole_report *report)
{
    exk_profile profile;
    exk_fault fault;
    size_t n_faults = 0;
    const char *text = report->log->profile_text;
    report->noise = "unknown";
    report->has_profile =
        text != NULL && exk_profile_parse(text, &profile, &fault, 1, &n_faults) == EXK_OK;
    if (report->has_profile) {
        report->noise = exk_noise_word(&profile);
    }
}

static exk_judged_point point_of(const exk_sample *sample, bool on_true)
{
    return (exk_judged_point){
        .k = sample->k,
        .dwell = sample->phase == EXK_PHASE_DWELL,
        .hole = sample->hole,
        .ref = sample->ref,
        .tool = on_true ? sample->real : sample->est,
    };
}

/* A dwell that the end of the log cut short is not drilled, unless its last sample is there. */
static void judge_samples(hole_report *report, exk_judge *judge)
{
    const exk_run_log *log = report->log;
    bool last_was_judged = false;
    for (size_t i = 0; i < log->n_samples; i++) {
        const exk_judged_point point = point_of(&log->samples[i], report->on_true);
        const int32_t done = exk_judge_push(judge, &point);
        report->n_early += done >= 0 && !last_was_judged ? 1 : 0;
        last_was_judged = log->samples[i].judged;
    }
    if (last_was_judged) {
        exk_judge_end(judge);
    }
    exk_judge_summary(judge, &report->accuracy);
}

/* Errors of the drilled holes, as arrays for the statistics. */
static bool fill_statistics(hole_report *report)
{
    const size_t n = report->accuracy.n_drilled;
    double *values = malloc((3 * n + 1) * sizeof *values);
    size_t at = 0;
    if (values == NULL) {
        return false;
    }
    for (size_t i = 0; i < report->n_holes; i++) {
        const exk_hole_result *r = &report->results[i];
        if (r->drilled) {
            values[at] = r->dx_m;
            values[n + at] = r->dy_m;
            values[2 * n + at] = r->radial_m;
            report->max_tilt_rad = fmax(report->max_tilt_rad, r->tilt_rad);
            at++;
        }
    }
    report->pose = exk_pose_accuracy(values, values + n, n);
    report->sigma_m = exk_rayleigh_fit(values + 2 * n, n);
    free(values);
    report->expected_inside = exk_rayleigh_inside(report->tolerance_m, report->sigma_m);
    report->ppk = exk_rayleigh_ppk(report->tolerance_m, report->sigma_m);
    report->correct_rate = (double)report->accuracy.n_inside / (double)report->n_holes;
    report->wilson = exk_wilson(report->accuracy.n_inside, report->n_holes, CONFIDENCE);
    return true;
}

static int refuse(hole_report *report, char *why, size_t why_size, const char *reason)
{
    snprintf(why, why_size, "%s: %s", report->source, reason);
    hole_report_free(report);
    return 2;
}

int hole_report_make(hole_report *report, const exk_run_log *log, const char *source,
                     double tolerance_m, char *why, size_t why_size)
{
    exk_judge judge;
    *report = (hole_report){.log = log, .source = source, .n_holes = log->n_holes};
    report->n_lost = log->n_lost + log->n_before;
    report->tolerance_m = tolerance_m > 0.0 ? tolerance_m : log->tolerance_m;
    if (!log->has_job) {
        return refuse(
            report, why, why_size,
            "no EXK_JOB message, so the targets are not known: record for more than a "
            "second, the job is sent every second");
    }
    report->results = calloc(log->n_holes + 1, sizeof *report->results);
    if (report->results == NULL) {
        return refuse(report, why, why_size, "out of memory");
    }
    const exk_err err =
        exk_judge_init(&judge, log->holes, log->n_holes, report->tolerance_m, report->results);
    if (err != EXK_OK) {
        return refuse(
            report, why, why_size,
            "the job in the log cannot be judged: no hole, or a target, an axis or the "
            "tolerance is not valid");
    }
    report->on_true = all_true(log);
    read_profile(report);
    judge_samples(report, &judge);
    return fill_statistics(report) ? 0 : refuse(report, why, why_size, "out of memory");
}

void hole_report_free(hole_report *report)
{
    free(report->results);
    report->results = NULL;
}

bool hole_report_good(const hole_report *report)
{
    return report->accuracy.n_inside == report->n_holes && report->n_lost == 0;
}

double hole_tidy(double x)
{
    return fabs(x) < 0.005 ? 0.0 : x;
}
