#include "options.h"

#include <argp.h>
#include <string.h>

#include "exk/args.h"
#include "exk/version.h"
#include "exk/wrist.h"

enum { KEY_MODEL = 256, KEY_WRIST, KEY_PROFILE };

static const char doc[] =
    "Kinematics of an Exechon-type machine on CSV, from standard input to standard\n"
    "output.\v"
    "Columns, found by name in the header, in any order; others are ignored:\n"
    "\n"
    "  pendulum, universal\n"
    "    inverse   x_m,y_m -> alpha_rad,beta_rad\n"
    "    forward   alpha_rad,beta_rad -> x_m,y_m,z_m\n"
    "    jacobian  x_m,y_m -> j11,j12,j21,j22\n"
    "  tripod\n"
    "    inverse   x_m,y_m,z_m -> alpha_rad,beta_rad,l1_m,l2_m,l3_m\n"
    "    forward   l1_m,l2_m,l3_m -> x_m,y_m,z_m,alpha_rad,beta_rad\n"
    "    jacobian  x_m,y_m,z_m -> j11..j33\n"
    "  machine\n"
    "    inverse   x_m,y_m,z_m,nx,ny,nz -> those of tripod, t4_rad,t5_rad\n"
    "    forward   l1_m,l2_m,l3_m,t4_rad,t5_rad -> x_m,..,nz,alpha_rad,beta_rad\n"
    "    jacobian  x_m,y_m,z_m,nx,ny,nz -> j11..j33\n"
    "\n"
    "tripod: x_m,y_m,z_m is the plate point O1; machine: the tool tip, nx,ny,nz the\n"
    "unit tool direction. jacobian, row-major: pendulum and universal\n"
    "d(x,y)/d(alpha,beta), tripod d(l1,l2,l3)/d(x,y,z) of O1, machine the same of\n"
    "the tool tip at a fixed tool axis.\n"
    "\n"
    "Every output row ends in status: ok, or why the row has no solution, its\n"
    "numbers then empty: bad argument (not finite, or an axis that is not a unit\n"
    "vector), unreachable, singular, beyond limit, no convergence. An empty cell of\n"
    "the input is such a row too, so results can be piped on.\n"
    "\n"
    "Examples:\n"
    "  printf 'x_m,y_m,z_m\\n0,0,0.95\\n' | exk-kin inverse --model tripod\n"
    "  exk-kin inverse --model tripod < poses.csv | exk-kin forward --model tripod\n"
    "\n"
    "Exit status: 0 every row has a solution, 1 one has none, 2 wrong use, a bad\n"
    "header or a cell that is not a number, 3 input or output failed.";

static const struct argp_option options[] = {
    {"model", KEY_MODEL, "MODEL", 0,
     "pendulum, universal, tripod or machine (default: that of the profile)", 0},
    {"wrist", KEY_WRIST, "KIND", 0, "AB or CA, for machine (default: the profile's, then AB)",
     0},
    {"profile", KEY_PROFILE, "FILE", 0,
     "Take the machine from the [machine] section of this profile", 0},
    {0},
};

static void take_direction(struct argp_state *state, kin_options *out, const char *word)
{
    if (state->arg_num > 0) {
        argp_error(state, "one argument too many: %s", word);
    }
    for (int i = 0; i < KIN_DIRECTIONS; i++) {
        if (strcmp(word, kin_direction_name((kin_direction)i)) == 0) {
            out->direction = (kin_direction)i;
            return;
        }
    }
    argp_error(state, "unknown command %s: inverse, forward or jacobian is allowed", word);
}

static void take_model(struct argp_state *state, kin_options *out, const char *word)
{
    for (int i = 0; i < KIN_MODELS; i++) {
        if (strcmp(word, kin_model_name((kin_model)i)) == 0) {
            out->model = (kin_model)i;
            out->has_model = true;
            return;
        }
    }
    argp_error(state, "--model %s: pendulum, universal, tripod or machine is allowed", word);
}

static void take_wrist(struct argp_state *state, kin_options *out, const char *word)
{
    for (int i = 0; i < EXK_WRIST_COUNT; i++) {
        if (strcmp(word, exk_wrist_name((exk_wrist_kind)i)) == 0) {
            out->wrist = (exk_wrist_kind)i;
            out->has_wrist = true;
            return;
        }
    }
    argp_error(state, "--wrist %s: AB or CA is allowed", word);
}

static void check(struct argp_state *state, const kin_options *out)
{
    if (state->arg_num == 0) {
        argp_error(state, "a command is missing: inverse, forward or jacobian");
    }
    if (!out->has_model && out->profile == NULL) {
        argp_error(state, "--model is missing: pendulum, universal, tripod or machine");
    }
    if (out->has_wrist && out->has_model && out->model != KIN_MACHINE) {
        argp_error(state, "--wrist goes with --model machine: %s has no wrist",
                   kin_model_name(out->model));
    }
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    kin_options *out = state->input;
    switch (key) {
    case KEY_MODEL:
        take_model(state, out, arg);
        return 0;
    case KEY_WRIST:
        take_wrist(state, out, arg);
        return 0;
    case KEY_PROFILE:
        out->profile = arg;
        return 0;
    case ARGP_KEY_ARG:
        take_direction(state, out, arg);
        return 0;
    case ARGP_KEY_END:
        check(state, out);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

void kin_options_parse(int argc, char **argv, kin_options *out)
{
    static const struct argp argp = {options, parse, "inverse\nforward\njacobian", doc, NULL,
                                     NULL,    NULL};
    *out = (kin_options){.wrist = EXK_WRIST_AB};
    exk_args_parse(&argp, "exk-kin " EXK_VERSION, argc, argv, out);
}
