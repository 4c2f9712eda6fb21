#include "report_draw.h"

#include <math.h>

void report_draw_style(FILE *script, const char *x_label, const char *y_label)
{
    fprintf(script,
            "set border 3 lc " MUTED "\nset tics nomirror out scale 0.5 textcolor " MUTED "\n"
            "set grid lc " GRID " lt 1 lw 1\nunset key\n"
            "set xlabel '%s' offset 0,0.3 tc " INK "\nset ylabel '%s' offset 0.3,0 tc " INK
            "\n",
            x_label, y_label);
}

double report_tic_step(double range, int n)
{
    static const double steps[] = {1.0, 2.0, 5.0, 10.0};
    const double decade = pow(10.0, floor(log10(range / n)));
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
        if (range <= n * steps[i] * decade) {
            return steps[i] * decade;
        }
    }
    return 10.0 * decade;
}

void report_draw_plane(FILE *script, const report_view *view)
{
    const double width = view->high[0] - view->low[0];
    const double height = view->high[1] - view->low[1];
    const double step = report_tic_step(fmax(width, 1.35 * height), 10);
    fprintf(script,
            "set size ratio -1\nset xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\n"
            "set xtics %g\nset ytics %g\n",
            view->low[0], view->high[0], view->low[1], view->high[1], step, step);
}

report_view report_view_empty(void)
{
    return (report_view){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
}

void report_view_add(report_view *view, double x, double y)
{
    view->low[0] = fmin(view->low[0], x);
    view->low[1] = fmin(view->low[1], y);
    view->high[0] = fmax(view->high[0], x);
    view->high[1] = fmax(view->high[1], y);
}

void report_view_margin(report_view *view, double margin)
{
    const double size = fmax(view->high[0] - view->low[0], view->high[1] - view->low[1]);
    for (int i = 0; i < 2; i++) {
        view->low[i] -= margin * size;
        view->high[i] += margin * size;
    }
}

double report_enlargement(double largest, double room)
{
    static const double steps[] = {1.0, 2.0, 3.0, 5.0};
    double best = 1.0;
    for (double decade = 1.0; decade < 1e9 && largest > 0.0; decade *= 10.0) {
        for (int i = 0; i < 4; i++) {
            best = steps[i] * decade * largest <= room ? steps[i] * decade : best;
        }
    }
    return best;
}
