#include <math.h>

#include "noise_word.h"
#include "report_draw.h"
#include "report_figures.h"

enum { N_PANELS = 4, TRACES_MAX = 2, ROOM_MM = 40 };

typedef struct {
    report_trace traces[TRACES_MAX];
    int n_traces;
    double enlarged;
    const report_view *view;
} path_panel;

typedef struct {
    const char *id;
    const char *title;
    const char *what; /* of the description */
    study_experiment first[N_PANELS];
    study_experiment second[N_PANELS]; /* another force, or the same: none */
    int axis[N_PANELS];
} path_figure;

static const char *const panel_names[N_PANELS] = {"no noise", "noise on α alone",
                                                  "noise on β alone", "noise on both angles"};

static const path_figure figures[] = {
    {"fig-sine",
     "S1: sine noise on the angles",
     "Path of the tool round the rectangle under a sine",
     {STUDY_S1_NONE, STUDY_S1_ALPHA, STUDY_S1_BETA, STUDY_S1_BOTH},
     {STUDY_S1_NONE, STUDY_S1_ALPHA, STUDY_S1_BETA, STUDY_S1_BOTH},
     {REPORT_AS_PROFILED, REPORT_AS_PROFILED, REPORT_AS_PROFILED, REPORT_AS_PROFILED}},
    {"fig-awgn",
     "S2: white Gaussian noise, accumulating (first order)",
     "Path of the tool round the rectangle under accumulating white noise",
     {STUDY_S1_NONE, STUDY_S2_ALPHA, STUDY_S2_BETA, STUDY_S2_BOTH},
     {STUDY_S1_NONE, STUDY_S2_ALPHA, STUDY_S2_BETA, STUDY_S2_BOTH},
     {REPORT_AS_PROFILED, REPORT_AS_PROFILED, REPORT_AS_PROFILED, REPORT_AS_PROFILED}},
    {"fig-force",
     "S3: second-order noise, a force of one sign",
     "Path of the tool round the rectangle under a force on the angular acceleration",
     {STUDY_S1_NONE, STUDY_S3_PLUS, STUDY_S3_PLUS, STUDY_S3_PLUS},
     {STUDY_S1_NONE, STUDY_S3_MINUS, STUDY_S3_MINUS, STUDY_S3_MINUS},
     {REPORT_AS_PROFILED, EXK_ALPHA, EXK_BETA, REPORT_AS_PROFILED}},
};

static void put_trace(FILE *script, const report_trace *trace, const char *name)
{
    fprintf(script, "$%s << EOD\n", name);
    for (size_t i = 0; i < trace->n_points; i++) {
        const report_point *p = &trace->points[i];
        fprintf(script, "%.6g %.6g %.6g %.6g\n", p->ref_mm[0], p->ref_mm[1], p->off_mm[0],
                p->off_mm[1]);
    }
    fputs("EOD\n", script);
}

static void draw_path(FILE *script, const void *ctx)
{
    static const char *const names[] = {"a", "b"};
    static const char *const lines[] = {"lw 1.6 lc " BLUE, "lw 1.6 dt (6,3) lc " ORANGE};
    static const char *const ends[] = {"pt 7 lc " BLUE, "pt 9 lc " ORANGE};
    const path_panel *panel = ctx;
    const double s = panel->enlarged;
    report_draw_style(script, "x, mm", "y, mm");
    report_draw_plane(script, panel->view);
    for (int i = 0; i < panel->n_traces; i++) {
        /* NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): at most TRACES_MAX */
        put_trace(script, &panel->traces[i], names[i]);
    }
    fputs("plot $a using 1:2 with lines lw 4 lc " PATH, script);
    for (int i = 0; i < panel->n_traces; i++) {
        fprintf(script, ", $%s using ($1+%g*$3):($2+%g*$4) with lines %s", names[i], s, s,
                lines[i]);
        fprintf(script,
                ", $%s every ::%zu using ($1+%g*$3):($2+%g*$4) with points ps 1.6*mark_size %s",
                names[i], panel->traces[i].n_points - 1, s, s, ends[i]);
    }
    fputs("\n", script);
}

static int open_panel(path_panel *panel, const path_figure *figure, int i, const char *folder)
{
    const study_experiment of[TRACES_MAX] = {figure->first[i], figure->second[i]};
    panel->n_traces = of[0] == of[1] ? 1 : 2;
    int code = STUDY_GOOD;
    for (int j = 0; j < panel->n_traces && code == STUDY_GOOD; j++) {
        /* NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): at most TRACES_MAX */
        code = report_trace_open(&panel->traces[j], folder, of[j], 1, figure->axis[i]);
    }
    return code;
}

static double largest_of(const path_panel panels[N_PANELS])
{
    double largest_mm = 0.0;
    for (int i = 0; i < N_PANELS; i++) {
        for (int j = 0; j < panels[i].n_traces; j++) {
            largest_mm = fmax(largest_mm, report_trace_largest_mm(&panels[i].traces[j]));
        }
    }
    return largest_mm;
}

static void add_trace(report_view *view, const report_trace *trace, double enlarged)
{
    for (size_t i = 0; i < trace->n_points; i++) {
        const report_point *p = &trace->points[i];
        report_view_add(view, p->ref_mm[0], p->ref_mm[1]);
        report_view_add(view, p->ref_mm[0] + enlarged * p->off_mm[0],
                        p->ref_mm[1] + enlarged * p->off_mm[1]);
    }
}

/* One enlargement and one view for the panels of a figure, so that they can be compared. */
static void fit(path_panel panels[N_PANELS], report_view *view)
{
    const double enlarged = report_enlargement(largest_of(panels), ROOM_MM);
    *view = report_view_empty();
    for (int i = 0; i < N_PANELS; i++) {
        panels[i].enlarged = enlarged;
        panels[i].view = view;
        for (int j = 0; j < panels[i].n_traces; j++) {
            add_trace(view, &panels[i].traces[j], enlarged);
        }
    }
    report_view_margin(view, 0.04);
}

static void put_panel(report_page *page, const path_figure *figure, const path_panel *panel,
                      int i)
{
    char title[128];
    char desc[256];
    snprintf(title, sizeof title, "%s", panel_names[i]);
    snprintf(desc, sizeof desc,
             "%s, %s: largest distance from the reference %.3g mm, last point %.3g mm off.",
             figure->what, panel_names[i], report_trace_largest_mm(&panel->traces[0]),
             panel->traces[0].last_point_mm);
    report_panel(page, title, desc, REPORT_PANEL_W, REPORT_PANEL_H, draw_path, panel);
}

static void put_caption(report_page *page, const path_figure *figure,
                        const path_panel panels[N_PANELS])
{
    const exk_profile *profile = &page->paper->profiles[figure->first[N_PANELS - 1]];
    char noise[256];
    report_noise_text(profile, noise, sizeof noise);
    const bool two = panels[N_PANELS - 1].n_traces == 2;
    report_legend(page);
    report_legend_item(page, REPORT_LINE, "path", "expected path");
    report_legend_item(page, REPORT_LINE, "blue", two ? "positive force" : "tool");
    if (two) {
        report_legend_item(page, REPORT_DASHED, "orange", "negative force");
    }
    report_legend_item(page, REPORT_DOT, "blue", "last point");
    if (two) {
        report_legend_item(page, REPORT_TRIANGLE, "orange", "last point");
    }
    report_caption(page);
    fputs("Noise: ", page->out);
    report_escaped(page, noise);
    fputs(two ? "; the negative force is its mirror image, with the same white part. " : ". ",
          page->out);
    fprintf(
        page->out,
        "The noise itself is enlarged, as in the study, which gives no size: ours is stated. "
        "n = 1 run (run 1, no controller), seed %llu, trial 0, noise %s.",
        (unsigned long long)profile->timing.seed, exk_noise_word(profile));
    report_scale(page, panels[0].enlarged);
    report_figure_end(page);
}

static void put_figure(report_page *page, const path_figure *figure)
{
    path_panel panels[N_PANELS] = {{.n_traces = 0}};
    report_view view;
    int code = STUDY_GOOD;
    for (int i = 0; i < N_PANELS && code == STUDY_GOOD; i++) {
        code = open_panel(&panels[i], figure, i, page->paper->folder);
    }
    report_fail(page, code, "");
    if (code == STUDY_GOOD) {
        fit(panels, &view);
        report_figure(page, figure->id, figure->title);
        for (int i = 0; i < N_PANELS; i++) {
            put_panel(page, figure, &panels[i], i);
        }
        put_caption(page, figure, panels);
    }
    for (int i = 0; i < N_PANELS; i++) {
        for (int j = 0; j < panels[i].n_traces; j++) {
            report_trace_close(&panels[i].traces[j]);
        }
    }
}

void report_paths(report_page *page)
{
    for (size_t i = 0; i < sizeof figures / sizeof figures[0]; i++) {
        if (report_ran(page, (study_part)(STUDY_PART_S1 + i))) {
            put_figure(page, &figures[i]);
        }
    }
}
