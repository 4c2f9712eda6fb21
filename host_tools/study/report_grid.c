#include <math.h>
#include <string.h>

#include "noise_word.h"
#include "report_draw.h"
#include "report_figures.h"
#include "report_holes.h"

enum { N_ORDERS = 2 };

typedef struct {
    const report_trace *trace;
    const json_t *curve;
    double low; /* published range */
    double high;
    double top;
} bars_panel;

static const char *const order_names[N_ORDERS] = {"zero order (S7)", "first order (S8)"};

static void draw_bars(FILE *script, const void *ctx)
{
    const bars_panel *panel = ctx;
    report_draw_style(script, "hole, in drilling order", "error, mm");
    fprintf(script,
            "set xrange [0:%zu]\nset yrange [0:%.6g]\nset xtics 5\n"
            "set object rect from graph 0,first %g to graph 1,first %g fc " ORANGE
            " fs transparent solid 0.16 noborder behind\n$mean << EOD\n",
            panel->trace->n_holes + 1, panel->top, panel->low, panel->high);
    for (size_t i = 0; i < panel->trace->n_holes; i++) {
        const json_t *at = json_array_get(panel->curve, i);
        fprintf(script, "%zu %.9g %.9g %.9g\n", i + 1, report_number(at, "mean"),
                report_end(at, "spread95", 0), report_end(at, "spread95", 1));
    }
    fputs("EOD\n", script);
    report_put_holes(script, panel->trace);
    fprintf(script,
            "plot %.6g with lines lw 1.5 dt (6,4) lc " PATH
            ", $mean using 1:2:3:4 with yerrorbars lw 1.3 pt 7 ps 0.9*mark_size lc " BLUE,
            panel->trace->tolerance_mm);
    report_put_marks(script, panel->trace, "5:6");
    fputs("\n", script);
}

static void end_caption(report_page *page, const exk_profile *profile, double enlarged)
{
    fprintf(page->out, " Seed %llu, trial 0, run 5 of a learning series with K = %g, noise %s.",
            (unsigned long long)profile->timing.seed, profile->ilc.gain,
            exk_noise_word(profile));
    if (enlarged > 0.0) {
        fprintf(page->out, " Errors and circles are drawn %g times as large as they are.",
                enlarged);
    }
    report_figure_end(page);
}

static void put_maps(report_page *page, const report_trace traces[N_ORDERS])
{
    const double worst = fmax(report_worst_mm(&traces[0]), report_worst_mm(&traces[1]));
    const double enlarged = report_enlargement(worst, report_room_mm(&traces[0]));
    report_figure(page, "fig-grid25", "S7, S8: the 25 drilled points");
    for (int i = 0; i < N_ORDERS; i++) {
        char desc[160];
        const report_map panel = {&traces[i], enlarged, true};
        snprintf(desc, sizeof desc,
                 "%zu holes on their targets: %zu inside, largest error %.4f mm.",
                 traces[i].n_holes, report_n_inside(&traces[i]), report_worst_mm(&traces[i]));
        report_panel(page, order_names[i], desc, REPORT_PANEL_W, REPORT_PANEL_H,
                     report_draw_map, &panel);
    }
    report_legend(page);
    report_legend_item(page, REPORT_RING, "path", "target with its tolerance circle");
    report_hole_legend(page, traces[0].tolerance_mm);
    report_caption(page);
    fprintf(
        page->out,
        "n = 25 holes of one trial each: %zu (zero order) and %zu (first order) inside. The "
        "square marks the start point, which the study leaves out of its ranges.",
        report_n_inside(&traces[0]), report_n_inside(&traces[1]));
    end_caption(page, &page->paper->profiles[STUDY_S7], enlarged);
}

static double published(const char *id)
{
    size_t n = 0;
    const study_claim *claims = study_claims(&n);
    for (size_t i = 0; i < n; i++) {
        if (strcmp(claims[i].id, id) == 0) {
            return claims[i].published;
        }
    }
    return NAN;
}

static void put_bars(report_page *page, const report_trace traces[N_ORDERS])
{
    static const char *const keys[] = {"S7_mm_by_hole", "S8_mm_by_hole"};
    static const char *const ids[][2] = {{"S7_min", "S7_max"}, {"S8_min", "S8_max"}};
    const json_t *curves = json_object_get(page->result, "curves");
    double top = 0.0;
    for (int i = 0; i < N_ORDERS; i++) {
        const json_t *curve = json_object_get(curves, keys[i]);
        top = fmax(top, fmax(published(ids[i][1]), report_worst_mm(&traces[i])));
        for (size_t j = 0; j < json_array_size(curve); j++) {
            top = fmax(top, report_end(json_array_get(curve, j), "spread95", 1));
        }
    }
    report_figure(page, "fig-by-hole", "S7, S8: error of each hole");
    for (int i = 0; i < N_ORDERS; i++) {
        char desc[192];
        const bars_panel panel = {&traces[i], json_object_get(curves, keys[i]),
                                  published(ids[i][0]), published(ids[i][1]), 1.08 * top};
        snprintf(desc, sizeof desc,
                 "Error of 25 holes in drilling order, mean and 95 %% of the trials; published "
                 "range %g to %g mm.",
                 panel.low, panel.high);
        report_panel(page, order_names[i], desc, REPORT_PANEL_W, REPORT_PANEL_H, draw_bars,
                     &panel);
    }
    report_legend(page);
    report_legend_item(page, REPORT_SPREAD, "blue", "mean, with 95 % of the trials");
    report_hole_legend(page, traces[0].tolerance_mm);
    report_legend_item(page, REPORT_BAND, "orange", "published range");
    report_legend_item(page, REPORT_DASHED, "path", "tolerance");
    report_caption(page);
    fprintf(page->out,
            "Mean and spread over n = %llu trials; dots and crosses are one of them.",
            (unsigned long long)page->tallies[STUDY_M_S7_HOLES].moments.n);
    end_caption(page, &page->paper->profiles[STUDY_S7], 0.0);
}

void report_grid25(report_page *page)
{
    static const study_experiment of[N_ORDERS] = {STUDY_S7, STUDY_S8};
    report_trace traces[N_ORDERS] = {{.n_points = 0}};
    int code = STUDY_GOOD;
    if (!report_ran(page, STUDY_PART_S7) || !report_ran(page, STUDY_PART_S8)) {
        return;
    }
    for (int i = 0; i < N_ORDERS && code == STUDY_GOOD; i++) {
        code = report_trace_open(&traces[i], page->paper->folder, of[i],
                                 study_experiment_at(of[i])->n_runs, REPORT_AS_PROFILED);
    }
    report_fail(page, code, "");
    if (code == STUDY_GOOD) {
        put_maps(page, traces);
        put_bars(page, traces);
    }
    for (int i = 0; i < N_ORDERS; i++) {
        report_trace_close(&traces[i]);
    }
}
