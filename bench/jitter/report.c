#include <inttypes.h>
#include <jansson.h>
#include <stdio.h>

#include "jitter.h"
#include "json_file.h"

static const double promised = 1.2;

static const char *load_word(const jitter_case *what)
{
    return what->loaded ? "loaded" : "idle";
}

static const char *rights_word(const jitter_case *what)
{
    return what->privileged ? "FIFO" : "ordinary";
}

static void print_row(const jitter_case *what, const char *who, const jitter_figures *f)
{
    printf("%6.0f  %-6s  %-8s  %-10s %8.1f %8.1f %8.1f %9.1f %9" PRIu64 " %7" PRIu64
           "  %.4f to %.4f %%\n",
           what->rate_Hz, load_word(what), rights_word(what), who, f->us[0], f->us[1], f->us[2],
           f->us[3], f->n, f->n_late, 100.0 * f->late_low, 100.0 * f->late_high);
}

void jitter_table(const jitter_result *results, int n)
{
    printf("%6s  %-6s  %-8s  %-10s %8s %8s %8s %9s %9s %7s  %s\n", "Hz", "host", "rights",
           "who", "p50 us", "p99 us", "p99.9", "max", "wake-ups", "late",
           "late, 95 % interval");
    for (int i = 0; i < n; i++) {
        const jitter_result *r = &results[i];
        print_row(&r->what, "exk", &r->all_ours);
        print_row(&r->what, "cyclictest", &r->all_theirs);
        printf("%38s ours/theirs, median of %d pairs: p50 %.2f, p99 %.2f (promise %.1f: %s)\n",
               "", r->what.n_pairs, r->ratio[0], r->ratio[1], promised,
               r->ratio[0] <= promised && r->ratio[1] <= promised ? "kept" : "missed");
    }
}

static json_t *figures_json(const jitter_figures *f)
{
    return json_pack("{s:f, s:f, s:f, s:f, s:I, s:I, s:f, s:f}", "p50_us", f->us[0], "p99_us",
                     f->us[1], "p999_us", f->us[2], "max_us", f->us[3], "n", (json_int_t)f->n,
                     "late", (json_int_t)f->n_late, "late_low", f->late_low, "late_high",
                     f->late_high);
}

static json_t *pairs_json(const jitter_result *r)
{
    json_t *pairs = json_array();
    for (int i = 0; i < r->what.n_pairs; i++) {
        json_array_append_new(pairs, json_pack("{s:o, s:o}", "exk", figures_json(&r->ours[i]),
                                               "cyclictest", figures_json(&r->theirs[i])));
    }
    return pairs;
}

int jitter_json(const jitter_result *results, int n, const char *path)
{
    char why[512];
    json_t *cases = json_array();
    for (int i = 0; i < n; i++) {
        const jitter_result *r = &results[i];
        json_array_append_new(
            cases,
            json_pack("{s:f, s:b, s:b, s:f, s:i, s:i, s:o, s:o, s:f, s:f, s:o}", "rate_Hz",
                      r->what.rate_Hz, "loaded", (int)r->what.loaded, "privileged",
                      (int)r->what.privileged, "seconds", r->what.seconds, "pairs",
                      r->what.n_pairs, "cpu", r->what.cpu, "exk", figures_json(&r->all_ours),
                      "cyclictest", figures_json(&r->all_theirs), "ratio_p50", r->ratio[0],
                      "ratio_p99", r->ratio[1], "each", pairs_json(r)));
    }
    json_t *root = json_pack("{s:o}", "jitter", cases);
    const int code = exk_json_write(root, path, "jitter", why, sizeof why);
    json_decref(root);
    if (code != 0) {
        fprintf(stderr, "exk-jitter: %s\n", why);
    }
    return code;
}
