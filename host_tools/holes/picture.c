#include "picture.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "exk/units.h"
#include "gnuplot.h"
#include "picture_layout.h"

#define INSIDE_COLOUR "#0072B2"
#define OUTSIDE_COLOUR "#D55E00"
#define NONE_COLOUR "#666666"
#define CIRCLE_COLOUR "#8a8a8a"
#define TEXT_COLOUR "#222222"

typedef struct {
    const hole_report *report;
    picture_layout layout;
} picture;

typedef enum { MARK_INSIDE, MARK_OUTSIDE, MARK_NONE } mark;

static double mm(double metres)
{
    return EXK_MM_PER_M * metres;
}

static mark mark_of(const exk_hole_result *r)
{
    if (!picture_has_point(r)) {
        return MARK_NONE;
    }
    return r->inside ? MARK_INSIDE : MARK_OUTSIDE;
}

static size_t count(const hole_report *report, mark which)
{
    size_t n = 0;
    for (size_t i = 0; i < report->n_holes; i++) {
        n += mark_of(&report->results[i]) == which ? 1 : 0;
    }
    return n;
}

/* Text for a single-quoted string: nothing in it can end the string or start a command. */
static void put_text(FILE *out, const char *text)
{
    for (; *text != '\0'; text++) {
        const unsigned char c = (unsigned char)*text;
        fputc(c < ' ' || c == 127 || c == '\'' || c == '`' ? '?' : c, out);
    }
}

/* A line of text at pixels of the picture. */
static void label(FILE *out, double x, double y, const char *style, const char *text)
{
    fputs("set label '", out);
    put_text(out, text);
    fprintf(out, "' at screen %.5f,%.5f noenhanced %s\n", x / PICTURE_W, y / PICTURE_H, style);
}

static void put_blocks(FILE *out, const picture *p)
{
    static const char *const names[] = {"$inside", "$outside", "$none"};
    const hole_report *report = p->report;
    for (int m = MARK_INSIDE; m <= MARK_NONE; m++) {
        fprintf(out, "%s << EOD\n", names[m]);
        for (size_t i = 0; i < report->n_holes; i++) {
            const exk_hole_result *r = &report->results[i];
            const picture_point hole = picture_hole(report, i);
            if (mark_of(r) == (mark)m) {
                fprintf(out, "%.9g %.9g %.9g %.9g\n", hole.x_mm, hole.y_mm,
                        m == MARK_NONE ? 0.0 : mm(r->dx_m), m == MARK_NONE ? 0.0 : mm(r->dy_m));
            }
        }
        fputs("EOD\n", out);
    }
}

static void set_view(FILE *out, const picture_view *view)
{
    const picture_box *box = &view->box;
    fprintf(out, "set lmargin at screen %.6f\nset rmargin at screen %.6f\n",
            box->left / PICTURE_W, box->right / PICTURE_W);
    fprintf(out, "set bmargin at screen %.6f\nset tmargin at screen %.6f\n",
            box->bottom / PICTURE_H, box->top / PICTURE_H);
    fprintf(out, "set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\n", view->x_mm,
            view->x_mm + view->mm_per_px * (box->right - box->left), view->y_mm,
            view->y_mm + view->mm_per_px * (box->top - box->bottom));
}

static void put_style(FILE *out)
{
    fputs("set border 3 lc rgb '#999999'\nset tics nomirror out scale 0.6 textcolor rgb "
          "'" TEXT_COLOUR "'\n"
          "set grid lc rgb '#ececec' lt 1 lw 1\nset style fill transparent solid 0.05 border\n"
          "set multiplot\n",
          out);
}

static void put_titles(FILE *out, const picture *p)
{
    const hole_report *report = p->report;
    char text[320];
    snprintf(text, sizeof text, "%s: %zu of %zu holes inside %g mm (%.1f %%)",
             report->log->profile_name, report->accuracy.n_inside, report->n_holes,
             mm(report->tolerance_m), 100.0 * report->correct_rate);
    label(out, 78.0, 772.0, "left font ',15' tc rgb '" TEXT_COLOUR "'", text);
    snprintf(text, sizeof text,
             "judged on the %s tool tip, noise %s, run %" PRIu32 ", series %" PRIu32
             "; errors and circles enlarged %g times",
             report->on_true ? "true" : "estimated", report->noise, report->log->run,
             report->log->series, p->layout.enlarged);
    label(out, 78.0, 744.0, "left tc rgb '#555555'", text);
    if (report->n_lost > 0) {
        snprintf(text, sizeof text, "%" PRId64 " samples lost: figures are not evidence",
                 report->n_lost);
        label(out, 1370.0, 772.0, "right font ',13' tc rgb '" OUTSIDE_COLOUR "'", text);
    }
}

static void put_ids(FILE *out, const picture *p)
{
    const hole_report *report = p->report;
    for (size_t i = 0; p->layout.ids != NULL && i < report->n_holes; i++) {
        const picture_point at = p->layout.ids[i];
        if (isnan(at.x_mm)) {
            continue;
        }
        fprintf(out,
                "set label '%" PRId32 "' at first %.9g,%.9g center font ',8' tc rgb "
                "'#777777'\n",
                report->log->holes[i].id, at.x_mm, at.y_mm);
    }
}

/* A label with a white ground and a thin line to the worst point. */
static void put_worst(FILE *out, const picture *p, bool on_map)
{
    const hole_report *report = p->report;
    const picture_view *view = on_map ? &p->layout.map : &p->layout.target;
    const int32_t worst = report->accuracy.worst;
    char text[64];
    if (worst < 0 || !picture_has_point(&report->results[worst])) {
        return;
    }
    const exk_hole_result *r = &report->results[worst];
    const int32_t id = report->log->holes[worst].id;
    const int n = on_map ? snprintf(text, sizeof text, "worst: hole %" PRId32 ", %.4f mm", id,
                                    mm(r->radial_m))
                         : snprintf(text, sizeof text, "hole %" PRId32, id);
    const double w_px = 7.4 * n + 8.0;
    const double h_px = 20.0;
    const picture_point tip = on_map ? picture_tip(report, &p->layout, (size_t)worst)
                                     : (picture_point){mm(r->dx_m), mm(r->dy_m)};
    const picture_label place = picture_worst_place(report, &p->layout, on_map, w_px, h_px);
    const picture_point at = place.centre;
    fprintf(out,
            "set arrow from first %.9g,%.9g to first %.9g,%.9g nohead front lc rgb "
            "'#444444' lw 1\n",
            place.foot.x_mm, place.foot.y_mm, tip.x_mm, tip.y_mm);
    fprintf(out,
            "set object rectangle center first %.9g,%.9g size first %.9g,%.9g front fs "
            "solid 1.0 border lc rgb '#999999' fc rgb '#ffffff'\n",
            at.x_mm, at.y_mm, w_px * view->mm_per_px, h_px * view->mm_per_px);
    fprintf(out, "set label '%s' at first %.9g,%.9g center front tc rgb '" TEXT_COLOUR "'\n",
            text, at.x_mm, at.y_mm);
}

/* One entry of the plot command; nothing for marks that no hole has. */
static void put_marks(FILE *out, const hole_report *report, double scale, bool keys)
{
    static const struct {
        const char *block;
        const char *style;
        const char *words;
    } rows[] = {
        {"$inside", "pt 7 ps 0.9 lc rgb '" INSIDE_COLOUR "'", "inside"},
        {"$outside", "pt 9 ps 1.4 lc rgb '" OUTSIDE_COLOUR "'", "outside"},
        {"$none", "pt 2 ps 1.2 lw 1.5 lc rgb '" NONE_COLOUR "'", "no drilled position"},
    };
    for (int m = MARK_INSIDE; m <= MARK_NONE; m++) {
        const size_t n = count(report, (mark)m);
        if (n > 0 && keys) {
            fprintf(out, ", %s using ($1+%.9g*$3):($2+%.9g*$4) with points %s title '%s (%zu)'",
                    rows[m].block, scale, scale, rows[m].style, rows[m].words, n);
        } else if (n > 0 && m != MARK_NONE) {
            fprintf(out, ", %s using 3:4 with points %s notitle", rows[m].block, rows[m].style);
        }
    }
}

static void put_circles(FILE *out, const hole_report *report, double radius)
{
    static const char *const names[] = {"$inside", "$outside", "$none"};
    const char *lead = "plot ";
    for (int m = MARK_INSIDE; m <= MARK_NONE; m++) {
        if (count(report, (mark)m) > 0) {
            fprintf(out,
                    "%s%s using 1:2:(%.9g) with circles lc rgb '" CIRCLE_COLOUR "' notitle",
                    lead, names[m], radius);
            lead = ", ";
        }
    }
}

static void put_vectors(FILE *out, const hole_report *report, double scale)
{
    static const char *const names[] = {"$inside", "$outside"};
    static const char *const colours[] = {INSIDE_COLOUR, OUTSIDE_COLOUR};
    for (int m = MARK_INSIDE; m <= MARK_OUTSIDE; m++) {
        if (count(report, (mark)m) > 0) {
            fprintf(out,
                    ", %s using 1:2:(%.9g*$3):(%.9g*$4) with vectors nohead lw 1.4 lc rgb "
                    "'%s' notitle",
                    names[m], scale, scale, colours[m]);
        }
    }
}

static void draw_map(FILE *out, const picture *p)
{
    const hole_report *report = p->report;
    const double scale = p->layout.enlarged;
    set_view(out, &p->layout.map);
    put_titles(out, p);
    put_ids(out, p);
    put_worst(out, p, true);
    fprintf(out,
            "set key at screen %.5f,%.5f left top horizontal Left reverse samplen 1 maxrows 1 "
            "width "
            "2 tc rgb '" TEXT_COLOUR "'\n",
            70.0 / PICTURE_W, 728.0 / PICTURE_H);
    fputs("set xlabel 'x mm' offset 0,0.4 tc rgb '" TEXT_COLOUR
          "'\nset ylabel 'y mm' offset 1,0 "
          "tc rgb '" TEXT_COLOUR "'\n",
          out);
    put_circles(out, report, mm(report->tolerance_m) * scale);
    put_vectors(out, report, scale);
    put_marks(out, report, scale, true);
    fprintf(out,
            ", NaN with points pt 6 ps 1.5 lc rgb '" CIRCLE_COLOUR
            "' title 'tolerance %g mm'\n",
            mm(report->tolerance_m));
}

/* Two columns of figures under the circle. */
static void put_figure(FILE *out, int row, const char *what, const char *value)
{
    const double y = 232.0 - 22.0 * row;
    label(out, 948.0, y, "left tc rgb '#555555'", what);
    label(out, 1070.0, y, "left tc rgb '" TEXT_COLOUR "'", value);
}

static void put_run_figures(FILE *out, const hole_report *report)
{
    const exk_accuracy *a = &report->accuracy;
    char text[128];
    snprintf(text, sizeof text, "%.1f %%, 95 %% interval %.1f to %.1f %%",
             100.0 * report->correct_rate, 100.0 * report->wilson.low,
             100.0 * report->wilson.high);
    put_figure(out, 0, "inside", text);
    snprintf(text, sizeof text, "%.4f mm mean, %.4f mm largest", mm(a->mean_m), mm(a->max_m));
    put_figure(out, 1, "radial error", text);
    snprintf(text, sizeof text, "sigma %.4f mm, Ppk %.2f", mm(report->sigma_m), report->ppk);
    put_figure(out, 2, "Rayleigh", text);
    snprintf(text, sizeof text, "%.4f mm, %.4f mm", mm(report->pose.ap), mm(report->pose.rp));
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
    label(out, 948.0, 122.0, "left tc rgb '#555555'",
          "published by the study, circle of 0.03 mm:");
    for (size_t i = 0; i < n; i++) {
        snprintf(text, sizeof text, "%.1f %% inside, %.4f mm mean",
                 100.0 * refs[i].correct_rate, mm(refs[i].mean_m));
        put_figure(out, 6 + (int)i, refs[i].name, text);
    }
}

static void draw_target(FILE *out, const picture *p)
{
    const hole_report *report = p->report;
    const double tolerance = mm(report->tolerance_m);
    fputs("unset label\nunset arrow\nunset object\nunset key\n", out);
    set_view(out, &p->layout.target);
    label(out, 1180.0, 712.0, "center tc rgb '" TEXT_COLOUR "'",
          "all holes in one circle, not enlarged");
    put_worst(out, p, false);
    put_figures(out, report);
    fputs("set xlabel 'dx mm' offset 0,0.4\nset ylabel 'dy mm' offset 1,0\n", out);
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
    put_marks(out, report, 1.0, false);
    fputs("\nunset multiplot\n", out);
}

static void draw(FILE *out, const void *ctx)
{
    const picture *p = ctx;
    put_blocks(out, p);
    put_style(out);
    draw_map(out, p);
    draw_target(out, p);
}

int hole_picture_write(const hole_report *report, const char *path, char *why, size_t why_size)
{
    picture p = {.report = report};
    picture_layout_make(report, &p.layout);
    const int code = exk_plot_write(path, PICTURE_W, PICTURE_H, draw, &p, why, why_size);
    picture_layout_free(&p.layout);
    return code;
}
