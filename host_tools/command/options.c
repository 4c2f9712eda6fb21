#include "options.h"

#include <argp.h>
#include <stddef.h>
#include <string.h>

#include "exk/args.h"
#include "exk/version.h"

static const double keep_max_s = 3600.0;

enum { KEY_URL = 256, KEY_KEY, KEY_KEEP };

static const char doc[] =
    "Gives a command to the controller that runs on the bus, with the keyed hash\n"
    "that its profile asks for.\v"
    "COMMAND is start (begin, or go on after a hold), stop (slow down and hold),\n"
    "abort (stop at once, stay), clear (the fault is understood; then start) or\n"
    "alive (the sender is there). A controller obeys only where [command] in its\n"
    "profile says allow = yes, and holds when no valid command comes for its\n"
    "timeout_s: --keep goes on sending.\n"
    "\n"
    "Examples:\n"
    "  exk-command keygen operator.key               once, where exk-loop runs\n"
    "  exk-command start --key operator.key --keep   start; alive until Ctrl-C\n"
    "  exk-command stop --key operator.key\n"
    "\n"
    "The key is 64 hexadecimal digits in a file that its owner alone may read (mode\n"
    "0600).\n"
    "\n"
    "Exit status: 0 the controller took the command; 1 it refused it, did not\n"
    "answer, or its state has no use for it; 2 wrong use, or a key that is refused;\n"
    "3 the bus failed, or no controller is heard.";

static const struct argp_option options[] = {
    {"key", KEY_KEY, "FILE", 0, "The key that the profile's key_file names", 0},
    {"url", KEY_URL, "URL", 0, "LCM URL (default: LCM_DEFAULT_URL, then this host)", 0},
    {"keep", KEY_KEEP, "SECONDS", OPTION_ARG_OPTIONAL,
     "Go on saying alive so often (default 0.2) until Ctrl-C or the end of the run", 0},
    {"quiet", 'q', NULL, 0, "No notes", 0},
    {0},
};

/* No profile waits longer (timeout_s), and the wait in milliseconds has to be a number. */
static void take_keep(struct argp_state *state, const char *arg, command_options *out)
{
    out->keep_s = arg == NULL ? 0.2 : exk_args_positive(state, "--keep", arg, "seconds");
    if (!(out->keep_s <= keep_max_s)) {
        argp_error(state, "--keep %s: at most %g seconds are allowed", arg, keep_max_s);
    }
}

static void take_word(struct argp_state *state, char *arg, command_options *out)
{
    if (state->arg_num == 0 && strcmp(arg, "keygen") == 0) {
        out->keygen = true;
    } else if (state->arg_num == 0 && !exk_command_find(arg, &out->command)) {
        argp_error(state, "%s: start, stop, abort, clear, alive or keygen is allowed", arg);
    } else if (state->arg_num == 1 && out->keygen) {
        out->key_path = arg;
    } else if (state->arg_num > 0) {
        argp_error(state, "one COMMAND is allowed, found more: %s", arg);
    }
}

static void check(struct argp_state *state, const command_options *out)
{
    if (out->keygen && out->key_path == NULL) {
        argp_error(state, "the FILE to make is missing, for example keygen operator.key");
    }
    if (out->key_path == NULL) {
        argp_error(state, "--key FILE is missing: a command without the right key is refused");
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    command_options *out = state->input;
    switch (key) {
    case KEY_KEY:
        out->key_path = arg;
        return 0;
    case KEY_URL:
        out->url = arg;
        return 0;
    case KEY_KEEP:
        take_keep(state, arg, out);
        return 0;
    case 'q':
        out->quiet = true;
        return 0;
    case ARGP_KEY_ARG:
        take_word(state, arg, out);
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "a COMMAND is missing: start, stop, abort, clear, alive or keygen");
        return 0;
    case ARGP_KEY_END:
        check(state, out);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

void command_options_parse(int argc, char **argv, command_options *out)
{
    static const struct argp argp = {options, parse, "COMMAND\nkeygen FILE", doc, NULL,
                                     NULL,    NULL};
    *out = (command_options){.url = NULL};
    exk_args_parse(&argp, "exk-command " EXK_VERSION, argc, argv, out);
}
