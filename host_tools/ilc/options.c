#include <argp.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exk/args.h"
#include "exk/version.h"
#include "ilc_tool.h"

enum { KEY_SERIES = 256, KEY_UNTIL, KEY_JSON, KEY_ALLOW_BAD };

static const char doc[] =
    "Makes and checks the stored correction (ILC) of a drilling job.\v"
    "  learn LOG -o STORE        one update u + K (e + c) from a recorded run\n"
    "  train PROFILE -n N        N runs and N updates here, a line for each run\n"
    "  show STORE                what a store holds\n"
    "  verify STORE [PROFILE]    is it whole, and does it belong to this profile\n"
    "\n"
    "Examples:\n"
    "  exk-ilc train profiles/rectangle_ilc.ini -n 5 -o r.ilc\n"
    "  exk-loop profiles/rectangle_ilc.ini --fast -r run1.lcm\n"
    "  exk-ilc learn run1.lcm -o r.ilc\n"
    "\n"
    "Gains, filter and limits come from [control] of the profile (learn: of the\n"
    "log).\n"
    "\n"
    "Exit status: 0 good; 1 --until was not reached, the run ended by fault, or the\n"
    "series by a signal; 2 wrong use, or an input that is refused; 3 input or\n"
    "output failed.";

static const struct argp_option options[] = {
    {"output", 'o', "STORE", 0, "Where to write the store (learn: needed)", 0},
    {"runs", 'n', "N", 0, "train: runs and updates (default 5)", 0},
    {"series", KEY_SERIES, "I", 0, "train: series (trial) of the random numbers (default 0)",
     0},
    {"until", KEY_UNTIL, "MM", 0, "train: stop once the last-point error is below MM mm", 0},
    {"allow-bad", KEY_ALLOW_BAD, NULL, 0, "Learn from a run with rejected sensor samples too",
     0},
    {"json", KEY_JSON, NULL, 0, "Print JSON", 0},
    {0},
};

static const char *const commands[] = {
    [ILC_LEARN] = "learn", [ILC_SHOW] = "show", [ILC_VERIFY] = "verify", [ILC_TRAIN] = "train"};

static ilc_command command_of(struct argp_state *state, const char *word)
{
    for (int i = ILC_LEARN; i <= ILC_TRAIN; i++) {
        if (strcmp(commands[i], word) == 0) {
            return (ilc_command)i;
        }
    }
    argp_error(state, "unknown command %s: learn, show, verify or train is allowed", word);
    return ILC_LEARN;
}

static void take_word(struct argp_state *state, ilc_options *out, char *word)
{
    if (state->arg_num == 0) {
        out->command = command_of(state, word);
    } else if (state->arg_num == 1) {
        out->input = word;
    } else if (state->arg_num == 2 && out->command == ILC_VERIFY) {
        out->profile = word;
    } else {
        argp_error(state, "one argument too many: %s", word);
    }
}

static void check_words(struct argp_state *state, const ilc_options *out)
{
    if (state->arg_num < 2) {
        argp_error(state,
                   "a command and its input are missing, for example: exk-ilc show r.ilc");
    }
    if (out->command == ILC_LEARN && out->output == NULL) {
        argp_error(state, "learn needs -o STORE");
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    ilc_options *out = state->input;
    switch (key) {
    case 'o':
        out->output = exk_args_name(state, "--output", arg);
        return 0;
    case 'n':
        out->n_runs = (uint32_t)exk_args_whole(state, "-n", arg, 1, 100000);
        return 0;
    case KEY_SERIES:
        out->series = (uint32_t)exk_args_whole(state, "--series", arg, 0, UINT32_MAX);
        return 0;
    case KEY_UNTIL:
        out->until_mm = exk_args_positive(state, "--until", arg, "millimetres");
        return 0;
    case KEY_JSON:
        out->json = true;
        return 0;
    case KEY_ALLOW_BAD:
        out->allow_bad = true;
        return 0;
    case ARGP_KEY_ARG:
        take_word(state, out, arg);
        return 0;
    case ARGP_KEY_END:
        check_words(state, out);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

void ilc_options_parse(int argc, char **argv, ilc_options *out)
{
    static const struct argp argp = {
        options, parse, "learn LOG -o STORE\ntrain PROFILE\nshow STORE\nverify STORE [PROFILE]",
        doc,     NULL,  NULL,
        NULL};
    *out = (ilc_options){.n_runs = 5};
    exk_args_parse(&argp, "exk-ilc " EXK_VERSION, argc, argv, out);
}
