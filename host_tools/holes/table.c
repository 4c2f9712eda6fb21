#include "table.h"

#include <inttypes.h>
#include <math.h>

#include "exk/units.h"

static const char *const GREEN = "\033[32m";
static const char *const RED = "\033[1;31m";
static const char *const PLAIN = "\033[0m";

static double mm(double metres)
{
    return EXK_MM_PER_M * metres;
}

static void print_warning(const hole_report *report, FILE *out, bool colour)
{
    const int64_t n = report->n_lost;
    if (n > 0) {
        fprintf(out, "%s%" PRId64 " sample%s lost: figures are not evidence%s\n",
                colour ? RED : "", n, n == 1 ? "" : "s", colour ? PLAIN : "");
    }
}

static void print_head(const hole_report *report, FILE *out, bool colour)
{
    const exk_run_log *log = report->log;
    fprintf(out, "Holes of %s: profile %s, run %" PRIu32 ", series %" PRIu32 ", seed %" PRIu64,
            report->source, log->profile_name, log->run, log->series, log->seed);
    fprintf(out,
            "\njudged on the %s tool tip; noise %s; tolerance %g mm; %zu samples, %" PRId64
            " lost\n",
            report->on_true ? "true" : "estimated", report->noise, mm(report->tolerance_m),
            log->n_samples, report->n_lost);
    print_warning(report, out, colour);
}

static void print_row(const hole_report *report, size_t i, FILE *out, bool colour)
{
    const exk_hole *hole = &report->log->holes[i];
    const exk_hole_result *r = &report->results[i];
    const char *paint = r->inside ? GREEN : RED;
    fprintf(out, "%6" PRId32 " %10.3f %10.3f", hole->id, mm(hole->target_m[0]),
            mm(hole->target_m[1]));
    if (!r->drilled) {
        fprintf(out, " %10s %10s %10s  %snot reached%s\n", "-", "-", "-", colour ? RED : "",
                colour ? PLAIN : "");
        return;
    }
    fprintf(out, " %+10.5f %+10.5f %10.5f  %s%s%s%s\n", mm(r->dx_m), mm(r->dy_m),
            mm(r->radial_m), colour ? paint : "", r->inside ? "inside" : "OUTSIDE",
            colour ? PLAIN : "", (int32_t)i == report->accuracy.worst ? "  worst" : "");
}

static void print_holes(const hole_report *report, FILE *out, bool colour)
{
    fprintf(out, "\n%6s %10s %10s %10s %10s %10s\n", "hole", "x mm", "y mm", "dx mm", "dy mm",
            "error mm");
    for (size_t i = 0; i < report->n_holes; i++) {
        print_row(report, i, out, colour);
    }
}

static void print_unreached(const hole_report *report, FILE *out)
{
    const size_t n = report->n_holes - report->accuracy.n_drilled;
    const char *lead = " ";
    if (n == 0) {
        return;
    }
    fprintf(out, "  never reached   %zu hole%s:", n, n == 1 ? "" : "s");
    for (size_t i = 0; i < report->n_holes; i++) {
        if (!report->results[i].drilled) {
            fprintf(out, "%s%" PRId32, lead, report->log->holes[i].id);
            lead = ", ";
        }
    }
    fputc('\n', out);
}

static void print_errors(const hole_report *report, FILE *out)
{
    const exk_accuracy *a = &report->accuracy;
    fprintf(out, "  mean error      %.6f mm over %zu drilled hole%s\n", mm(a->mean_m),
            a->n_drilled, a->n_drilled == 1 ? "" : "s");
    fprintf(out, "  largest error   %.6f mm at hole %" PRId32 ", the worst\n", mm(a->max_m),
            report->log->holes[a->worst].id);
    fprintf(out, "  true position   %.6f mm mean, %.6f mm largest (diameter; %g mm allowed)\n",
            mm(exk_true_position(a->mean_m)), mm(exk_true_position(a->max_m)),
            mm(exk_true_position(report->tolerance_m)));
    fprintf(out, "  Rayleigh        sigma %.6f mm, which would put %.1f %% inside\n",
            mm(report->sigma_m), 100.0 * report->expected_inside);
    fprintf(out, "  capability      Ppk %.2f (one-sided; 1.33 needs sigma %.6f mm)\n",
            hole_tidy(report->ppk), mm(exk_rayleigh_sigma_for(report->tolerance_m, 1.33)));
    fprintf(out, "  AP              %.6f mm (mean dx %+.6f, dy %+.6f)\n", mm(report->pose.ap),
            mm(report->pose.mean_dx), mm(report->pose.mean_dy));
    if (a->n_drilled > 1) {
        fprintf(
            out,
            "  RP              %.6f mm (AP and RP the ISO 9283 way, all holes as one pose)\n",
            mm(report->pose.rp));
    }
    fprintf(out, "  axis tilt       %.4f mrad largest\n", 1e3 * report->max_tilt_rad);
}

static void print_figures(const hole_report *report, FILE *out)
{
    const exk_accuracy *a = &report->accuracy;
    fprintf(out, "\n  inside          %zu of %zu = %.1f %% (95 %% Wilson: %.1f to %.1f %%)\n",
            a->n_inside, report->n_holes, 100.0 * report->correct_rate,
            100.0 * report->wilson.low, 100.0 * report->wilson.high);
    print_unreached(report, out);
    if (a->n_drilled > 0) {
        print_errors(report, out);
    }
    fprintf(out, "  path            rms %.6f mm, last point %.6f mm\n", mm(a->rms_path_m),
            mm(a->last_point_m));
}

static void print_reference(const exk_reference *ref, FILE *out)
{
    char holes[24] = "?";
    char name[64];
    if (ref->n_holes > 0) {
        snprintf(holes, sizeof holes, "%" PRIu64, ref->n_holes);
    }
    snprintf(name, sizeof name, "%s, %s", ref->name, ref->kind);
    fprintf(out, "  %-27s %6s %9.1f %% %10.6f\n", name, holes, 100.0 * ref->correct_rate,
            mm(ref->mean_m));
}

static void print_references(const hole_report *report, FILE *out)
{
    size_t n = 0;
    const exk_reference *refs = exk_references(&n);
    fprintf(out, "\n  %-27s %6s %11s %10s\n", "beside", "holes", "inside", "mean mm");
    fprintf(out, "  %-27s %6zu %9.1f %% %10.6f\n", "this run", report->n_holes,
            100.0 * report->correct_rate,
            report->accuracy.n_drilled > 0 ? mm(report->accuracy.mean_m) : (double)NAN);
    for (size_t i = 0; i < n; i++) {
        print_reference(&refs[i], out);
    }
    fputs(
        "  (published for a circle of 0.03 mm; the study gives no hole count where ? stands)\n",
        out);
}

void hole_table_print(const hole_report *report, FILE *out, bool colour)
{
    print_head(report, out, colour);
    print_holes(report, out, colour);
    print_figures(report, out);
    print_references(report, out);
    print_warning(report, out, colour);
}
