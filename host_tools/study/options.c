#define _POSIX_C_SOURCE 200809L
#include <argp.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "exk/args.h"
#include "exk/version.h"
#include "experiments.h"
#include "study_tool.h"

enum {
    KEY_SEEDS = 256,
    KEY_JSON,
    KEY_CSV,
    KEY_REPORT,
    KEY_RESUME,
    KEY_FROM,
    KEY_TO,
    KEY_PROFILES,
    KEY_WRITE,
    KEY_ONLY,
    KEY_COMPARE,
    KEY_SENSITIVITY,
    KEY_STEPS
};

static const char doc[] =
    "Runs the published study again over many seeds, with intervals and verdicts.\v"
    "  paper          S1 to S9: figures beside ours, claims in words tested\n"
    "  compare        no control, PI, ILC, both; frozen and fresh noise; the floor\n"
    "  calibrate      fits the three fitted numbers; --write: into the profiles\n"
    "  sensitivity    verdicts over K, dwell, order of S9 and kinematic model\n"
    "  block          the trials --from A up to B of paper into a part file (-o)\n"
    "  merge PART...  part files into the result of paper\n"
    "\n"
    "Examples:\n"
    "  exk-study paper --json paper.json --csv paper.csv --report paper.html\n"
    "  mpirun -n 4 exk-study paper --seeds 20000 --json paper.json\n"
    "  exk-study block --from 0 --to 1000 -o part0.bin        on one host\n"
    "  exk-study block --from 1000 --to 2000 -o part1.bin     on another\n"
    "  exk-study merge part0.bin part1.bin --json paper.json\n"
    "\n"
    "One seed is one whole study: trial i is series i of the random numbers. -j,\n"
    "mpirun and parts all give the same bytes. With --resume DIR each finished\n"
    "block of 50 trials is kept, and the same command goes on from there.\n"
    "\n"
    "Exit status: 0 done (verdicts are results, not failures), 1 a run ended by\n"
    "fault or a signal, 2 wrong use or input, 3 input or output failed.";

static const struct argp_option options[] = {
    {"seeds", KEY_SEEDS, "N", 0, "Trials, a multiple of 10 (default 2000; sensitivity 500)", 0},
    {"jobs", 'j', "J", 0, "Threads (default: processors; under mpirun 1 a rank)", 0},
    {"json", KEY_JSON, "FILE", 0, "Results as JSON (- for standard output)", 0},
    {"csv", KEY_CSV, "FILE", 0, "paper, merge: every measure as CSV", 0},
    {"report", KEY_REPORT, "FILE", 0, "paper, merge: one HTML page with figures", 0},
    {"compare", KEY_COMPARE, "FILE", 0,
     "report: with this JSON of exk-study compare (default: 200 seeds, run at once)", 0},
    {"sensitivity", KEY_SENSITIVITY, "FILE", 0,
     "report: with this JSON of exk-study sensitivity (default: left out)", 0},
    {"resume", KEY_RESUME, "DIR", 0, "Keep finished blocks in DIR and go on from those there",
     0},
    {"only", KEY_ONLY, "S5,S6", 0, "paper, block, merge: these experiments alone, S1 to S9", 0},
    {"steps", KEY_STEPS, NULL, 0,
     "Every run step by step, as exk-loop does: slower, same bytes", 0},
    {"from", KEY_FROM, "A", 0, "block: first trial, a multiple of 50", 0},
    {"to", KEY_TO, "B", 0, "block: one past the last trial, a multiple of 50 or the end", 0},
    {"output", 'o', "FILE", 0, "block: the part file", 0},
    {"profiles", KEY_PROFILES, "DIR", 0, "Folder of the study's profiles", 0},
    {"write", KEY_WRITE, NULL, 0, "calibrate: write the values into the profiles", 0},
    {0},
};

static const char *const commands[] = {
    [STUDY_PAPER] = "paper",         [STUDY_COMPARE] = "compare",
    [STUDY_CALIBRATE] = "calibrate", [STUDY_SENSITIVITY] = "sensitivity",
    [STUDY_BLOCK] = "block",         [STUDY_MERGE] = "merge"};

/* Trials come in tens, and in blocks of fifty. */
static uint64_t trials(struct argp_state *state, const char *what, const char *arg,
                       uint64_t min, uint64_t multiple)
{
    const uint64_t max = UINT32_MAX / 10 * 10;
    const uint64_t value = exk_args_whole(state, what, arg, min, max);
    if (value % multiple != 0) {
        argp_error(state, "%s %s: a multiple of %" PRIu64 " is allowed", what, arg, multiple);
    }
    return value;
}

/* "S5,S6" as bits. */
static uint32_t parts_of(struct argp_state *state, const char *arg)
{
    uint32_t parts = 0;
    const char *at = arg;
    bool good = true;
    while (good) {
        good = at[0] == 'S' && at[1] >= '1' && at[1] <= '9' && (at[2] == ',' || at[2] == '\0');
        if (good) {
            parts |= 1U << (at[1] - '1');
        }
        if (!good || at[2] == '\0') {
            break;
        }
        at += 3;
    }
    if (!good) {
        argp_error(state, "--only %s: names from S1 to S9 with commas are allowed", arg);
    }
    return parts;
}

static study_command command_of(struct argp_state *state, const char *word)
{
    for (int i = STUDY_PAPER; i <= STUDY_MERGE; i++) {
        if (strcmp(commands[i], word) == 0) {
            return (study_command)i;
        }
    }
    argp_error(state,
               "unknown command %s: paper, compare, calibrate, sensitivity, block or merge is "
               "allowed",
               word);
    return STUDY_PAPER;
}

/* argp has moved the words to the end of argv: all parts are one row. */
static void take_word(struct argp_state *state, study_options *out, char *word)
{
    if (state->arg_num == 0) {
        out->command = command_of(state, word);
    } else if (out->command == STUDY_MERGE) {
        out->parts[out->n_parts++] = word;
    } else {
        argp_error(state, "one argument too many: %s", word);
    }
}

static void check_words(struct argp_state *state, const study_options *out)
{
    if (state->arg_num == 0) {
        argp_error(state, "a command is missing, for example: exk-study paper --seeds 200");
    }
    if (out->command == STUDY_BLOCK && (out->output == NULL || out->to <= out->from)) {
        argp_error(state, "block needs --from A --to B with A below B, and -o FILE");
    }
    if (out->command == STUDY_MERGE && out->n_parts == 0) {
        argp_error(state, "merge needs part files, for example: exk-study merge part*.bin");
    }
}

static error_t parse_file(int key, char *arg, study_options *out)
{
    switch (key) {
    case KEY_JSON:
        out->json = arg;
        return 0;
    case KEY_CSV:
        out->csv = arg;
        return 0;
    case KEY_REPORT:
        out->report = arg;
        return 0;
    case KEY_COMPARE:
        out->with_compare = arg;
        return 0;
    case KEY_SENSITIVITY:
        out->with_sensitivity = arg;
        return 0;
    case KEY_RESUME:
        out->resume = arg;
        return 0;
    case 'o':
        out->output = arg;
        return 0;
    case KEY_PROFILES:
        out->profiles = arg;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    study_options *out = state->input;
    switch (key) {
    case KEY_SEEDS:
        out->n_seeds = trials(state, "--seeds", arg, 10, 10);
        return 0;
    case 'j':
        out->n_threads = (int)exk_args_whole(state, "-j", arg, 1, 1024);
        return 0;
    case KEY_FROM:
        out->from = trials(state, "--from", arg, 0, 50);
        return 0;
    case KEY_TO:
        out->to = trials(state, "--to", arg, 10, 10);
        return 0;
    case KEY_ONLY:
        out->only = arg;
        out->parts_run = parts_of(state, arg);
        return 0;
    case KEY_STEPS:
        out->by_steps = true;
        return 0;
    case KEY_WRITE:
        out->write = true;
        return 0;
    case ARGP_KEY_ARG:
        take_word(state, out, arg);
        return 0;
    case ARGP_KEY_END:
        check_words(state, out);
        return 0;
    default:
        return parse_file(key, arg, out);
    }
}

void study_options_parse(int argc, char **argv, study_options *out)
{
    static const struct argp argp = {
        options, parse, "paper\ncompare\ncalibrate\nsensitivity\nblock\nmerge PART...",
        doc,     NULL,  NULL,
        NULL};
    *out = (study_options){.parts = calloc((size_t)argc, sizeof *out->parts),
                           .parts_run = STUDY_ALL_PARTS};
    exk_args_parse(&argp, "exk-study " EXK_VERSION, argc, argv, out);
    if (out->n_threads == 0) {
        const long n = sysconf(_SC_NPROCESSORS_ONLN);
        out->n_threads = n > 0 && n <= 1024 ? (int)n : 1;
    }
}
