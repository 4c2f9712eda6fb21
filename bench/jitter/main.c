/** exk-jitter: our tick grid beside cyclictest, in turns. See jitter.h for what is measured. */
#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "exk/args.h"
#include "exk/version.h"
#include "jitter.h"

enum {
    KEY_SECONDS = 256,
    KEY_PAIRS,
    KEY_CPU,
    KEY_JSON,
    KEY_PLOT,
    KEY_RATE,
    KEY_HOST,
    KEY_RIGHTS
};
enum { CASES = 8, EXIT_MISSED = 1, EXIT_INPUT = 2 };

static const char doc[] =
    "Measures how late ticks begin, for the pacer of exk-loop and for cyclictest in\n"
    "turns on one core: at 1 and 10 kHz, on an idle and on a loaded host, with and\n"
    "without real-time rights.\v"
    "The load is one CPU hog a processor and a disk writer in the current folder.\n"
    "Needs cyclictest (Debian rt-tests), which wants root. Without rights ours runs\n"
    "as nobody, cyclictest as root with SCHED_OTHER. The whole run takes 8 x pairs\n"
    "x 2 x seconds, 54 minutes; --rate, --host and --rights choose a part.\n"
    "\n"
    "Example:\n"
    "  exk-jitter --rate 1000 --host idle --rights fifo --plot jitter.svg\n"
    "\n"
    "Exit status: 0 median ratios of p50 and p99 at most 1.2, 1 one is above,\n"
    "2 wrong use, 3 a measurement or a file failed.";

static const struct argp_option options[] = {
    {"seconds", KEY_SECONDS, "S", 0, "Length of one stretch (default 20)", 0},
    {"pairs", KEY_PAIRS, "N", 0, "Pairs of stretches a condition (default 10)", 0},
    {"cpu", KEY_CPU, "N", 0, "Processor for both (default 1)", 0},
    {"rate", KEY_RATE, "HZ", 0, "1000 or 10000 alone", 0},
    {"host", KEY_HOST, "WORD", 0, "idle or loaded alone", 0},
    {"rights", KEY_RIGHTS, "WORD", 0, "fifo or ordinary alone", 0},
    {"json", KEY_JSON, "FILE", 0, "Figures of every stretch as JSON", 0},
    {"plot", KEY_PLOT, "FILE", 0, "Picture, FILE.svg or FILE.png", 0},
    {0},
};

typedef struct {
    jitter_case what; /* seconds, pairs, cpu */
    const char *rate;
    const char *host;
    const char *rights;
    const char *json;
    const char *plot;
} jitter_options;

static const char *one_of(struct argp_state *state, const char *what, const char *arg,
                          const char *a, const char *b)
{
    if (strcmp(arg, a) != 0 && strcmp(arg, b) != 0) {
        argp_error(state, "%s %s: %s or %s is allowed", what, arg, a, b);
    }
    return arg;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    jitter_options *out = state->input;
    switch (key) {
    case KEY_SECONDS:
        out->what.seconds = exk_args_positive(state, "--seconds", arg, "seconds");
        return 0;
    case KEY_PAIRS:
        out->what.n_pairs = (int)exk_args_whole(state, "--pairs", arg, 1, JITTER_PAIRS_MAX);
        return 0;
    case KEY_CPU:
        out->what.cpu = (int)exk_args_whole(state, "--cpu", arg, 0, 1023);
        return 0;
    case KEY_RATE:
        out->rate = one_of(state, "--rate", arg, "1000", "10000");
        return 0;
    case KEY_HOST:
        out->host = one_of(state, "--host", arg, "idle", "loaded");
        return 0;
    case KEY_RIGHTS:
        out->rights = one_of(state, "--rights", arg, "fifo", "ordinary");
        return 0;
    case KEY_JSON:
        out->json = arg;
        return 0;
    case KEY_PLOT:
        out->plot = arg;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static bool wanted(const jitter_options *o, int i)
{
    const bool fast = (i & 1) != 0;
    const bool loaded = (i & 2) != 0;
    const bool ordinary = (i & 4) != 0;
    return (o->rate == NULL || fast == (strcmp(o->rate, "10000") == 0)) &&
           (o->host == NULL || loaded == (strcmp(o->host, "loaded") == 0)) &&
           (o->rights == NULL || ordinary == (strcmp(o->rights, "ordinary") == 0));
}

static int stretch(jitter_result *r, int pair, bool ours)
{
    static jitter_histogram hist;
    const double period_us = 1e6 / r->what.rate_Hz;
    const int code = ours ? jitter_ours(&r->what, &hist) : jitter_theirs(&r->what, &hist);
    jitter_add(ours ? &r->sum_ours : &r->sum_theirs, &hist);
    *(ours ? &r->ours[pair] : &r->theirs[pair]) = jitter_figures_of(&hist, period_us);
    return code;
}

static int run_pair(jitter_result *r, int pair)
{
    const bool ours_first = pair % 2 == 0;
    int code = stretch(r, pair, ours_first);
    if (code == 0) {
        code = stretch(r, pair, !ours_first);
    }
    fprintf(stderr,
            "exk-jitter: %.0f Hz %s %s: pair %d of %d: p50 %.1f and %.1f us, p99 %.1f and %.1f "
            "us\n",
            r->what.rate_Hz, r->what.loaded ? "loaded" : "idle",
            r->what.privileged ? "FIFO" : "ordinary", pair + 1, r->what.n_pairs,
            r->ours[pair].us[0], r->theirs[pair].us[0], r->ours[pair].us[1],
            r->theirs[pair].us[1]);
    return code;
}

static int run_case(jitter_result *r)
{
    const double period_us = 1e6 / r->what.rate_Hz;
    int code = r->what.loaded ? jitter_load_start() : 0;
    for (int pair = 0; code == 0 && pair < r->what.n_pairs; pair++) {
        code = run_pair(r, pair);
    }
    jitter_load_stop();
    r->all_ours = jitter_figures_of(&r->sum_ours, period_us);
    r->all_theirs = jitter_figures_of(&r->sum_theirs, period_us);
    for (int i = 0; i < 2; i++) {
        r->ratio[i] = jitter_median_ratio(r->ours, r->theirs, r->what.n_pairs, i);
    }
    return code;
}

static int report(const jitter_options *o, const jitter_result *results, int n)
{
    int code = 0;
    jitter_table(results, n);
    for (int i = 0; i < n; i++) {
        const bool kept = results[i].ratio[0] <= 1.2 && results[i].ratio[1] <= 1.2;
        code = kept ? code : EXIT_MISSED;
    }
    const int json = o->json == NULL ? 0 : jitter_json(results, n, o->json);
    const int plot = o->plot == NULL ? 0 : jitter_plot(results, n, o->plot);
    code = json > code ? json : code;
    return plot > code ? plot : code;
}

int main(int argc, char **argv)
{
    static const struct argp argp = {options, parse, NULL, doc, NULL, NULL, NULL};
    static jitter_result results[CASES];
    jitter_options o = {.what = {.seconds = 20.0, .n_pairs = 10, .cpu = 1}};
    int n = 0;
    int code = 0;
    exk_args_parse(&argp, "exk-jitter " EXK_VERSION, argc, argv, &o);
    for (int i = 0; code == 0 && i < CASES; i++) {
        if (wanted(&o, i)) {
            results[n].what = o.what;
            results[n].what.rate_Hz = (i & 1) != 0 ? 10000.0 : 1000.0;
            results[n].what.loaded = (i & 2) != 0;
            results[n].what.privileged = (i & 4) == 0;
            code = run_case(&results[n++]);
        }
    }
    return code != 0 ? code : report(&o, results, n);
}
