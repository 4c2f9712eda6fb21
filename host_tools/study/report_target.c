#include <math.h>

#include "noise_word.h"
#include "report_draw.h"
#include "report_figures.h"
#include "report_holes.h"

enum { UM_PER_MM = 1000, N_RINGS = 3 };

/* All errors from one centre, in µm, with the tolerance circle and two smaller ones. */
static void draw_target(FILE *script, const void *ctx)
{
    const report_trace *trace = ctx;
    const double reach_um = 1.12 * UM_PER_MM * report_worst_mm(trace);
    const report_view view = {{-reach_um, -reach_um}, {reach_um, reach_um}};
    char using[64];
    report_draw_style(script, "dx, µm", "dy, µm");
    report_draw_plane(script, &view);
    report_put_holes(script, trace);
    fputs("$rings << EOD\n", script);
    for (int i = 1; i < N_RINGS; i++) {
        fprintf(script, "0 0 %g\n", UM_PER_MM * trace->tolerance_mm * i / N_RINGS);
    }
    fprintf(script,
            "EOD\nplot $rings using 1:2:3 with circles lw 1 lc " GRID
            ", '+' every ::0::0 using (0):(0):(%g) with circles lw 2.2 lc " PATH
            ", '+' every ::0::0 using (0):(0) with points pt 1 lc " PATH,
            UM_PER_MM * trace->tolerance_mm);
    snprintf(using, sizeof using, "(%d*$3):(%d*$4)", UM_PER_MM, UM_PER_MM);
    report_put_marks(script, trace, using);
    fputs("\n", script);
}

static double mean_mm(const report_trace *trace)
{
    double sum_mm = 0.0;
    for (size_t i = 0; i < trace->n_holes; i++) {
        sum_mm += trace->holes[i].radial_mm;
    }
    return sum_mm / (double)trace->n_holes;
}

static void put_caption(report_page *page, const report_trace *trace, double enlarged)
{
    const exk_profile *profile = &page->paper->profiles[STUDY_S9];
    char noise[256];
    report_noise_text(profile, noise, sizeof noise);
    report_legend(page);
    report_legend_item(page, REPORT_RING, "path", "target with its tolerance circle");
    report_hole_legend(page, trace->tolerance_mm);
    report_caption(page);
    fprintf(
        page->out,
        "n = %zu holes of one trial: %zu inside, mean error %.4f mm; the study prints 37 of "
        "45 and 0.023614 mm. Noise: ",
        trace->n_holes, report_n_inside(trace), mean_mm(trace));
    report_escaped(page, noise);
    fprintf(
        page->out,
        ". Seed %llu, trial 0, run %d of a learning series with K = %g, noise %s. Errors are "
        "drawn %g times as large on the plate, and in µm from one centre beside it.",
        (unsigned long long)profile->timing.seed, study_experiment_at(STUDY_S9)->n_runs,
        profile->ilc.gain, exk_noise_word(profile), enlarged);
    report_figure_end(page);
}

static void put_figure(report_page *page, const report_trace *trace)
{
    char desc[160];
    const report_map map = {
        trace, report_enlargement(report_worst_mm(trace), report_room_mm(trace)), false};
    snprintf(desc, sizeof desc, "%zu holes, %zu of them inside %g mm, mean error %.4f mm.",
             trace->n_holes, report_n_inside(trace), trace->tolerance_mm, mean_mm(trace));
    report_figure(page, "fig-grid45", "S9: the 45 holes of the Exechon model");
    report_panel(page, "on the plate", desc, REPORT_PANEL_W, REPORT_PANEL_H, report_draw_map,
                 &map);
    report_panel(page, "from one centre", desc, REPORT_PANEL_W, REPORT_PANEL_H, draw_target,
                 trace);
    put_caption(page, trace, map.enlarged);
}

void report_target45(report_page *page)
{
    report_trace trace;
    if (!report_ran(page, STUDY_PART_S9)) {
        return;
    }
    const int code =
        report_trace_open(&trace, page->paper->folder, STUDY_S9,
                          study_experiment_at(STUDY_S9)->n_runs, REPORT_AS_PROFILED);
    report_fail(page, code, "");
    if (code == STUDY_GOOD) {
        put_figure(page, &trace);
    }
    report_trace_close(&trace);
}
