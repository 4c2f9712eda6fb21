#include "plot_list.h"

#include <string.h>

#include "gnuplot.h"

void exk_plot_list_add(exk_plot_list *list, const struct argp_state *state, const char *arg)
{
    exk_out_kind kind;
    if (!exk_plot_kind(arg, &kind)) {
        argp_error(state, "--plot %s: a picture ends in .svg or .png", arg);
    }
    if (list->n == EXK_PLOTS_MAX) {
        argp_error(state, "--plot %s: at most %d pictures in one call", arg, EXK_PLOTS_MAX);
    }
    list->path[list->n++] = arg;
}

static bool is_stdout(const char *path)
{
    return path != NULL && strcmp(path, "-") == 0;
}

void exk_refuse_two_on_stdout(const struct argp_state *state, const char *json_path,
                              const char *csv_path)
{
    if (is_stdout(json_path) && is_stdout(csv_path)) {
        argp_error(state, "--json and --csv - both want standard output: give one a file, "
                          "--json=FILE or --csv FILE");
    }
}
