#include "picture.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "exk/plural.h"
#include "gnuplot.h"
#include "picture_draw.h"

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
             picture_mm(report->tolerance_m), 100.0 * report->correct_rate);
    picture_put_text(out, 78.0, 772.0, "left font ',15' tc rgb '" TEXT_COLOUR "'", text);
    snprintf(text, sizeof text,
             "judged on the %s tool tip, noise %s, run %" PRIu32 ", series %" PRIu32
             ", seed %" PRIu64 "; errors and circles enlarged %g times",
             report->on_true ? "true" : "estimated", report->noise, report->log->run,
             report->log->series, report->log->seed, p->layout.enlarged);
    picture_put_text(out, 78.0, 744.0, "left tc rgb '#555555'", text);
    if (report->n_lost > 0) {
        snprintf(text, sizeof text, "%" PRId64 " sample%s lost: figures are not evidence",
                 report->n_lost, exk_plural_s(report->n_lost));
        picture_put_text(out, 1370.0, 772.0, "right font ',13' tc rgb '" OUTSIDE_COLOUR "'",
                         text);
    }
}

static void put_ids(FILE *out, const picture *p, int part)
{
    const hole_report *report = p->report;
    for (size_t i = 0; p->layout.ids != NULL && i < report->n_holes; i++) {
        const picture_point at = p->layout.ids[i];
        if (isnan(at.x_mm) || picture_part(report, &p->layout, i) != part) {
            continue;
        }
        fprintf(out,
                "set label '%" PRId32 "' at first %.9g,%.9g center font ',8' tc rgb "
                "'#777777'\n",
                report->log->holes[i].id, at.x_mm, at.y_mm);
    }
}

/* Circles, error vectors and points of one kind of mark. */
static void put_marks(FILE *out, mark which, double radius, double scale)
{
    fprintf(out, ", $data%d using 1:2:(%.9g) with circles lc rgb '" CIRCLE_COLOUR "' notitle",
            which, radius);
    fprintf(out,
            ", $data%d using 1:2:(%.9g*$3):(%.9g*$4) with vectors nohead lw 1.4 %s notitle",
            which, scale, scale, picture_marks[which].colour);
    fprintf(out, ", $data%d using ($1+%.9g*$3):($2+%.9g*$4) with points %s %s notitle", which,
            scale, scale, picture_marks[which].style, picture_marks[which].colour);
}

static void put_map(FILE *out, const picture *p, int part)
{
    const double scale = p->layout.enlarged;
    const double radius = picture_mm(p->report->tolerance_m) * scale;
    bool any[MARK_COUNT];
    for (int m = 0; m < MARK_COUNT; m++) {
        any[m] = picture_put_block(out, p, (mark)m, part);
    }
    fputs("plot NaN notitle", out);
    for (int m = 0; m < MARK_COUNT; m++) {
        if (any[m]) {
            put_marks(out, (mark)m, radius, scale);
        }
    }
}

/* Ids that would cover something are left out; the table and the CSV have them all. */
static size_t count_left_out(const picture *p)
{
    size_t n = p->layout.ids == NULL ? p->report->n_holes : 0;
    for (size_t i = 0; p->layout.ids != NULL && i < p->report->n_holes; i++) {
        n += isnan(p->layout.ids[i].x_mm) ? 1 : 0;
    }
    return n;
}

/* The key names the marks that some hole has. */
static void put_key(FILE *out, const picture *p)
{
    const hole_report *report = p->report;
    const size_t left_out = count_left_out(p);
    for (int m = 0; m < MARK_COUNT; m++) {
        const size_t n = picture_count(report, (mark)m);
        if (n > 0) {
            fprintf(out, ", NaN with points %s %s title '%s (%zu)'", picture_marks[m].style,
                    picture_marks[m].colour, picture_marks[m].words, n);
        }
    }
    fprintf(out,
            ", NaN with points pt 6 ps 1.5*mark_size lc rgb '" CIRCLE_COLOUR
            "' title 'tolerance %g mm'",
            picture_mm(report->tolerance_m));
    if (left_out > 0) {
        fprintf(out, ", NaN with points pt -1 title '%zu id%s without room'", left_out,
                exk_plural_s((int64_t)left_out));
    }
}

static void set_axes(FILE *out, bool x, bool y)
{
    fputs(x ? "set xlabel 'x mm' offset 0,0.4 tc rgb '" TEXT_COLOUR "'\n" : "unset xlabel\n",
          out);
    fputs(y ? "set ylabel 'y mm' offset 1,0 tc rgb '" TEXT_COLOUR "'\n" : "unset ylabel\n",
          out);
}

static void draw_maps(FILE *out, const picture *p)
{
    const int last = p->layout.n_maps - 1;
    const bool along_y = p->layout.along_y;
    fprintf(out,
            "set key at screen %.5f,%.5f left top horizontal Left reverse samplen 1 maxrows 1 "
            "width 2 tc rgb '" TEXT_COLOUR "'\n",
            70.0 / PICTURE_W, 728.0 / PICTURE_H);
    put_titles(out, p);
    for (int part = 0; part <= last; part++) {
        picture_set_view(out, &p->layout.map[part]);
        set_axes(out, along_y || part == last, !along_y || part == 0);
        put_ids(out, p, part);
        picture_put_worst(out, p, part);
        put_map(out, p, part);
        if (part == 0) {
            put_key(out, p);
        }
        fputs("\nunset label\nunset arrow\nunset object\nunset key\n", out);
    }
}

static void draw(FILE *out, const void *ctx)
{
    const picture *p = ctx;
    put_style(out);
    draw_maps(out, p);
    picture_put_target(out, p);
}

int hole_picture_write(const hole_report *report, const char *path, char *why, size_t why_size)
{
    picture p = {.report = report};
    picture_layout_make(report, &p.layout);
    const int code = exk_plot_write(path, PICTURE_W, PICTURE_H, draw, &p, why, why_size);
    picture_layout_free(&p.layout);
    return code;
}
