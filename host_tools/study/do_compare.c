#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "compare.h"
#include "exk/units.h"
#include "json_file.h"
#include "out_file.h"
#include "result.h"
#include "study_tool.h"

enum { SEEDS = 2000 };

/* A cell's figures, mm. */
typedef struct {
    double rms, rms_half95; /* root of the mean square, and half its 95 % interval */
    double last_rms;
    double last_mean;
    study_rms floor;
    study_rms theory;
} figures;

static figures measure(const study_compare *compare, int i, exk_rig *rig,
                       const study_tally *tallies)
{
    const study_cell cell = study_cell_at(i);
    const study_tally *t = &tallies[3 * i];
    const double rms = sqrt(t[0].moments.mean);
    study_cell_apply(compare, cell, rig);
    return (figures){.rms = EXK_MM_PER_M * rms,
                     .rms_half95 = EXK_MM_PER_M * study_tally_ci95(&t[0]) / (2.0 * rms),
                     .last_rms = EXK_MM_PER_M * sqrt(t[1].moments.mean),
                     .last_mean = EXK_MM_PER_M * t[2].moments.mean,
                     .floor = study_cell_floor(compare, cell, rig),
                     .theory = study_cell_theory(compare, cell, rig)};
}

/* To the floor, which is 0 where everything can be learned. */
static json_t *ratio(double value_mm, double floor_m)
{
    return exk_json_real(value_mm / (EXK_MM_PER_M * floor_m));
}

static json_t *cell_json(const study_compare *compare, int i, const figures *f)
{
    const study_cell cell = study_cell_at(i);
    const study_controller *controller = study_controller_at(cell.controller);
    return json_pack(
        "{s:s, s:s, s:s, s:f, s:[f,f], s:f, s:f, s:f, s:f, s:o, s:o, s:f, s:f}", "noise",
        compare->noises[cell.noise].name, "repeat", cell.frozen ? "frozen" : "fresh",
        "controller", controller->name, "rms_mm", f->rms, "rms_ci95", f->rms - f->rms_half95,
        f->rms + f->rms_half95, "last_point_mm", f->last_mean, "last_point_rms_mm", f->last_rms,
        "floor_rms_mm", EXK_MM_PER_M * f->floor.path_m, "floor_last_point_rms_mm",
        EXK_MM_PER_M * f->floor.last_m, "rms_over_floor", ratio(f->rms, f->floor.path_m),
        "last_over_floor", ratio(f->last_rms, f->floor.last_m), "theory_rms_mm",
        EXK_MM_PER_M * f->theory.path_m, "theory_last_point_rms_mm",
        EXK_MM_PER_M * f->theory.last_m);
}

static void print_cell(const study_compare *compare, int i, const figures *f)
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
    json_t *list = json_array();
    int code = STUDY_GOOD;
    if (table) {
        printf("Controllers over %llu seeds, radial rms in mm; learning: run %d after %d "
               "updates\n",
               (unsigned long long)n, STUDY_COMPARE_UPDATES + 1, STUDY_COMPARE_UPDATES);
    }
    for (int i = 0; i < STUDY_N_CELLS; i++) {
        const figures f = measure(compare, i, rig, totals->tallies);
        json_array_append_new(list, cell_json(compare, i, &f));
        if (table) {
            print_cell(compare, i, &f);
        }
    }
    json_t *root = json_pack("{s:o, s:i, s:f, s:f, s:I}", "controllers", list, "updates",
                             STUDY_COMPARE_UPDATES, "kp", compare->kp, "ki_per_s", compare->ki,
                             "seeds", (json_int_t)n);
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
    int code = study_sums_open(&totals, compare->measures, STUDY_N_COMPARE);
    if (code == STUDY_GOOD) {
        code = study_run(&compare->task, &work, &totals);
    }
    if (code == STUDY_GOOD) {
        code = study_rig_open(&rig, compare->folder, STUDY_S5);
    }
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
