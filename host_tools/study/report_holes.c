#include "report_holes.h"

#include <math.h>

#include "report_draw.h"

void report_put_holes(FILE *script, const report_trace *trace)
{
    for (int inside = 0; inside < 2; inside++) {
        fprintf(script, "$%s << EOD\n", inside ? "inside" : "outside");
        for (size_t i = 0; i < trace->n_holes; i++) {
            const report_hole *h = &trace->holes[i];
            if (h->inside == (inside == 1)) {
                fprintf(script, "%.6g %.6g %.6g %.6g %zu %.6g\n", h->target_mm[0],
                        h->target_mm[1], h->off_mm[0], h->off_mm[1], i + 1, h->radial_mm);
            }
        }
        fputs("EOD\n", script);
    }
    fputs("$all << EOD\n", script);
    for (size_t i = 0; i < trace->n_holes; i++) {
        fprintf(script, "%.6g %.6g\n", trace->holes[i].target_mm[0],
                trace->holes[i].target_mm[1]);
    }
    fputs("EOD\n", script);
}

static bool any(const report_trace *trace, bool inside)
{
    for (size_t i = 0; i < trace->n_holes; i++) {
        if (trace->holes[i].inside == inside) {
            return true;
        }
    }
    return false;
}

/* An empty data block is an error to gnuplot. */
void report_put_marks(FILE *script, const report_trace *trace, const char *using)
{
    if (any(trace, true)) {
        fprintf(script, ", $inside using %s with points pt 7 ps 1.2*mark_size lc " GOOD, using);
    }
    if (any(trace, false)) {
        fprintf(script, ", $outside using %s with points pt 2 lw 2 ps 1.5*mark_size lc " BAD,
                using);
    }
}

void report_draw_map(FILE *script, const void *ctx)
{
    const report_map *panel = ctx;
    const report_trace *trace = panel->trace;
    char using[96];
    report_view view = report_view_empty();
    for (size_t i = 0; i < trace->n_holes; i++) {
        report_view_add(&view, trace->holes[i].target_mm[0], trace->holes[i].target_mm[1]);
    }
    report_view_margin(&view, 0.12);
    report_draw_style(script, "x, mm", "y, mm");
    report_draw_plane(script, &view);
    report_put_holes(script, trace);
    snprintf(using, sizeof using, "($1+%g*$3):($2+%g*$4)", panel->enlarged, panel->enlarged);
    fprintf(script,
            "plot $all using 1:2:(%.6g) with circles lw 1.3 lc " PATH
            ", $all using 1:2 with points pt 1 ps 0.8*mark_size lc " PATH,
            panel->enlarged * trace->tolerance_mm);
    if (panel->start) {
        fputs(", $all every ::0::0 using 1:2 with points pt 4 ps 3.4*mark_size lw 1.5 lc " INK,
              script);
    }
    report_put_marks(script, trace, using);
    fputs("\n", script);
}

/* Half the smallest distance of two targets is what an error may be drawn as long as. */
double report_room_mm(const report_trace *trace)
{
    double nearest_mm = INFINITY;
    for (size_t i = 1; i < trace->n_holes; i++) {
        const double *a = trace->holes[i].target_mm, *b = trace->holes[i - 1].target_mm;
        nearest_mm = fmin(nearest_mm, hypot(a[0] - b[0], a[1] - b[1]));
    }
    return 0.5 * nearest_mm;
}

double report_worst_mm(const report_trace *trace)
{
    double worst = trace->tolerance_mm;
    for (size_t i = 0; i < trace->n_holes; i++) {
        worst = fmax(worst, trace->holes[i].radial_mm);
    }
    return worst;
}

size_t report_n_inside(const report_trace *trace)
{
    size_t n = 0;
    for (size_t i = 0; i < trace->n_holes; i++) {
        n += trace->holes[i].inside;
    }
    return n;
}

void report_hole_legend(report_page *page, double tolerance_mm)
{
    char words[96];
    snprintf(words, sizeof words, "inside %g mm", tolerance_mm);
    report_legend_item(page, REPORT_DOT, "good", words);
    snprintf(words, sizeof words, "outside %g mm", tolerance_mm);
    report_legend_item(page, REPORT_CROSS, "bad", words);
}
