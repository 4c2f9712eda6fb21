#include "trial.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "trial_set.h"
#include "work.h"

/* One number a trial and one a group of trials; groups begin at multiples of their size. */
static void add_to_group(double *sum_m, uint32_t trial, double value_m, study_tally *tallies,
                         study_paper_measure mean10)
{
    *sum_m = trial % STUDY_GROUP == 0 ? value_m : *sum_m + value_m;
    if (trial % STUDY_GROUP == STUDY_GROUP - 1) {
        study_add(tallies, (int)mean10, *sum_m / STUDY_GROUP);
    }
}

static int run_s5(study_set *set, uint32_t trial, study_tally *tallies)
{
    study_lab *lab = &set->lab[STUDY_S5];
    exk_accuracy accuracy = {.n_drilled = 0};
    study_lab_begin(lab, trial);
    for (int run = 1; run <= 3; run++) {
        const int code = study_lab_run(lab, trial, run, &accuracy);
        if (code != STUDY_GOOD || exk_series_learn(&lab->series) != EXK_OK) {
            return code != STUDY_GOOD ? code : STUDY_MISS;
        }
        study_add(tallies, STUDY_M_S5_LAST_1 + run - 1, accuracy.last_point_m);
    }
    add_to_group(&set->s5_group_m, trial, accuracy.last_point_m, tallies, STUDY_M_S5_MEAN10);
    return STUDY_GOOD;
}

static int run_s6(study_set *set, uint32_t trial, study_tally *tallies)
{
    exk_accuracy accuracy = {.n_drilled = 0};
    const int code = study_lab_trial(&set->lab[STUDY_S6], trial, &accuracy);
    study_add(tallies, STUDY_M_S6_LAST, accuracy.last_point_m);
    add_to_group(&set->s6_group_m, trial, accuracy.last_point_m, tallies, STUDY_M_S6_MEAN10);
    return code;
}

/* Mean over the holes where marked is as asked, the first hole left out. */
static double mean_where(const exk_hole_result *holes, const bool *marked, bool asked)
{
    double sum_m = 0.0;
    int n = 0;
    for (int i = 1; i < STUDY_GRID25; i++) {
        if (marked[i] == asked) {
            sum_m += holes[i].radial_m;
            n++;
        }
    }
    return sum_m / n;
}

static double contrast(const exk_hole_result *holes, const bool *marked)
{
    return mean_where(holes, marked, true) - mean_where(holes, marked, false);
}

/* S7 or S8; first and holes are their places among the measures. */
static int run_grid25(study_set *set, study_experiment which, uint32_t trial,
                      study_paper_measure first, study_paper_measure holes_first,
                      study_tally *tallies, double *mean_m)
{
    const exk_hole_result *holes = set->lab[which].series.results;
    exk_accuracy accuracy;
    const int code = study_lab_trial(&set->lab[which], trial, &accuracy);
    double min_m = INFINITY, max_m = 0.0, sum_m = 0.0;
    for (int i = 0; i < STUDY_GRID25; i++) {
        study_add(tallies, (int)holes_first + i, holes[i].radial_m);
        if (i > 0) {
            min_m = fmin(min_m, holes[i].radial_m);
            max_m = fmax(max_m, holes[i].radial_m);
            sum_m += holes[i].radial_m;
        }
    }
    *mean_m = sum_m / (STUDY_GRID25 - 1);
    const double values[] = {min_m, max_m, *mean_m, contrast(holes, set->edge),
                             contrast(holes, set->turn)};
    for (int i = 0; i < 5; i++) {
        study_add(tallies, (int)first + i, values[i]);
    }
    return code;
}

static int run_s9(study_set *set, uint32_t trial, study_tally *tallies)
{
    const exk_hole_result *holes = set->lab[STUDY_S9].series.results;
    exk_accuracy accuracy = {.n_drilled = 0};
    const int code = study_lab_trial(&set->lab[STUDY_S9], trial, &accuracy);
    for (int i = 0; i < STUDY_GRID45; i++) {
        study_add(tallies, STUDY_M_S9_HOLE, holes[i].radial_m);
        study_add(tallies, STUDY_M_S9_HOLE2, holes[i].radial_m * holes[i].radial_m);
    }
    study_add(tallies, STUDY_M_S9_INSIDE, (double)accuracy.n_inside);
    study_add(tallies, STUDY_M_S9_MEAN, accuracy.mean_m);
    return code;
}

static int run_s7(study_set *set, uint32_t trial, study_tally *tallies)
{
    return run_grid25(set, STUDY_S7, trial, STUDY_M_S7_MIN, STUDY_M_S7_HOLES, tallies,
                      &set->s7_m);
}

static int run_s8(study_set *set, uint32_t trial, study_tally *tallies)
{
    double mean_m = 0.0;
    const int code =
        run_grid25(set, STUDY_S8, trial, STUDY_M_S8_MIN, STUDY_M_S8_HOLES, tallies, &mean_m);
    if (set->parts & 1U << STUDY_PART_S7) {
        study_add(tallies, STUDY_M_S8_LESS_S7, mean_m - set->s7_m);
    }
    return code;
}

int study_trial_run(void *worker, uint32_t trial, study_tally *tallies)
{
    static int (*const parts[STUDY_N_PARTS])(study_set *, uint32_t, study_tally *) = {
        [STUDY_PART_S1] = study_trial_s1, [STUDY_PART_S2] = study_trial_s2,
        [STUDY_PART_S3] = study_trial_s3, [STUDY_PART_S4] = study_trial_s4,
        [STUDY_PART_S5] = run_s5,         [STUDY_PART_S6] = run_s6,
        [STUDY_PART_S7] = run_s7,         [STUDY_PART_S8] = run_s8,
        [STUDY_PART_S9] = run_s9,
    };
    study_set *set = worker;
    int code = STUDY_GOOD;
    for (int i = 0; i < STUDY_N_PARTS && code == STUDY_GOOD; i++) {
        if (set->parts & 1U << i) {
            code = parts[i](set, trial, tallies);
        }
    }
    return code;
}

void study_trial_close(void *worker)
{
    study_set *set = worker;
    for (int i = 0; i < STUDY_N_EXPERIMENTS; i++) {
        study_lab_close(&set->lab[i]);
    }
    free(set);
}

/* Same height but for rounding, as the rows of a grid are laid out. */
static bool same(double a_m, double b_m)
{
    return fabs(a_m - b_m) < 1e-9;
}

static void mark_places(study_set *set, const exk_rig *rig)
{
    const exk_hole *holes = rig->holes;
    const exk_pattern *pattern = &rig->profile.job.pattern;
    for (int i = 0; i < STUDY_GRID25; i++) {
        const double *at_m = holes[i].target_m;
        const double x_m = fabs(at_m[EXK_X] - pattern->center_m[EXK_X]);
        const double y_m = fabs(at_m[EXK_Y] - pattern->center_m[EXK_Y]);
        set->edge[i] = same(x_m, 0.5 * pattern->width_m) || same(y_m, 0.5 * pattern->height_m);
        set->turn[i] =
            (i > 0 && !same(at_m[EXK_Y], holes[i - 1].target_m[EXK_Y])) ||
            (i + 1 < STUDY_GRID25 && !same(at_m[EXK_Y], holes[i + 1].target_m[EXK_Y]));
    }
}

static int check_counts(const study_set *set)
{
    static const struct {
        study_experiment which;
        size_t n_holes;
    } wanted[] = {{STUDY_S7, STUDY_GRID25}, {STUDY_S8, STUDY_GRID25}, {STUDY_S9, STUDY_GRID45}};
    for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; i++) {
        const exk_rig *rig = set->lab[wanted[i].which].rig;
        const size_t found = rig == NULL ? wanted[i].n_holes : rig->n_holes;
        if (found != wanted[i].n_holes) {
            fprintf(stderr, "exk-study: %s.ini has %zu holes; the study has %zu\n",
                    study_experiment_at(wanted[i].which)->name, found, wanted[i].n_holes);
            return STUDY_INPUT;
        }
    }
    return STUDY_GOOD;
}

int study_trial_open(const void *setup, void **worker)
{
    const study_paper *paper = setup;
    study_set *set = calloc(1, sizeof *set);
    int code = set == NULL ? STUDY_IO : STUDY_GOOD;
    for (int i = 0; i < STUDY_N_EXPERIMENTS && code == STUDY_GOOD; i++) {
        if (paper->parts & 1U << study_experiment_at((study_experiment)i)->part) {
            code = study_lab_open(&set->lab[i], paper->folder, (study_experiment)i,
                                  &paper->variant);
            set->lab[i].series.by_steps = paper->by_steps;
        }
    }
    code = code != STUDY_GOOD ? code : check_counts(set);
    if (code != STUDY_GOOD) {
        if (set != NULL) {
            study_trial_close(set);
        }
        return code;
    }
    set->parts = paper->parts;
    if (set->lab[STUDY_S7].rig != NULL) {
        mark_places(set, set->lab[STUDY_S7].rig);
    }
    *worker = set;
    return STUDY_GOOD;
}
