#include "options.h"

#include <argp.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exk/args.h"
#include "exk/units.h"
#include "exk/version.h"
#include "gnuplot.h"

enum {
    KEY_LIVE = 256,
    KEY_URL,
    KEY_SECONDS,
    KEY_JSON,
    KEY_CSV,
    KEY_PLOT,
    KEY_TOLERANCE,
    KEY_REPORT
};

static const char doc[] =
    "Judges the drilled holes of a run, from an LCM log or live from the bus: error\n"
    "of each hole, mean, largest, rate inside the tolerance, capability, beside the\n"
    "published machines.\v"
    "One sample a hole counts, the last before the stroke; the error is radial, in\n"
    "the plane normal to the hole axis.\n"
    "\n"
    "Examples:\n"
    "  exk-holes run.lcm                               the table\n"
    "  exk-holes run.lcm --json                        the same for machines\n"
    "  exk-holes run.lcm --csv holes.csv --plot holes.svg --plot holes.png\n"
    "  exk-holes --live                                the run on the bus\n"
    "\n"
    "Exit status: 0 every hole is inside its tolerance; 1 one is not, or samples\n"
    "were lost; 2 wrong use, or a log that cannot be judged; 3 input or output\n"
    "failed.";

static const struct argp_option options[] = {
    {"live", KEY_LIVE, NULL, 0, "Listen on the bus until the run is done", 0},
    {"url", KEY_URL, "URL", 0,
     "LCM URL to listen on (default: LCM_DEFAULT_URL, then this host)", 0},
    {"seconds", KEY_SECONDS, "N", 0, "Listen for N seconds at most", 0},
    {"json", KEY_JSON, "FILE", OPTION_ARG_OPTIONAL,
     "Result as JSON on standard output in place of the table, or with --json=FILE into FILE",
     0},
    {"csv", KEY_CSV, "FILE", 0, "Holes as CSV; - is standard output, in place of the table", 0},
    {"plot", KEY_PLOT, "FILE", 0, "Picture, FILE.svg or FILE.png; may be given again", 0},
    {"tolerance", KEY_TOLERANCE, "MM", 0, "Tolerance in millimetres in place of the job's", 0},
    {"report-only", KEY_REPORT, NULL, 0,
     "Exit 0 even when holes are outside or samples were lost", 0},
    {"quiet", 'q', NULL, 0, "No progress and no notes", 0},
    {0},
};

static void check(struct argp_state *state, const holes_options *out)
{
    if (!out->live && out->log_path == NULL) {
        argp_error(state, "a LOG is missing, for example run.lcm; or --live");
    }
    if (out->live && out->log_path != NULL) {
        argp_error(state, "--live listens on the bus: the log %s has no place beside it",
                   out->log_path);
    }
    if (!out->live && (out->url != NULL || out->seconds > 0.0)) {
        argp_error(state, "--url and --seconds go with --live");
    }
    exk_refuse_two_on_stdout(state, out->json_path, out->csv_path);
}

static error_t parse_output(int key, char *arg, struct argp_state *state, holes_options *out)
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
    case KEY_REPORT:
        out->report_only = true;
        return 0;
    case 'q':
        out->quiet = true;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static error_t parse_input(int key, char *arg, struct argp_state *state, holes_options *out)
{
    switch (key) {
    case KEY_LIVE:
        out->live = true;
        return 0;
    case KEY_URL:
        out->url = arg;
        return 0;
    case KEY_SECONDS:
        out->seconds = exk_args_positive(state, "--seconds", arg, "seconds");
        return 0;
    case KEY_TOLERANCE:
        out->tolerance_m =
            EXK_M_PER_MM * exk_args_positive(state, "--tolerance", arg, "millimetres");
        return 0;
    default:
        return parse_output(key, arg, state, out);
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    holes_options *out = state->input;
    if (key == ARGP_KEY_ARG) {
        if (out->log_path != NULL) {
            argp_error(state,
                       "one LOG is allowed, found a second: %s (a file for JSON is given "
                       "as --json=FILE)",
                       arg);
        }
        out->log_path = exk_args_name(state, "LOG", arg);
        return 0;
    }
    if (key == ARGP_KEY_END) {
        check(state, out);
        return 0;
    }
    return parse_input(key, arg, state, out);
}

void holes_options_parse(int argc, char **argv, holes_options *out)
{
    static const struct argp argp = {options, parse, "LOG\n--live", doc, NULL, NULL, NULL};
    *out = (holes_options){.log_path = NULL};
    exk_args_parse(&argp, "exk-holes " EXK_VERSION, argc, argv, out);
}
