#include "options.h"

#include <argp.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exk/args.h"
#include "exk/version.h"
#include "gnuplot.h"

enum {
    KEY_URL = 256,
    KEY_FROM,
    KEY_SECONDS,
    KEY_UNTIL_DONE,
    KEY_RUN_ID,
    KEY_JSON,
    KEY_CSV,
    KEY_PLOT
};

static const char doc[] =
    "Records what exk says on the bus in an LCM log, and counts every lost sample.\n"
    "The log is written as LOG.part and gets its name when it is whole.\v"
    "Recorded are all channels that begin with EXK_, byte by byte, until Ctrl-C,\n"
    "--seconds or --until-done. The counts, the CSV and the picture are of one run:\n"
    "the first, or --run-id.\n"
    "\n"
    "Examples:\n"
    "  exk-log run.lcm                               until Ctrl-C\n"
    "  exk-log run.lcm --until-done --plot path.svg  one run, with a picture\n"
    "  exk-log --from run.lcm --csv poses.csv        a log as a table\n"
    "\n"
    "Exit status: 0 recorded, nothing lost (Ctrl-C is a good end); 1 samples were\n"
    "lost, no sample was seen, a log read is damaged, or --until-done ended without\n"
    "the run being done; 2 wrong use or input; 3 input or output failed.";

static const struct argp_option options[] = {
    {"url", KEY_URL, "URL", 0,
     "LCM URL to listen on (default: LCM_DEFAULT_URL, then this host)", 0},
    {"seconds", KEY_SECONDS, "N", 0, "Stop after N seconds", 0},
    {"until-done", KEY_UNTIL_DONE, NULL, 0, "Stop when the run is done or in fault", 0},
    {"from", KEY_FROM, "FILE", 0, "Read this log in place of the bus; nothing is recorded", 0},
    {"run-id", KEY_RUN_ID, "ID", 0, "Count this run, not the first one seen", 0},
    {"csv", KEY_CSV, "FILE", 0, "Samples as CSV, one row each; - is standard output", 0},
    {"plot", KEY_PLOT, "FILE", 0,
     "Picture of the drilled path on its reference, FILE.svg or FILE.png; may be given again",
     0},
    {"json", KEY_JSON, "FILE", OPTION_ARG_OPTIONAL,
     "Counts as JSON on standard output in place of the report, or with --json=FILE into FILE",
     0},
    {"quiet", 'q', NULL, 0, "No progress and no notes", 0},
    {0},
};

static int64_t run_number(struct argp_state *state, const char *arg)
{
    char *end = NULL;
    errno = 0;
    const long long value = strtoll(arg, &end, 10);
    if (errno != 0 || end == arg || *end != '\0' || value == 0) {
        argp_error(state, "--run-id %s: the number of a run is allowed, as a report gives it",
                   arg);
    }
    return value;
}

static void check(struct argp_state *state, const log_options *out)
{
    const bool from_bus = out->from == NULL;
    if (from_bus && out->log_path == NULL) {
        argp_error(state, "the LOG to write is missing, for example run.lcm; or --from FILE");
    }
    if (!from_bus && out->log_path != NULL) {
        argp_error(state, "--from reads a log, nothing is recorded: %s has no place beside it",
                   out->log_path);
    }
    if (!from_bus && (out->url != NULL || out->seconds > 0.0 || out->until_done)) {
        argp_error(state, "--url, --seconds and --until-done are for the bus, not for --from");
    }
    exk_refuse_two_on_stdout(state, out->json_path, out->csv_path);
}

static error_t parse_input(int key, char *arg, struct argp_state *state, log_options *out)
{
    switch (key) {
    case KEY_URL:
        out->url = arg;
        return 0;
    case KEY_FROM:
        out->from = exk_args_name(state, "--from", arg);
        return 0;
    case KEY_SECONDS:
        out->seconds = exk_args_positive(state, "--seconds", arg, "seconds");
        return 0;
    case KEY_UNTIL_DONE:
        out->until_done = true;
        return 0;
    case KEY_RUN_ID:
        out->run_id = run_number(state, arg);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static error_t parse_output(int key, char *arg, struct argp_state *state, log_options *out)
{
    switch (key) {
    case KEY_JSON:
        out->json_path = arg != NULL ? arg : "-";
        return 0;
    case KEY_CSV:
        out->csv_path = exk_args_name(state, "--csv", arg);
        return 0;
    case KEY_PLOT:
        exk_plot_list_add(&out->plots, state, arg);
        return 0;
    case 'q':
        out->quiet = true;
        return 0;
    default:
        return parse_input(key, arg, state, out);
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    log_options *out = state->input;
    if (key == ARGP_KEY_ARG) {
        if (out->log_path != NULL) {
            argp_error(state, "one LOG is allowed, found a second: %s", arg);
        }
        out->log_path = exk_args_name(state, "LOG", arg);
        return 0;
    }
    if (key == ARGP_KEY_END) {
        check(state, out);
        return 0;
    }
    return parse_output(key, arg, state, out);
}

void log_options_parse(int argc, char **argv, log_options *out)
{
    static const struct argp argp = {options, parse, "LOG\n--from FILE", doc, NULL, NULL, NULL};
    *out = (log_options){.log_path = NULL};
    exk_args_parse(&argp, "exk-log " EXK_VERSION, argc, argv, out);
}
