#include "path_picture.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "exk/units.h"
#include "gnuplot.h"
#include "path_points.h"

enum { WIDTH = 1100, HEIGHT = 1000, MAX_IDS = 60 };
#define REFERENCE_COLOUR "#8a8a8a"
#define DRILLED_COLOUR "#0072B2"
#define ID_COLOUR "#444444"
#define BAND_COLOUR "#9ccbe8" /* DRILLED_COLOUR on white */
#define JUDGED_COLOUR "#D55E00"
#define TEXT_COLOUR "#222222"

/* Places in the picture, as shares of it. */
static const double left = 0.075;
static const double right = 0.975;
static const double path_bottom = 0.40;
static const double path_top = 0.905;
static const double error_bottom = 0.065;
static const double error_top = 0.29;

static const double share_of_extent = 0.06; /* the largest error, as it is drawn */
static const double room_around = 1.2;
static const double smallest_extent_mm = 1e-3;

typedef struct {
    const exk_run_log *log;
    path_points points;
    double low_mm[2];
    double high_mm[2];
    double enlarged;
} picture;

static void find_extent(picture *p)
{
    for (int j = 0; j < 2; j++) {
        p->low_mm[j] = INFINITY;
        p->high_mm[j] = -INFINITY;
        for (size_t i = 0; i < p->points.path.n; i++) {
            p->low_mm[j] = fmin(p->low_mm[j], p->points.path.at[i].ref_mm[j]);
            p->high_mm[j] = fmax(p->high_mm[j], p->points.path.at[i].ref_mm[j]);
        }
    }
}

static double extent_mm(const picture *p)
{
    const double x = p->high_mm[0] - p->low_mm[0];
    return fmax(fmax(x, p->high_mm[1] - p->low_mm[1]), smallest_extent_mm);
}

/* 1, 2, 5, 10, ...: the largest that keeps the worst error a small share of the picture. */
static double enlargement(const picture *p)
{
    static const double steps[] = {1.0, 2.0, 5.0};
    const double most = share_of_extent * extent_mm(p) / p->points.worst_mm;
    if (!(most > 1.0) || !isfinite(most)) {
        return 1.0;
    }
    const double decade = pow(10.0, floor(log10(most)));
    double best = decade;
    for (int i = 0; i < 3; i++) {
        best = steps[i] * decade <= most ? steps[i] * decade : best;
    }
    return best;
}

static void put_block(FILE *out, const char *name, const path_list *list)
{
    fprintf(out, "%s << EOD\n", name);
    for (size_t i = 0; i < list->n; i++) {
        const path_point *p = &list->at[i];
        fprintf(out, "%.6f %.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", p->time_s, p->ref_mm[0],
                p->ref_mm[1], p->off_mm[0], p->off_mm[1], p->radial_mm[0], p->radial_mm[1],
                p->radial_mm[2]);
    }
    fputs("EOD\n", out);
}

static void put_style(FILE *out)
{
    fputs("set border 3 lc rgb '#999999'\n"
          "set tics nomirror out scale 0.6 textcolor rgb '" TEXT_COLOUR "'\n"
          "set grid lc rgb '#ececec' lt 1 lw 1\n"
          "set multiplot\n",
          out);
}

static void set_box(FILE *out, double bottom, double top)
{
    fprintf(out,
            "set lmargin at screen %g\nset rmargin at screen %g\nset bmargin at screen %g\n"
            "set tmargin at screen %g\n",
            left, right, bottom, top);
    fprintf(out,
            "set key at screen %g,%g left bottom horizontal Left reverse samplen 2 width 1 "
            "maxrows 1 tc rgb '" TEXT_COLOUR "'\n",
            left, top + 0.008);
}

/* Equal scale on both axes, the path in the middle. */
static void set_ranges(FILE *out, const picture *p)
{
    const double box_px[2] = {WIDTH * (right - left), HEIGHT * (path_top - path_bottom)};
    double mm_per_px = smallest_extent_mm / box_px[0];
    for (int j = 0; j < 2; j++) {
        mm_per_px = fmax(mm_per_px, room_around * (p->high_mm[j] - p->low_mm[j]) / box_px[j]);
    }
    for (int j = 0; j < 2; j++) {
        const double middle = 0.5 * (p->low_mm[j] + p->high_mm[j]);
        const double half = 0.5 * mm_per_px * box_px[j];
        fprintf(out, "set %crange [%.9g:%.9g]\n", "xy"[j], middle - half, middle + half);
    }
}

/* Each id on the side of its hole where the drilled mark is not. */
static void put_ids(FILE *out, const picture *p)
{
    const exk_run_log *log = p->log;
    for (size_t i = 0; i < log->n_holes && log->n_holes <= MAX_IDS; i++) {
        double side[2] = {1.0, 1.0};
        for (size_t j = 0; j < p->points.judged.n; j++) {
            const path_point *judged = &p->points.judged.at[j];
            for (int axis = 0; axis < 2 && judged->hole_id == log->holes[i].id; axis++) {
                side[axis] = judged->off_mm[axis] > 0.0 ? -1.0 : 1.0;
            }
        }
        fprintf(out,
                "set label '%" PRId32 "' at %.9g,%.9g center offset %g,%g front tc rgb "
                "'" ID_COLOUR "'\n",
                log->holes[i].id, EXK_MM_PER_M * log->holes[i].target_m[0],
                EXK_MM_PER_M * log->holes[i].target_m[1], 2.4 * side[0], 1.2 * side[1]);
    }
}

/* Nothing in the name can end the quoted string or start a command. */
static void put_title(FILE *out, const exk_run_log *log)
{
    fputs("set label '", out);
    for (const char *c = log->profile_name; *c != '\0'; c++) {
        fputc((unsigned char)*c < ' ' || *c == '\'' || *c == '`' ? '?' : *c, out);
    }
    fprintf(out,
            ", run %" PRIu32 " of series %" PRIu32 ": %" PRId64 " samples, %" PRId64 " lost'",
            log->run, log->series, log->n_poses, log->n_lost);
    fprintf(out, " at screen %g,0.965 left noenhanced font ',14' tc rgb '" TEXT_COLOUR "'\n",
            left);
}

/* What the blue line is: on which tip, of which samples, how much enlarged. */
static void put_path_name(FILE *out, const picture *p)
{
    fprintf(out, "%s path", p->points.on_true ? "true" : "estimated");
    if (p->points.stretch > 1) {
        fprintf(out, ", 1 sample in %" PRId64, p->points.stretch);
    }
    if (p->enlarged > 1.0) {
        fprintf(out, ", error enlarged %g times", p->enlarged);
    }
}

static void draw_path(FILE *out, const picture *p)
{
    put_title(out, p->log);
    put_ids(out, p);
    set_box(out, path_bottom, path_top);
    set_ranges(out, p);
    fputs("set xlabel 'x mm'\nset ylabel 'y mm'\n", out);
    fprintf(out,
            "plot $path using ($2+%.9g*$4):($3+%.9g*$5) with lines lw 0.8 lc rgb "
            "'" DRILLED_COLOUR "' title '",
            p->enlarged, p->enlarged);
    put_path_name(out, p);
    fputs("', $path using 2:3 with lines lw 1.2 lc rgb '" REFERENCE_COLOUR
          "' title 'reference'",
          out);
    if (p->points.judged.n > 0) {
        fprintf(
            out,
            ", $judged using ($2+%.9g*$4):($3+%.9g*$5) with points pt 7 ps 0.8*mark_size lc "
            "rgb '" JUDGED_COLOUR "' title 'drilled here'",
            p->enlarged, p->enlarged);
    }
    fputc('\n', out);
}

/* Where a point stands for many samples: a band from least to most, and their mean. */
static void draw_error(FILE *out, const picture *p)
{
    set_box(out, error_bottom, error_top);
    fputs("unset label\nset xlabel 'time s'\nset ylabel 'radial error mm'\n"
          "set yrange [0:*]\n",
          out);
    fprintf(out, "set xrange [*:%.9g] noextend\nplot ", p->points.last.time_s + p->log->dt_s);
    if (p->points.stretch > 1) {
        fprintf(out,
                "$path using 1:6:8 with filledcurves fs solid noborder lc rgb '" BAND_COLOUR
                "' title 'least to most of %" PRId64 " samples', ",
                p->points.stretch);
    }
    fprintf(out, "$path using 1:7 with lines lw 1 lc rgb '" DRILLED_COLOUR "' title '%s'",
            p->points.stretch > 1 ? "mean" : "off the reference");
    if (p->points.judged.n > 0) {
        fputs(", $judged using 1:7 with points pt 7 ps 0.8*mark_size lc rgb '" JUDGED_COLOUR
              "' title 'judged'",
              out);
    }
    if (p->log->tolerance_m > 0.0) {
        const double tolerance_mm = EXK_MM_PER_M * p->log->tolerance_m;
        fprintf(out, ", %.9g with lines dt 2 lc rgb '" TEXT_COLOUR "' title 'tolerance %g mm'",
                tolerance_mm, tolerance_mm);
    }
    fputs("\nunset multiplot\n", out);
}

static void draw(FILE *out, const void *ctx)
{
    const picture *p = ctx;
    put_block(out, "$path", &p->points.path);
    put_block(out, "$judged", &p->points.judged);
    put_style(out);
    draw_path(out, p);
    draw_error(out, p);
}

static void add_point(void *ctx, const exk_wire_pose *pose)
{
    path_points_add(ctx, pose);
}

/* A second pass over the log: now it is known how many samples share a point. */
static bool collect(const exk_run_log *log, const char *log_path, path_points *points,
                    char *why, size_t why_size)
{
    exk_run_log again;
    path_points_init(points, log->n_poses);
    exk_run_log_init(&again);
    again.only_run_id = log->run_id;
    again.keep_none = true;
    again.on_pose = add_point;
    again.ctx = points;
    const bool ok = exk_run_log_read(&again, log_path, why, why_size);
    exk_run_log_free(&again);
    path_points_end(points);
    if (ok && points->failed) {
        snprintf(why, why_size, "no memory for the points of a picture");
    }
    return ok && !points->failed;
}

int path_picture_write(const exk_run_log *log, const char *log_path, const char *path,
                       char *why, size_t why_size)
{
    picture p = {.log = log};
    int code = 3;
    if (log->n_poses == 0) {
        snprintf(why, why_size, "%s: no sample was seen: there is no path to draw", path);
        return 2;
    }
    if (collect(log, log_path, &p.points, why, why_size)) {
        find_extent(&p);
        p.enlarged = enlargement(&p);
        code = exk_plot_write(path, WIDTH, HEIGHT, draw, &p, why, why_size);
    }
    path_points_free(&p.points);
    return code;
}
