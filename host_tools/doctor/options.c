#include "options.h"

#include <argp.h>

#include "exk/args.h"
#include "exk/version.h"

enum { KEY_URL = 256, KEY_JSON };

static const char doc[] =
    "Looks whether this machine is ready for the bus and for real time, and says\n"
    "for each point what to do.\v"
    "Looked at: the multicast route, LCM messages there and back, the receive\n"
    "buffer, how far messages go, real-time scheduling, locked memory, punctuality\n"
    "of the clock, gnuplot and Java. Nothing is changed. Takes about a second.\n"
    "\n"
    "Examples:\n"
    "  exk-doctor\n"
    "  exk-doctor --url='udpm://239.255.76.67:7700?ttl=0' --json\n"
    "\n"
    "Exit status: 0 all good, or only warnings; 1 something fails; 2 wrong use;\n"
    "3 output failed.";

static const struct argp_option options[] = {
    {"url", KEY_URL, "URL", 0, "LCM URL to try (default: LCM_DEFAULT_URL, then this host)", 0},
    {"json", KEY_JSON, "FILE", OPTION_ARG_OPTIONAL,
     "JSON on standard output in place of the lines, or with --json=FILE into FILE", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    doctor_options *out = state->input;
    switch (key) {
    case KEY_URL:
        out->url = arg;
        return 0;
    case KEY_JSON:
        out->json_path = arg != NULL ? arg : "-";
        return 0;
    case ARGP_KEY_ARG:
        argp_error(state, "no argument is expected, found %s", arg);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

void doctor_options_parse(int argc, char **argv, doctor_options *out)
{
    static const struct argp argp = {options, parse, NULL, doc, NULL, NULL, NULL};
    *out = (doctor_options){.url = NULL};
    exk_args_parse(&argp, "exk-doctor " EXK_VERSION, argc, argv, out);
}
