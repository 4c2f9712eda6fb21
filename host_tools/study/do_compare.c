#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "compare_result.h"
#include "exk/units.h"
#include "json_file.h"
#include "out_file.h"
#include "result.h"
#include "study_tool.h"

enum { SEEDS = 2000 };

static void print_cell(const study_compare *compare, int i, const study_figures *f)
{
    const study_cell cell = study_cell_at(i);
    const double floor_mm = EXK_MM_PER_M * f->floor.path_m;
    if (cell.controller == 0) {
        printf("\n%s, %s noise\n%-26s %10s %10s %9s %10s %10s\n",
               compare->noises[cell.noise].word, cell.frozen ? "frozen" : "fresh", "controller",
               "rms", "floor", "x floor", "theory", "last point");
    }
    printf("%-26s %10.6f %10.6f", study_controller_at(cell.controller)->word, f->rms, floor_mm);
    if (floor_mm > 0.0) {
        printf(" %9.3f", f->rms / floor_mm);
    } else {
        printf(" %9s", "-");
    }
    printf(" %10.6f %10.6f\n", EXK_MM_PER_M * f->theory.path_m, f->last_mean);
}

static int show(const study_options *options, const study_compare *compare, exk_rig *rig,
                const study_sums *totals, uint64_t n)
{
    const bool table = options->json == NULL || options->json[0] != '-';
    int code = STUDY_GOOD;
    if (table) {
        printf("Controllers over %llu seeds, radial rms in mm; learning: run %d after %d "
               "updates\n",
               (unsigned long long)n, STUDY_COMPARE_UPDATES + 1, STUDY_COMPARE_UPDATES);
    }
    for (int i = 0; table && i < STUDY_N_CELLS; i++) {
        const study_figures f = study_compare_figures(compare, i, rig, totals->tallies);
        print_cell(compare, i, &f);
    }
    json_t *root = study_compare_json(compare, rig, totals->tallies, n);
    if (options->json != NULL) {
        code = study_write_json(root, options->json);
    }
    json_decref(root);
    return code != STUDY_GOOD ? code : exk_stdout_flush("exk-study");
}

static int compare_all(const study_options *options, study_compare *compare)
{
    const uint64_t n = options->n_seeds > 0 ? options->n_seeds : SEEDS;
    const study_work work = study_work_of(options, n);
    study_sums totals;
    exk_rig rig;
    int code = study_compare_run(compare, &work, &totals, &rig);
    if (code == STUDY_GOOD) {
        code = show(options, compare, &rig, &totals, n);
        exk_rig_close(&rig);
    }
    study_sums_close(&totals);
    return code;
}

int study_do_compare(const study_options *options)
{
    study_compare *compare = calloc(1, sizeof *compare);
    int code = compare == NULL ? STUDY_IO : study_compare_init(compare, options->profiles);
    if (code == STUDY_GOOD) {
        code = compare_all(options, compare);
    }
    free(compare);
    return code;
}
