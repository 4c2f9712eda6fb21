#include <math.h>

#include "noise_word.h"
#include "report_draw.h"
#include "report_figures.h"

enum { BARS_MIN = 8, BARS_MAX = 40, SPREAD_H = 250, OVERVIEW_H = 330, CLAIMS_MAX = 32 };

typedef struct {
    const study_claim *claim;
    const study_tally *tally;
    study_verdict verdict;
    double low; /* of the axis */
    double high;
} spread_panel;

/* In bars of one width over the axis, as shares of all values. */
static void put_bars(FILE *script, const spread_panel *panel)
{
    const study_tally *tally = panel->tally;
    const double n = (double)tally->moments.n, scale = panel->claim->scale;
    int n_bars = (int)fmin(BARS_MAX, fmax(BARS_MIN, 2.0 * sqrt(n)));
    double low = panel->low, width = (panel->high - panel->low) / n_bars;
    if (tally->kind == STUDY_COUNT) {
        width = scale;
        low = (floor(panel->low / scale) + 0.5) * scale;
        n_bars = (int)((panel->high - low) / width);
    }
    fputs("$bars << EOD\n", script);
    for (int i = 0; i < n_bars; i++) {
        const double from = low + i * width;
        const double share = study_tally_below(tally, (from + width) / scale) -
                             study_tally_below(tally, from / scale);
        fprintf(script, "%.9g %.9g %.9g\n", from + 0.5 * width, 100.0 * share / n, width);
    }
    fputs("EOD\n", script);
}

static void draw_spread(FILE *script, const void *ctx)
{
    const spread_panel *panel = ctx;
    const study_verdict *v = &panel->verdict;
    report_draw_style(script, panel->claim->scale < 1.0 ? "share inside" : "mm",
                      "% of studies");
    put_bars(script, panel);
    fprintf(
        script,
        "set xrange [%.9g:%.9g]\nset yrange [0:*]\nset style fill solid 0.55 noborder\n"
        "set object rect from first %.9g,graph 0 to first %.9g,graph 1 fc " BLUE
        " fs transparent solid 0.14 noborder behind\n"
        "set arrow from first %.9g,graph 0 to first %.9g,graph 1 nohead lw 2 dt (6,4) lc " INK
        " front\n"
        "set arrow from first %.9g,graph 0 to first %.9g,graph 1 nohead lw 3 lc " ORANGE
        " front\n"
        "plot $bars using 1:2:3 with boxes lc " BLUE "\n",
        panel->low, panel->high, v->prediction95.low, v->prediction95.high, v->mean, v->mean,
        panel->claim->published, panel->claim->published);
}

/* The middle 99.8 % and whatever is marked. */
static void fit_axis(spread_panel *panel)
{
    const double scale = panel->claim->scale, published = panel->claim->published;
    const double low = scale * study_tally_quantile(panel->tally, 0.001);
    const double high = scale * study_tally_quantile(panel->tally, 0.999);
    panel->low = fmin(low, published);
    panel->high = fmax(high, published);
    const double margin = fmax(0.06 * (panel->high - panel->low), 0.01 * published);
    panel->low = fmax(0.0, panel->low - margin);
    panel->high += margin;
    panel->high =
        panel->claim->scale < 1.0 ? fmin(panel->high, 1.0 + 0.5 * scale) : panel->high;
}

static void put_spread(report_page *page, const study_claim *claim)
{
    char title[96];
    char desc[256];
    spread_panel panel = {.claim = claim,
                          .tally = &page->tallies[claim->of_interval],
                          .verdict = study_judge(claim, page->tallies)};
    const study_verdict *v = &panel.verdict;
    fit_axis(&panel);
    snprintf(title, sizeof title, "%s (%s): published %g %s", claim->id,
             study_role_name(claim->role), claim->published,
             v->inside ? "✓ inside" : "✗ outside");
    snprintf(desc, sizeof desc,
             "%s. Ours: mean %.4g, 95 %% of studies of its size between %.4g and %.4g; "
             "published %g.",
             claim->what, v->mean, v->prediction95.low, v->prediction95.high, claim->published);
    report_panel(page, title, desc, REPORT_PANEL_W, SPREAD_H, draw_spread, &panel);
}

static bool drawn(const report_page *page, const study_claim *claim)
{
    return claim->role != STUDY_REFERENCE && page->tallies[claim->of_interval].moments.n > 0;
}

/* How many studies stand behind the bars, group by group. */
static void put_sizes(report_page *page)
{
    const uint64_t n_trials =
        (uint64_t)json_integer_value(json_object_get(page->result, "seeds"));
    fprintf(page->out, " n = %llu such means, %llu trials.",
            (unsigned long long)(n_trials / STUDY_GROUP), (unsigned long long)n_trials);
}

void report_spread(report_page *page)
{
    size_t n = 0;
    const study_claim *claims = study_claims(&n);
    if (json_array_size(json_object_get(page->result, "claims")) == 0) {
        return;
    }
    report_figure(page, "fig-spread", "Each published figure in its simulated distribution");
    for (size_t i = 0; i < n; i++) {
        if (drawn(page, &claims[i])) {
            put_spread(page, &claims[i]);
        }
    }
    report_legend(page);
    report_legend_item(page, REPORT_BAND, "blue",
                       "95 % prediction interval at the study's size");
    report_legend_item(page, REPORT_LINE, "orange", "published");
    report_legend_item(page, REPORT_DASHED, "ink", "our mean");
    report_caption(page);
    fputs("Bars: one value for each simulated study of the published size; S5 and S6 are means "
          "of "
          "10 simulations each, the others one trial each.",
          page->out);
    put_sizes(page);
    fprintf(page->out, " Seed %llu, noise %s.",
            (unsigned long long)page->paper->profiles[STUDY_S5].timing.seed,
            page->paper->noise);
    report_figure_end(page);
}

/* Everything over the published figure, so that one scale serves all. */
static void draw_overview(FILE *script, const void *ctx)
{
    const report_page *page = ctx;
    size_t n = 0, rows = 0;
    const study_claim *claims = study_claims(&n);
    report_draw_style(script, "ours / published", "");
    fputs("$a << EOD\n", script);
    for (size_t i = 0; i < n; i++) {
        const study_verdict v = study_judge(&claims[i], page->tallies);
        const double one = claims[i].published;
        if (drawn(page, &claims[i])) {
            rows++;
            fprintf(script, "%.9g %zu %.9g %.9g %.9g %.9g %s\n", v.mean / one, rows,
                    v.prediction95.low / one, v.prediction95.high / one, v.rounded.low / one,
                    v.rounded.high / one, claims[i].id);
        }
    }
    fprintf(script,
            "EOD\nset yrange [%zu.6:0.4]\nset xrange [0:*]\nset ytics scale 0\n"
            "unset ylabel\nset lmargin 10\n"
            "set arrow from first 1,graph 0 to first 1,graph 1 nohead lw 2 lc " ORANGE " back\n"
            "plot $a using 5:2:5:6:($2-0.3):($2+0.3):ytic(7) with boxxyerror fs transparent "
            "solid 0.3 noborder lc " ORANGE
            ", $a using 1:2:3:4 with xerrorbars lw 2.2 pt 7 ps 1.4*mark_size lc " BLUE "\n",
            rows);
}

void report_overview(report_page *page)
{
    if (json_array_size(json_object_get(page->result, "claims")) == 0) {
        return;
    }
    report_figure(page, "fig-overview", "All published figures on one scale");
    report_panel(page, "ours over published",
                 "For each published figure our mean and 95 % prediction interval, divided by "
                 "it; the table below has the numbers.",
                 REPORT_PANEL_W, OVERVIEW_H, draw_overview, page);
    report_legend(page);
    report_legend_item(page, REPORT_SPREAD, "blue",
                       "our mean, with the 95 % prediction interval");
    report_legend_item(page, REPORT_LINE, "orange", "published");
    report_legend_item(page, REPORT_BAND, "orange", "what its printed digits stand for");
    report_caption(page);
    fprintf(page->out,
            "A figure is inside when bar and band meet. n = %llu trials, seed %llu, noise %s.",
            (unsigned long long)json_integer_value(json_object_get(page->result, "seeds")),
            (unsigned long long)page->paper->profiles[STUDY_S5].timing.seed,
            page->paper->noise);
    report_figure_end(page);
}
