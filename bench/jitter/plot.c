#include <math.h>
#include <stdio.h>

#include "gnuplot.h"
#include "jitter.h"

typedef struct {
    const jitter_result *results;
    int n;
} pictures;

/* Share of the wake-ups that came later than each place where it changes. */
static void put_data(FILE *script, const jitter_histogram *hist, const char *name, int i)
{
    uint64_t above = hist->n;
    fprintf(script, "$%s%d << EOD\n", name, i);
    for (int bin = 0; bin < JITTER_BINS; bin++) {
        if (hist->bin[bin] > 0) {
            above -= hist->bin[bin];
            fprintf(script, "%d %.9g\n", bin + 1, fmax((double)above / (double)hist->n, 1e-9));
        }
    }
    fprintf(script, "EOD\n");
}

static void draw(FILE *script, const void *ctx)
{
    const pictures *p = ctx;
    const int rows = (p->n + 1) / 2;
    fprintf(script,
            "set multiplot layout %d,%d\nset logscale xy\nset xlabel 'lateness, us'\n"
            "set ylabel 'share later'\nset yrange [1e-6:1]\nset xrange [1:20000]\n"
            "set format y '10^{%%L}'\nset key bottom left\nset grid\n",
            rows, p->n > 1 ? 2 : 1);
    for (int i = 0; i < p->n; i++) {
        const jitter_case *what = &p->results[i].what;
        put_data(script, &p->results[i].sum_ours, "ours", i);
        put_data(script, &p->results[i].sum_theirs, "theirs", i);
        fprintf(script,
                "set title '%.0f Hz, %s, %s'\nplot $ours%d with steps lw 2 title 'exk', "
                "$theirs%d with steps lw 2 title 'cyclictest'\n",
                what->rate_Hz, what->loaded ? "loaded" : "idle",
                what->privileged ? "FIFO" : "ordinary", i, i);
    }
    fprintf(script, "unset multiplot\n");
}

int jitter_plot(const jitter_result *results, int n, const char *path)
{
    const pictures p = {results, n};
    char why[512];
    const int code = exk_plot_write(path, 1000, 350 * ((n + 1) / 2), draw, &p, why, sizeof why);
    if (code != 0) {
        fprintf(stderr, "exk-jitter: %s\n", why);
    }
    return code;
}
