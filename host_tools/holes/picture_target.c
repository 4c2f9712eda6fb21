#include <stdio.h>

#include "picture_draw.h"

/* Two columns of figures under the circle. */
static void put_figure(FILE *out, int row, const char *what, const char *value)
{
    const double y = 232.0 - 22.0 * row;
    picture_put_text(out, 948.0, y, "left tc rgb '#555555'", what);
    picture_put_text(out, 1070.0, y, "left tc rgb '" TEXT_COLOUR "'", value);
}

static void put_run_figures(FILE *out, const hole_report *report)
{
    const exk_accuracy *a = &report->accuracy;
    char text[128];
    snprintf(text, sizeof text, "%.1f %%, 95 %% interval %.1f to %.1f %%",
             100.0 * report->correct_rate, 100.0 * report->wilson.low,
             100.0 * report->wilson.high);
    put_figure(out, 0, "inside", text);
    snprintf(text, sizeof text, "%.4f mm mean, %.4f mm largest", picture_mm(a->mean_m),
             picture_mm(a->max_m));
    put_figure(out, 1, "radial error", text);
    snprintf(text, sizeof text, "sigma %.4f mm, Ppk %.2f", picture_mm(report->sigma_m),
             hole_tidy(report->ppk));
    put_figure(out, 2, "Rayleigh", text);
    if (a->n_drilled > 1) {
        snprintf(text, sizeof text, "%.4f mm, %.4f mm", picture_mm(report->pose.ap),
                 picture_mm(report->pose.rp));
    } else {
        snprintf(text, sizeof text, "%.4f mm, no RP of one hole", picture_mm(report->pose.ap));
    }
    put_figure(out, 3, "AP, RP", text);
}

static void put_figures(FILE *out, const hole_report *report)
{
    size_t n = 0;
    const exk_reference *refs = exk_references(&n);
    char text[128];
    if (report->accuracy.n_drilled > 0) {
        put_run_figures(out, report);
    }
    picture_put_text(out, 948.0, 122.0, "left tc rgb '#555555'",
                     "published by the study, circle of 0.03 mm:");
    for (size_t i = 0; i < n; i++) {
        snprintf(text, sizeof text, "%.1f %% inside, %.4f mm mean",
                 100.0 * refs[i].correct_rate, picture_mm(refs[i].mean_m));
        put_figure(out, 6 + (int)i, refs[i].name, text);
    }
}

static void put_errors(FILE *out, mark which, bool any)
{
    if (any) {
        fprintf(out, ", $data%d using 3:4 with points %s %s notitle", which,
                picture_marks[which].style, picture_marks[which].colour);
    }
}

void picture_put_target(FILE *out, const picture *p)
{
    const hole_report *report = p->report;
    const double tolerance = picture_mm(report->tolerance_m);
    picture_set_view(out, &p->layout.target);
    picture_put_text(out, 1180.0, 712.0, "center tc rgb '" TEXT_COLOUR "'",
                     "all holes in one circle, not enlarged");
    picture_put_worst(out, p, -1);
    put_figures(out, report);
    fputs("set xlabel 'dx mm' offset 0,0.4 tc rgb '" TEXT_COLOUR "'\n"
          "set ylabel 'dy mm' offset 1,0 tc rgb '" TEXT_COLOUR "'\n",
          out);
    const bool inside = picture_put_block(out, p, MARK_INSIDE, -1);
    const bool outside = picture_put_block(out, p, MARK_OUTSIDE, -1);
    fprintf(out,
            "plot '+' using (0):(0):(%.9g) every ::0::0 with circles lc rgb '" CIRCLE_COLOUR
            "' notitle",
            tolerance);
    for (int ring = 1; ring <= 2; ring++) {
        fprintf(
            out,
            ", '+' using (0):(0):(%.9g) every ::0::0 with circles lc rgb '#d4d4d4' fs empty "
            "border rgb '#d4d4d4' notitle",
            tolerance * ring / 3.0);
    }
    put_errors(out, MARK_INSIDE, inside);
    put_errors(out, MARK_OUTSIDE, outside);
    fputs("\nunset multiplot\n", out);
}
