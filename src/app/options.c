#include "options.h"

#include <argp.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "exk/args.h"
#include "exk/version.h"

enum {
    KEY_FAST = 256,
    KEY_CHECK,
    KEY_PRINT,
    KEY_ILC,
    KEY_RUN,
    KEY_SERIES,
    KEY_URL,
    KEY_SOURCE,
    KEY_BUS,
    KEY_NO_BUS
};

static const char doc[] =
    "Runs the controller of a profile: in real time on the LCM bus, or unpaced with\n"
    "--fast.\v"
    "Examples:\n"
    "  exk-loop profiles/rectangle.ini                    real time, on the bus\n"
    "  exk-loop profiles/rectangle.ini --fast -r run.lcm  unpaced, into a log\n"
    "  exk-loop profiles/rectangle_ilc.ini --fast --ilc r.ilc -r run2.lcm\n"
    "  exk-loop profiles/rectangle.ini --source bus       beside its exk-twin\n"
    "\n"
    "Watch it with exk-spy, record it with exk-log, judge it with exk-holes. Ctrl-C\n"
    "ends a run cleanly: the log is complete.\n"
    "\n"
    "Exit status: 0 the job was run to its end; 1 it ended by fault or signal;\n"
    "2 wrong use, or a profile, job or store that is refused; 3 input or output\n"
    "failed.";

static const struct argp_option options[] = {
    {"fast", KEY_FAST, NULL, 0, "Unpaced, on virtual time; off the bus unless --bus is given",
     0},
    {"check", KEY_CHECK, NULL, 0, "Check the profile and its job, start nothing", 0},
    {"print", KEY_PRINT, NULL, 0, "Print the effective profile, start nothing", 0},
    {"record", 'r', "FILE", 0, "Write an LCM event log", 0},
    {"ilc", KEY_ILC, "FILE", 0, "Apply the stored correction of FILE", 0},
    {"run", KEY_RUN, "P", 0,
     "Repetition within a series, 1, 2, ... (default: the store's, or 1)", 0},
    {"series", KEY_SERIES, "I", 0, "Series (trial) of the random numbers (default 0)", 0},
    {"url", KEY_URL, "URL", 0, "LCM URL in place of the profile's", 0},
    {"source", KEY_SOURCE, "WHERE", 0,
     "twin: the machine in this process; bus: one on the bus (exk-twin), in place of the "
     "profile's",
     0},
    {"bus", KEY_BUS, NULL, 0, "Publish in --fast as well", 0},
    {"no-bus", KEY_NO_BUS, NULL, 0, "Publish nothing", 0},
    {"quiet", 'q', NULL, 0, "No progress and no notes", 0},
    {0},
};

static error_t parse_flag(int key, loop_options *out)
{
    switch (key) {
    case KEY_FAST:
        out->fast = true;
        return 0;
    case KEY_CHECK:
        out->check = true;
        return 0;
    case KEY_PRINT:
        out->print = true;
        return 0;
    case KEY_BUS:
        out->on_bus = true;
        return 0;
    case KEY_NO_BUS:
        out->off_bus = true;
        return 0;
    case 'q':
        out->quiet = true;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static error_t parse_value(int key, char *arg, struct argp_state *state, loop_options *out)
{
    switch (key) {
    case 'r':
        out->record_path = exk_args_name(state, "--record", arg);
        return 0;
    case KEY_ILC:
        out->ilc_path = exk_args_name(state, "--ilc", arg);
        return 0;
    case KEY_URL:
        out->url = arg;
        return 0;
    case KEY_SOURCE:
        if (strcmp(arg, "twin") != 0 && strcmp(arg, "bus") != 0) {
            argp_error(state, "--source %s: twin or bus is allowed", arg);
        }
        out->source = arg;
        return 0;
    case KEY_RUN:
        out->run = (uint32_t)exk_args_whole(state, "--run", arg, 1, UINT32_MAX);
        return 0;
    case KEY_SERIES:
        out->series = (uint32_t)exk_args_whole(state, "--series", arg, 0, UINT32_MAX);
        return 0;
    default:
        return parse_flag(key, out);
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    loop_options *out = state->input;
    if (key == ARGP_KEY_ARG) {
        if (out->profile_path != NULL) {
            argp_error(state, "one PROFILE is allowed, found a second: %s", arg);
        }
        out->profile_path = exk_args_name(state, "PROFILE", arg);
        return 0;
    }
    if (key == ARGP_KEY_NO_ARGS) {
        argp_error(state, "a PROFILE is missing, for example profiles/rectangle.ini");
    }
    if (key == ARGP_KEY_END && out->on_bus && out->off_bus) {
        argp_error(state, "--bus and --no-bus exclude each other");
    }
    return parse_value(key, arg, state, out);
}

void loop_options_parse(int argc, char **argv, loop_options *out)
{
    static const struct argp argp = {options, parse, "PROFILE", doc, NULL, NULL, NULL};
    *out = (loop_options){.profile_path = NULL};
    exk_args_parse(&argp, "exk-loop " EXK_VERSION, argc, argv, out);
}
