/* exk-bench: a table on stdout, JSON with --json. */
#include <argp.h>
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

#include "bench.h"
#include "exk/args.h"
#include "exk/version.h"

enum { CASES_MAX = 32, EXIT_INPUT = 2, EXIT_IO = 3 };

static const char doc[] =
    "Times the calls a control step is made of, and the whole step.\v"
    "Example:\n"
    "  exk-bench --json > bench.json\n"
    "\n"
    "ns per call over 1024 independent inputs; median of 7 interleaved rounds, each\n"
    "the median of 51 repeats. Compare ratios of one run: machines are noisy.";

static const struct argp_option options[] = {{"json", 'j', NULL, 0, "Print JSON", 0}, {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    (void)arg;
    if (key == 'j') {
        *(bool *)state->input = true;
        return 0;
    }
    return ARGP_ERR_UNKNOWN;
}

static void print_table(bench_case *cases, size_t n)
{
    printf("%-38s %10s %10s %10s %8s\n", "call", "median ns", "best", "worst", "goal");
    for (size_t i = 0; i < n; i++) {
        bench_case *c = &cases[i];
        const double median_ns = bench_median(c->round_ns, BENCH_ROUNDS);
        printf("%-38s %10.2f %10.2f %10.2f", c->name, median_ns, c->round_ns[0],
               c->round_ns[BENCH_ROUNDS - 1]);
        if (c->goal_ns > 0.0) {
            printf(" %8.1f", c->goal_ns);
        }
        printf("\n");
    }
}

static bool print_json(bench_case *cases, size_t n)
{
    json_t *rows = json_array();
    for (size_t i = 0; i < n; i++) {
        bench_case *c = &cases[i];
        const double median_ns = bench_median(c->round_ns, BENCH_ROUNDS);
        json_array_append_new(rows, json_pack("{s:s, s:f, s:f, s:f, s:f}", "call", c->name,
                                              "median_ns", median_ns, "best_ns", c->round_ns[0],
                                              "worst_ns", c->round_ns[BENCH_ROUNDS - 1],
                                              "goal_ns", c->goal_ns));
    }
    const bool good = json_dumpf(rows, stdout, JSON_INDENT(1)) == 0 && putchar('\n') == '\n';
    json_decref(rows);
    return good;
}

int main(int argc, char **argv)
{
    static const struct argp argp = {options, parse, NULL, doc, NULL, NULL, NULL};
    static bench_case cases[CASES_MAX];
    bool json = false;
    exk_args_parse(&argp, "exk-bench " EXK_VERSION, argc, argv, &json);
    size_t n = bench_core_cases(cases, CASES_MAX);
    const size_t n_step = bench_step_cases(cases + n, CASES_MAX - n);
    if (n_step == 0) {
        return EXIT_IO;
    }
    n += n_step;
    bench_time(cases, n);
    if (json) {
        return print_json(cases, n) ? 0 : EXIT_IO;
    }
    print_table(cases, n);
    return 0;
}
