#include <math.h>

#include "exk/units.h"
#include "noise_word.h"
#include "report_draw.h"
#include "report_figures.h"

enum { N_RUNS = 3, ROOM_MM = 30 };

typedef struct {
    const report_trace *trace;
    const report_view *view;
    double enlarged;
} run_panel;

/* Means of a measure by run with their 95 % of trials. */
typedef struct {
    const json_t *curve;
    double gain;      /* of the law: each run leaves 1 - K */
    double published; /* at the last run, NaN: none */
} curve_panel;

static void draw_run(FILE *script, const void *ctx)
{
    const run_panel *panel = ctx;
    const report_trace *trace = panel->trace;
    const double s = panel->enlarged;
    report_draw_style(script, "x, mm", "y, mm");
    report_draw_plane(script, panel->view);
    fputs("$a << EOD\n", script);
    for (size_t i = 0; i < trace->n_points; i++) {
        const report_point *p = &trace->points[i];
        fprintf(script, "%.6g %.6g %.6g %.6g\n", p->ref_mm[0], p->ref_mm[1],
                p->ref_mm[0] + s * p->off_mm[0], p->ref_mm[1] + s * p->off_mm[1]);
    }
    fprintf(script,
            "EOD\nplot $a using 1:2 with lines lw 4 lc " PATH
            ", $a using 3:4 with lines lw 1.6 lc " BLUE ", $a every ::0::0 using 1:2 with "
            "points pt 6 ps 2.4*mark_size lw 2 lc " INK
            ", $a every ::%zu using 3:4 with points pt 7 ps 1.7*mark_size lc " BLUE "\n",
            trace->n_points - 1);
}

static void draw_curve(FILE *script, const void *ctx)
{
    const curve_panel *panel = ctx;
    const double first = report_number(json_array_get(panel->curve, 0), "mean");
    report_draw_style(script, "run of the series", "mm");
    fprintf(script, "set xrange [0.6:%g]\nset yrange [0:*]\nset xtics 1\n$a << EOD\n",
            N_RUNS + 0.4);
    for (size_t i = 0; i < N_RUNS; i++) {
        const json_t *at = json_array_get(panel->curve, i);
        fprintf(script, "%zu %.9g %.9g %.9g %.9g\n", i + 1, report_number(at, "mean"),
                report_end(at, "spread95", 0), report_end(at, "spread95", 1),
                first * pow(1.0 - panel->gain, (double)i));
    }
    fputs("EOD\nplot $a using 1:5 with lines lw 2 dt (6,4) lc " PATH
          ", $a using 1:2:3:4 with yerrorbars lw 1.8 pt 7 ps 1.3*mark_size lc " BLUE,
          script);
    if (isfinite(panel->published)) {
        fprintf(script,
                ", '+' every ::0::0 using (%g):(%.9g) with points pt 13 ps "
                "2.4*mark_size lc " ORANGE,
                N_RUNS + 0.12, panel->published);
    }
    fputs("\n", script);
}

static report_view view_of(const report_trace traces[N_RUNS], double enlarged)
{
    report_view view = report_view_empty();
    for (int run = 0; run < N_RUNS; run++) {
        for (size_t i = 0; i < traces[run].n_points; i++) {
            const report_point *p = &traces[run].points[i];
            report_view_add(&view, p->ref_mm[0] + enlarged * p->off_mm[0],
                            p->ref_mm[1] + enlarged * p->off_mm[1]);
        }
    }
    report_view_margin(&view, 0.04);
    return view;
}

static void put_runs(report_page *page, const report_trace traces[N_RUNS],
                     const report_view *view, double enlarged)
{
    for (int run = 0; run < N_RUNS; run++) {
        char title[64];
        char desc[192];
        const run_panel panel = {&traces[run], view, enlarged};
        snprintf(title, sizeof title, "run %d%s", run + 1, run == 0 ? ", untrained" : "");
        snprintf(desc, sizeof desc,
                 "Path of the tool in run %d of a learning series: last point %.3g mm off.",
                 run + 1, traces[run].last_point_mm);
        report_panel(page, title, desc, REPORT_PANEL_W, REPORT_PANEL_H, draw_run, &panel);
    }
}

static void put_curve(report_page *page, const char *title, const char *key, double gain,
                      double published)
{
    char desc[192];
    const curve_panel panel = {json_object_get(json_object_get(page->result, "curves"), key),
                               gain, published};
    snprintf(desc, sizeof desc, "Means of runs 1 to 3: %.4g, %.4g, %.4g mm.",
             report_number(json_array_get(panel.curve, 0), "mean"),
             report_number(json_array_get(panel.curve, 1), "mean"),
             report_number(json_array_get(panel.curve, 2), "mean"));
    report_panel(page, title, desc, REPORT_PANEL_W, REPORT_PANEL_H, draw_curve, &panel);
}

static void put_run_caption(report_page *page, const report_trace traces[N_RUNS],
                            double enlarged)
{
    const exk_profile *profile = &page->paper->profiles[STUDY_S4];
    char noise[256];
    report_noise_text(profile, noise, sizeof noise);
    report_legend(page);
    report_legend_item(page, REPORT_LINE, "path", "expected path");
    report_legend_item(page, REPORT_LINE, "blue", "tool");
    report_legend_item(page, REPORT_RING, "ink", "start");
    report_legend_item(page, REPORT_DOT, "blue", "last point; in the fourth panel the mean");
    report_legend_item(page, REPORT_DASHED, "path", "the law's (1-K)^(p-1)");
    report_caption(page);
    fprintf(
        page->out,
        "Iterative learning with K = %g: the last point is %.3g, %.3g and %.3g mm off. Noise: ",
        profile->ilc.gain, traces[0].last_point_mm, traces[1].last_point_mm,
        traces[2].last_point_mm);
    report_escaped(page, noise);
    fprintf(page->out,
            ". Runs 1 to 3: n = 1 series, seed %llu, trial 0; "
            "fourth panel: rms path error, mean and 95 %% of n = %llu series. Noise %s.",
            (unsigned long long)profile->timing.seed,
            (unsigned long long)page->tallies[STUDY_M_S4_RMS_1].moments.n,
            exk_noise_word(profile));
    report_scale(page, enlarged);
    report_figure_end(page);
}

static void put_runs_figure(report_page *page, const report_trace traces[N_RUNS])
{
    const double enlarged = report_enlargement(report_trace_largest_mm(&traces[0]), ROOM_MM);
    const report_view view = view_of(traces, enlarged);
    report_figure(page, "fig-ilc", "S4: learning on the rectangle, runs 1 to 3");
    put_runs(page, traces, &view, enlarged);
    put_curve(page, "rms path error by run", "S4_rms_mm_by_run",
              page->paper->profiles[STUDY_S4].ilc.gain, NAN);
    put_run_caption(page, traces, enlarged);
}

/* Of the fitted size, where the study prints a number. */
static void put_last_point_figure(report_page *page)
{
    const exk_profile *profile = &page->paper->profiles[STUDY_S5];
    char noise[256];
    report_noise_text(profile, noise, sizeof noise);
    report_figure(page, "fig-last-point", "S5: last-point error by run");
    put_curve(page, "last-point error by run", "S5_last_mm_by_run", profile->ilc.gain, 0.123);
    report_legend(page);
    report_legend_item(page, REPORT_SPREAD, "blue", "mean, with 95 % of the trials");
    report_legend_item(page, REPORT_DASHED, "path", "the law's (1-K)^(p-1)");
    report_legend_item(page, REPORT_DIAMOND, "orange", "published for run 3: 0.123 mm");
    report_caption(page);
    fputs("The noise is the fitted one: ", page->out);
    report_escaped(page, noise);
    fprintf(page->out, ". n = %llu series, seed %llu, noise %s.",
            (unsigned long long)page->tallies[STUDY_M_S5_LAST_1].moments.n,
            (unsigned long long)profile->timing.seed, exk_noise_word(profile));
    report_figure_end(page);
}

static void put_runs_of_trial(report_page *page)
{
    report_trace traces[N_RUNS] = {{.n_points = 0}};
    int code = STUDY_GOOD;
    for (int run = 0; run < N_RUNS && code == STUDY_GOOD; run++) {
        code = report_trace_open(&traces[run], page->paper->folder, STUDY_S4, run + 1,
                                 REPORT_AS_PROFILED);
    }
    report_fail(page, code, "");
    if (code == STUDY_GOOD) {
        put_runs_figure(page, traces);
    }
    for (int run = 0; run < N_RUNS; run++) {
        report_trace_close(&traces[run]);
    }
}

void report_learning(report_page *page)
{
    if (report_ran(page, STUDY_PART_S4)) {
        put_runs_of_trial(page);
    }
    if (report_ran(page, STUDY_PART_S5)) {
        put_last_point_figure(page);
    }
}
