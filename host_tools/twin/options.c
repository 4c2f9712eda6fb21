#include "options.h"

#include <argp.h>
#include <stddef.h>

#include "exk/args.h"
#include "exk/version.h"

enum { KEY_URL = 256, KEY_ONCE };

static const char doc[] =
    "Is the machine of a profile, in a process of its own: takes commanded angles\n"
    "from the bus (EXK_DRIVE) and answers each at once with measured ones\n"
    "(EXK_SENSOR).\v"
    "The controller beside it is exk-loop with the same profile and --source bus,\n"
    "or with source = bus in [loop]. Which realisation of its noise the twin is,\n"
    "the controller says: a run in two processes gives the same angles as one in a\n"
    "single process.\n"
    "\n"
    "Examples:\n"
    "  exk-twin profiles/rectangle.ini &       run after run, until Ctrl-C\n"
    "  exk-loop profiles/rectangle.ini --source bus\n"
    "\n"
    "Exit status: 0 ended by Ctrl-C or, with --once, with the run; 2 wrong use, a\n"
    "profile that is refused, or another machine on the bus; 3 the bus failed.";

static const struct argp_option options[] = {
    {"url", KEY_URL, "URL", 0, "LCM URL in place of the profile's", 0},
    {"once", KEY_ONCE, NULL, 0, "End when the first run has ended", 0},
    {"quiet", 'q', NULL, 0, "No notes", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    twin_options *out = state->input;
    switch (key) {
    case KEY_URL:
        out->url = arg;
        return 0;
    case KEY_ONCE:
        out->once = true;
        return 0;
    case 'q':
        out->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        if (out->profile_path != NULL) {
            argp_error(state, "one PROFILE is allowed, found a second: %s", arg);
        }
        out->profile_path = arg;
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "a PROFILE is missing, for example profiles/rectangle.ini");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

void twin_options_parse(int argc, char **argv, twin_options *out)
{
    static const struct argp argp = {options, parse, "PROFILE", doc, NULL, NULL, NULL};
    *out = (twin_options){.profile_path = NULL};
    exk_args_parse(&argp, "exk-twin " EXK_VERSION, argc, argv, out);
}
