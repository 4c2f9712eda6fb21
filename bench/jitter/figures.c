#include <math.h>
#include <stdlib.h>

#include "exk/stats.h"
#include "jitter.h"

static const double shares[JITTER_FIGURES - 1] = {0.5, 0.99, 0.999};
static const double confidence = 0.95;

void jitter_add(jitter_histogram *to, const jitter_histogram *from)
{
    for (int i = 0; i < JITTER_BINS; i++) {
        to->bin[i] += from->bin[i];
    }
    to->n += from->n;
    to->n_over += from->n_over;
    to->max_us = fmax(to->max_us, from->max_us);
}

/* The place within the bin is spread evenly, so that figures of a few us are not steps. */
static double quantile_us(const jitter_histogram *hist, double share)
{
    const double wanted = share * (double)hist->n;
    double below = 0.0;
    for (int i = 0; i < JITTER_BINS; i++) {
        const double here = (double)hist->bin[i];
        if (here > 0.0 && below + here >= wanted) {
            return i + (wanted - below) / here;
        }
        below += here;
    }
    return hist->max_us;
}

static uint64_t late(const jitter_histogram *hist, double period_us)
{
    uint64_t n = hist->n_over;
    for (int i = (int)period_us; i < JITTER_BINS; i++) {
        n += hist->bin[i];
    }
    return n;
}

jitter_figures jitter_figures_of(const jitter_histogram *hist, double period_us)
{
    jitter_figures out = {.n = hist->n, .n_late = late(hist, period_us)};
    for (int i = 0; i < JITTER_FIGURES - 1; i++) {
        out.us[i] = quantile_us(hist, shares[i]);
    }
    out.us[JITTER_FIGURES - 1] = hist->max_us;
    const exk_interval interval = exk_wilson(out.n_late, out.n, confidence);
    out.late_low = interval.low;
    out.late_high = interval.high;
    return out;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;
    return (x > y) - (x < y);
}

double jitter_median_ratio(const jitter_figures *ours, const jitter_figures *theirs, int n,
                           int figure)
{
    double ratio[JITTER_PAIRS_MAX];
    for (int i = 0; i < n; i++) {
        ratio[i] = ours[i].us[figure] / theirs[i].us[figure];
    }
    qsort(ratio, (size_t)n, sizeof ratio[0], compare);
    return 0.5 * (ratio[(n - 1) / 2] + ratio[n / 2]);
}
