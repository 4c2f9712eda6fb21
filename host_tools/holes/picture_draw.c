#include "picture_draw.h"

#include <inttypes.h>
#include <math.h>

#include "exk/units.h"

const picture_mark picture_marks[MARK_COUNT] = {
    [MARK_INSIDE] = {"pt 7 ps 0.9*mark_size", "lc rgb '" INSIDE_COLOUR "'", "inside"},
    [MARK_OUTSIDE] = {"pt 9 ps 1.4*mark_size", "lc rgb '" OUTSIDE_COLOUR "'", "outside"},
    [MARK_NONE] = {"pt 2 ps 1.2*mark_size lw 1.5", "lc rgb '" NONE_COLOUR "'",
                   "no drilled position"},
};

double picture_mm(double metres)
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

size_t picture_count(const hole_report *report, mark which)
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
void picture_put_text(FILE *out, double x, double y, const char *style, const char *text)
{
    fputs("set label '", out);
    put_text(out, text);
    fprintf(out, "' at screen %.5f,%.5f noenhanced %s\n", x / PICTURE_W, y / PICTURE_H, style);
}

/* Data of one kind of mark on one map: x, y, dx, dy in mm. False when there is none. */
bool picture_put_block(FILE *out, const picture *p, mark which, int part)
{
    const hole_report *report = p->report;
    bool any = false;
    for (size_t i = 0; i < report->n_holes; i++) {
        const exk_hole_result *r = &report->results[i];
        const picture_point hole = picture_hole(report, i);
        if (mark_of(r) != which || (part >= 0 && picture_part(report, &p->layout, i) != part)) {
            continue;
        }
        if (!any) {
            fprintf(out, "$data%d << EOD\n", which);
            any = true;
        }
        const bool none = which == MARK_NONE;
        fprintf(out, "%.9g %.9g %.9g %.9g\n", hole.x_mm, hole.y_mm,
                none ? 0.0 : picture_mm(r->dx_m), none ? 0.0 : picture_mm(r->dy_m));
    }
    fputs(any ? "EOD\n" : "", out);
    return any;
}

void picture_set_view(FILE *out, const picture_view *view)
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

/* A label with a white ground and a thin line to the worst point. */
static void put_worst_label(FILE *out, const picture *p, bool on_map)
{
    const hole_report *report = p->report;
    const picture_view *view = on_map ? &p->layout.map[0] : &p->layout.target;
    const int32_t worst = report->accuracy.worst;
    char text[64];
    const exk_hole_result *r = &report->results[worst];
    const int32_t id = report->log->holes[worst].id;
    const int n = on_map ? snprintf(text, sizeof text, "worst: hole %" PRId32 ", %.4f mm", id,
                                    picture_mm(r->radial_m))
                         : snprintf(text, sizeof text, "hole %" PRId32, id);
    const double w_px = 7.4 * n + 8.0;
    const double h_px = 20.0;
    const picture_point tip = on_map
                                  ? picture_tip(report, &p->layout, (size_t)worst)
                                  : (picture_point){picture_mm(r->dx_m), picture_mm(r->dy_m)};
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

/* On the map the worst hole is on, or in the circle (part -1). */
void picture_put_worst(FILE *out, const picture *p, int part)
{
    const int32_t worst = p->report->accuracy.worst;
    if (worst < 0 || !picture_has_point(&p->report->results[worst])) {
        return;
    }
    if (part < 0 || part == picture_part(p->report, &p->layout, (size_t)worst)) {
        put_worst_label(out, p, part >= 0);
    }
}
