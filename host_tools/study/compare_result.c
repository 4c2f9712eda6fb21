#include "compare_result.h"

#include <math.h>

#include "exk/units.h"
#include "json_file.h"

study_figures study_compare_figures(const study_compare *compare, int i, exk_rig *rig,
                                    const study_tally *tallies)
{
    const study_cell cell = study_cell_at(i);
    const study_tally *t = &tallies[3 * i];
    const double rms = sqrt(t[0].moments.mean);
    study_cell_apply(compare, cell, rig);
    return (study_figures){.rms = EXK_MM_PER_M * rms,
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

static json_t *cell_json(const study_compare *compare, int i, const study_figures *f)
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

json_t *study_compare_json(const study_compare *compare, exk_rig *rig,
                           const study_tally *tallies, uint64_t n_trials)
{
    json_t *list = json_array();
    for (int i = 0; i < STUDY_N_CELLS; i++) {
        const study_figures f = study_compare_figures(compare, i, rig, tallies);
        json_array_append_new(list, cell_json(compare, i, &f));
    }
    return json_pack("{s:o, s:i, s:f, s:f, s:I}", "controllers", list, "updates",
                     STUDY_COMPARE_UPDATES, "kp", compare->kp, "ki_per_s", compare->ki, "seeds",
                     (json_int_t)n_trials);
}

int study_compare_run(const study_compare *compare, const study_work *work, study_sums *totals,
                      exk_rig *rig)
{
    int code = study_sums_open(totals, compare->measures, STUDY_N_COMPARE);
    if (code == STUDY_GOOD) {
        code = study_run(&compare->task, work, totals);
    }
    return code != STUDY_GOOD ? code : study_rig_open(rig, compare->folder, STUDY_S5);
}
