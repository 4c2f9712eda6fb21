/** The pictures asked for on a command line: --plot FILE, several times. */
#ifndef EXK_TOOLS_PLOT_LIST_H
#define EXK_TOOLS_PLOT_LIST_H

#include <argp.h>
#include <stdbool.h>
#include <stddef.h>

enum { EXK_PLOTS_MAX = 8 };

typedef struct {
    const char *path[EXK_PLOTS_MAX];
    size_t n;
} exk_plot_list;

/** Adds one; argp_error when it does not end in .svg or .png, or is one too many. */
void exk_plot_list_add(exk_plot_list *list, const struct argp_state *state, const char *arg);

/** argp_error when both --json and --csv ask for standard output ("-"). NULL: not asked for. */
void exk_refuse_two_on_stdout(const struct argp_state *state, const char *json_path,
                              const char *csv_path);

#endif
