#define _POSIX_C_SOURCE 200809L
#include "paper.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "noise_word.h"
#include "work.h"

typedef struct {
    const char *key;
    study_kind kind;
    uint32_t count_max;
} measure_row;

static const measure_row rows[STUDY_M_S7_HOLES] = {
    [STUDY_M_S1_NONE_RMS] = {"S1_none_rms", STUDY_LENGTH, 0},
    [STUDY_M_S1_ALPHA_RMS] = {"S1_alpha_rms", STUDY_LENGTH, 0},
    [STUDY_M_S1_BETA_RMS] = {"S1_beta_rms", STUDY_LENGTH, 0},
    [STUDY_M_S1_BOTH_RMS] = {"S1_both_rms", STUDY_LENGTH, 0},
    [STUDY_M_S1_ALPHA_LESS_BETA] = {"S1_alpha_less_beta", STUDY_SIGNED, 0},
    [STUDY_M_S1_BOTH_LESS_ALPHA] = {"S1_both_less_alpha", STUDY_SIGNED, 0},
    [STUDY_M_S2_ALPHA_RMS] = {"S2_alpha_rms", STUDY_LENGTH, 0},
    [STUDY_M_S2_BETA_RMS] = {"S2_beta_rms", STUDY_LENGTH, 0},
    [STUDY_M_S2_BOTH_RMS] = {"S2_both_rms", STUDY_LENGTH, 0},
    [STUDY_M_S2_ALPHA_LESS_BETA] = {"S2_alpha_less_beta", STUDY_SIGNED, 0},
    [STUDY_M_S2_GROWTH] = {"S2_growth", STUDY_SIGNED, 0},
    [STUDY_M_S2_WHITE_RMS] = {"S2_white_rms", STUDY_LENGTH, 0},
    [STUDY_M_S2_WHITE_GROWTH] = {"S2_white_growth", STUDY_SIGNED, 0},
    [STUDY_M_S3_MINUS_THIRD] = {"S3_minus_third", STUDY_LENGTH, 0},
    [STUDY_M_S3_PLUS_FIRST] = {"S3_plus_first", STUDY_LENGTH, 0},
    [STUDY_M_S3_MINUS_END] = {"S3_minus_end", STUDY_COUNT, 1},
    [STUDY_M_S3_PLUS_END] = {"S3_plus_end", STUDY_COUNT, 1},
    [STUDY_M_S3_RMS] = {"S3_rms", STUDY_LENGTH, 0},
    [STUDY_M_S3_LESS_S2] = {"S3_less_S2", STUDY_SIGNED, 0},
    [STUDY_M_S3_LESS_S1] = {"S3_less_S1", STUDY_SIGNED, 0},
    [STUDY_M_S4_RMS_1] = {"S4_rms_1", STUDY_LENGTH, 0},
    [STUDY_M_S4_RMS_2] = {"S4_rms_2", STUDY_LENGTH, 0},
    [STUDY_M_S4_RMS_3] = {"S4_rms_3", STUDY_LENGTH, 0},
    [STUDY_M_S4_FALL_2] = {"S4_fall_2", STUDY_SIGNED, 0},
    [STUDY_M_S4_FALL_3] = {"S4_fall_3", STUDY_SIGNED, 0},
    [STUDY_M_S4_GAP] = {"S4_gap", STUDY_LENGTH, 0},
    [STUDY_M_S4_DX_LESS_DY] = {"S4_dx_less_dy", STUDY_SIGNED, 0},
    [STUDY_M_S5_LAST_1] = {"S5_last_1", STUDY_LENGTH, 0},
    [STUDY_M_S5_LAST_2] = {"S5_last_2", STUDY_LENGTH, 0},
    [STUDY_M_S5_LAST_3] = {"S5_last_3", STUDY_LENGTH, 0},
    [STUDY_M_S5_MEAN10] = {"S5_mean10", STUDY_LENGTH, 0},
    [STUDY_M_S6_LAST] = {"S6_last", STUDY_LENGTH, 0},
    [STUDY_M_S6_MEAN10] = {"S6_mean10", STUDY_LENGTH, 0},
    [STUDY_M_S7_MIN] = {"S7_min", STUDY_LENGTH, 0},
    [STUDY_M_S7_MAX] = {"S7_max", STUDY_LENGTH, 0},
    [STUDY_M_S7_MEAN] = {"S7_mean", STUDY_LENGTH, 0},
    [STUDY_M_S7_EDGE] = {"S7_edge_less_inner", STUDY_SIGNED, 0},
    [STUDY_M_S7_TURN] = {"S7_turn_less_rest", STUDY_SIGNED, 0},
    [STUDY_M_S8_MIN] = {"S8_min", STUDY_LENGTH, 0},
    [STUDY_M_S8_MAX] = {"S8_max", STUDY_LENGTH, 0},
    [STUDY_M_S8_MEAN] = {"S8_mean", STUDY_LENGTH, 0},
    [STUDY_M_S8_EDGE] = {"S8_edge_less_inner", STUDY_SIGNED, 0},
    [STUDY_M_S8_TURN] = {"S8_turn_less_rest", STUDY_SIGNED, 0},
    [STUDY_M_S8_LESS_S7] = {"S8_mean_less_S7_mean", STUDY_SIGNED, 0},
    [STUDY_M_S9_INSIDE] = {"S9_inside", STUDY_COUNT, STUDY_GRID45},
    [STUDY_M_S9_MEAN] = {"S9_mean", STUDY_LENGTH, 0},
    [STUDY_M_S9_HOLE] = {"S9_hole", STUDY_LENGTH, 0},
    [STUDY_M_S9_HOLE2] = {"S9_hole_squared", STUDY_SIGNED, 0},
};

/* The path of one run against its reference. */
typedef struct {
    int64_t n_all;
    int64_t n_half[2];
    double sum_sq_m2[2]; /* first and second half */
    int64_t n_first;     /* samples in the first and in the third quadrant */
    int64_t n_third;
    double last_m[2];
} path_figures;

typedef struct {
    study_lab lab[STUDY_N_EXPERIMENTS];
    path_figures path;
    double group_m[2]; /* S5, S6: sums over the trials of a group */
    bool edge[STUDY_GRID25];
    bool turn[STUDY_GRID25];
} bench_set;

static void look(void *ctx, const exk_sample *sample)
{
    path_figures *path = ctx;
    const int half = 2 * sample->k >= path->n_all;
    double d_m[2];
    exk_plane_error(sample->real.tip_m, sample->ref.tip_m, sample->ref.axis, d_m);
    path->n_half[half]++;
    path->sum_sq_m2[half] += d_m[0] * d_m[0] + d_m[1] * d_m[1];
    path->n_first += d_m[0] > 0.0 && d_m[1] > 0.0;
    path->n_third += d_m[0] < 0.0 && d_m[1] < 0.0;
    path->last_m[0] = d_m[0];
    path->last_m[1] = d_m[1];
}

static double half_rms_m(const path_figures *path, int half)
{
    return sqrt(path->sum_sq_m2[half] / (double)path->n_half[half]);
}

static double growth_m(const path_figures *path)
{
    return half_rms_m(path, 1) - half_rms_m(path, 0);
}

static double rms_m(const path_figures *path)
{
    return sqrt((path->sum_sq_m2[0] + path->sum_sq_m2[1]) / (double)path->n_all);
}

static double last_m(const path_figures *path)
{
    return sqrt(path->last_m[0] * path->last_m[0] + path->last_m[1] * path->last_m[1]);
}

/* Share of the samples after the first, where orders 1 and 2 begin at zero. */
static double share(const path_figures *path, int64_t n)
{
    return (double)n / (double)(path->n_all - 1);
}

static int run_path(bench_set *set, study_experiment which, uint32_t trial, int run)
{
    study_lab *lab = &set->lab[which];
    exk_accuracy accuracy;
    set->path = (path_figures){.n_all = (int64_t)lab->series.n};
    lab->series.on_sample = look;
    lab->series.sample_ctx = &set->path;
    if (run == 1) {
        study_lab_begin(lab, trial);
    }
    return study_lab_run(lab, trial, run, &accuracy);
}

static void add(study_tally *tallies, study_paper_measure which, double value)
{
    study_tally_add(&tallies[which], value);
}

/* rms of each of the experiments first, first + 1, ... into rms; path is then the last one's. */
static int run_paths(bench_set *set, uint32_t trial, study_experiment first, int n,
                     study_paper_measure measure, study_tally *tallies, double *rms)
{
    int code = STUDY_GOOD;
    for (int i = 0; i < n && code == STUDY_GOOD; i++) {
        code = run_path(set, (study_experiment)((int)first + i), trial, 1);
        rms[i] = rms_m(&set->path);
        add(tallies, (study_paper_measure)((int)measure + i), rms[i]);
    }
    return code;
}

static int run_s1(bench_set *set, uint32_t trial, study_tally *tallies, double *both_m)
{
    double rms[4] = {0.0};
    const int code = run_paths(set, trial, STUDY_S1_NONE, 4, STUDY_M_S1_NONE_RMS, tallies, rms);
    add(tallies, STUDY_M_S1_ALPHA_LESS_BETA, rms[1] - rms[2]);
    add(tallies, STUDY_M_S1_BOTH_LESS_ALPHA, rms[3] - rms[1]);
    *both_m = rms[3];
    return code;
}

static int run_s2(bench_set *set, uint32_t trial, study_tally *tallies, double *both_m)
{
    double rms[3] = {0.0};
    int code = run_paths(set, trial, STUDY_S2_ALPHA, 3, STUDY_M_S2_ALPHA_RMS, tallies, rms);
    add(tallies, STUDY_M_S2_ALPHA_LESS_BETA, rms[0] - rms[1]);
    add(tallies, STUDY_M_S2_GROWTH, growth_m(&set->path));
    *both_m = rms[2];
    if (code == STUDY_GOOD) {
        code = run_path(set, STUDY_S2_WHITE, trial, 1);
        add(tallies, STUDY_M_S2_WHITE_RMS, rms_m(&set->path));
        add(tallies, STUDY_M_S2_WHITE_GROWTH, growth_m(&set->path));
    }
    return code;
}

static int run_s3(bench_set *set, uint32_t trial, study_tally *tallies, double s1_m,
                  double s2_m)
{
    const path_figures *path = &set->path;
    int code = run_path(set, STUDY_S3_MINUS, trial, 1);
    add(tallies, STUDY_M_S3_MINUS_THIRD, share(path, path->n_third));
    add(tallies, STUDY_M_S3_MINUS_END, path->last_m[0] < 0.0 && path->last_m[1] < 0.0);
    if (code == STUDY_GOOD) {
        code = run_path(set, STUDY_S3_PLUS, trial, 1);
    }
    add(tallies, STUDY_M_S3_PLUS_FIRST, share(path, path->n_first));
    add(tallies, STUDY_M_S3_PLUS_END, path->last_m[0] > 0.0 && path->last_m[1] > 0.0);
    add(tallies, STUDY_M_S3_RMS, rms_m(path));
    add(tallies, STUDY_M_S3_LESS_S2, rms_m(path) - s2_m);
    add(tallies, STUDY_M_S3_LESS_S1, rms_m(path) - s1_m);
    return code;
}

static int run_s4(bench_set *set, uint32_t trial, study_tally *tallies)
{
    const path_figures *path = &set->path;
    double before_m = 0.0;
    for (int run = 1; run <= 3; run++) {
        const int code = run_path(set, STUDY_S4, trial, run);
        if (code != STUDY_GOOD || exk_series_learn(&set->lab[STUDY_S4].series) != EXK_OK) {
            return code != STUDY_GOOD ? code : STUDY_MISS;
        }
        add(tallies, (study_paper_measure)(STUDY_M_S4_RMS_1 + run - 1), rms_m(path));
        if (run > 1) {
            add(tallies, (study_paper_measure)(STUDY_M_S4_FALL_2 + run - 2),
                before_m - rms_m(path));
        }
        before_m = rms_m(path);
    }
    add(tallies, STUDY_M_S4_GAP, last_m(path));
    add(tallies, STUDY_M_S4_DX_LESS_DY, fabs(path->last_m[0]) - fabs(path->last_m[1]));
    return STUDY_GOOD;
}

/* One number a trial and one a group of trials; groups begin at multiples of their size. */
static void add_to_group(double *sum_m, uint32_t trial, double value_m, study_tally *tallies,
                         study_paper_measure mean10)
{
    *sum_m = trial % STUDY_GROUP == 0 ? value_m : *sum_m + value_m;
    if (trial % STUDY_GROUP == STUDY_GROUP - 1) {
        add(tallies, mean10, *sum_m / STUDY_GROUP);
    }
}

static int run_s5(bench_set *set, uint32_t trial, study_tally *tallies)
{
    study_lab *lab = &set->lab[STUDY_S5];
    exk_accuracy accuracy = {.n_drilled = 0};
    study_lab_begin(lab, trial);
    for (int run = 1; run <= 3; run++) {
        const int code = study_lab_run(lab, trial, run, &accuracy);
        if (code != STUDY_GOOD || exk_series_learn(&lab->series) != EXK_OK) {
            return code != STUDY_GOOD ? code : STUDY_MISS;
        }
        add(tallies, (study_paper_measure)(STUDY_M_S5_LAST_1 + run - 1), accuracy.last_point_m);
    }
    add_to_group(&set->group_m[0], trial, accuracy.last_point_m, tallies, STUDY_M_S5_MEAN10);
    return STUDY_GOOD;
}

static int run_s6(bench_set *set, uint32_t trial, study_tally *tallies)
{
    exk_accuracy accuracy = {.n_drilled = 0};
    const int code = study_lab_trial(&set->lab[STUDY_S6], trial, &accuracy);
    add(tallies, STUDY_M_S6_LAST, accuracy.last_point_m);
    add_to_group(&set->group_m[1], trial, accuracy.last_point_m, tallies, STUDY_M_S6_MEAN10);
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
static int run_grid25(bench_set *set, study_experiment which, uint32_t trial,
                      study_paper_measure first, study_paper_measure holes_first,
                      study_tally *tallies, double *mean_m)
{
    const exk_hole_result *holes = set->lab[which].series.results;
    exk_accuracy accuracy;
    const int code = study_lab_trial(&set->lab[which], trial, &accuracy);
    double min_m = INFINITY, max_m = 0.0, sum_m = 0.0;
    for (int i = 0; i < STUDY_GRID25; i++) {
        add(tallies, (study_paper_measure)((int)holes_first + i), holes[i].radial_m);
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
        add(tallies, (study_paper_measure)((int)first + i), values[i]);
    }
    return code;
}

static int run_s9(bench_set *set, uint32_t trial, study_tally *tallies)
{
    const exk_hole_result *holes = set->lab[STUDY_S9].series.results;
    exk_accuracy accuracy = {.n_drilled = 0};
    const int code = study_lab_trial(&set->lab[STUDY_S9], trial, &accuracy);
    for (int i = 0; i < STUDY_GRID45; i++) {
        add(tallies, STUDY_M_S9_HOLE, holes[i].radial_m);
        add(tallies, STUDY_M_S9_HOLE2, holes[i].radial_m * holes[i].radial_m);
    }
    add(tallies, STUDY_M_S9_INSIDE, (double)accuracy.n_inside);
    add(tallies, STUDY_M_S9_MEAN, accuracy.mean_m);
    return code;
}

static int run_trial(void *worker, uint32_t trial, study_tally *tallies)
{
    bench_set *set = worker;
    double s1_m = 0.0, s2_m = 0.0, s7_m = 0.0, s8_m = 0.0;
    int code = run_s1(set, trial, tallies, &s1_m);
    code = code != STUDY_GOOD ? code : run_s2(set, trial, tallies, &s2_m);
    code = code != STUDY_GOOD ? code : run_s3(set, trial, tallies, s1_m, s2_m);
    code = code != STUDY_GOOD ? code : run_s4(set, trial, tallies);
    code = code != STUDY_GOOD ? code : run_s5(set, trial, tallies);
    code = code != STUDY_GOOD ? code : run_s6(set, trial, tallies);
    code = code != STUDY_GOOD ? code
                              : run_grid25(set, STUDY_S7, trial, STUDY_M_S7_MIN,
                                           STUDY_M_S7_HOLES, tallies, &s7_m);
    code = code != STUDY_GOOD ? code
                              : run_grid25(set, STUDY_S8, trial, STUDY_M_S8_MIN,
                                           STUDY_M_S8_HOLES, tallies, &s8_m);
    add(tallies, STUDY_M_S8_LESS_S7, s8_m - s7_m);
    return code != STUDY_GOOD ? code : run_s9(set, trial, tallies);
}

static void close_set(void *worker)
{
    bench_set *set = worker;
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

static void mark_places(bench_set *set)
{
    const exk_rig *rig = set->lab[STUDY_S7].rig;
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

static int check_counts(const bench_set *set)
{
    static const struct {
        study_experiment which;
        size_t n_holes;
    } wanted[] = {{STUDY_S7, STUDY_GRID25}, {STUDY_S8, STUDY_GRID25}, {STUDY_S9, STUDY_GRID45}};
    for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; i++) {
        const size_t found = set->lab[wanted[i].which].rig->n_holes;
        if (found != wanted[i].n_holes) {
            fprintf(stderr, "exk-study: %s.ini has %zu holes; the study has %zu\n",
                    study_experiment_at(wanted[i].which)->name, found, wanted[i].n_holes);
            return STUDY_INPUT;
        }
    }
    return STUDY_GOOD;
}

static int open_set(const void *setup, void **worker)
{
    const study_paper *paper = setup;
    bench_set *set = calloc(1, sizeof *set);
    int code = set == NULL ? STUDY_IO : STUDY_GOOD;
    for (int i = 0; i < STUDY_N_EXPERIMENTS && code == STUDY_GOOD; i++) {
        code = study_lab_open(&set->lab[i], paper->folder, (study_experiment)i);
    }
    code = code != STUDY_GOOD ? code : check_counts(set);
    if (code != STUDY_GOOD) {
        if (set != NULL) {
            close_set(set);
        }
        return code;
    }
    mark_places(set);
    *worker = set;
    return STUDY_GOOD;
}

static void name_holes(study_measure *measures, const char *which)
{
    for (int i = 0; i < STUDY_GRID25; i++) {
        measures[i] = (study_measure){.unit = "m", .kind = STUDY_LENGTH};
        snprintf(measures[i].key, STUDY_KEY_MAX, "%s_hole_%02d", which, i + 1);
    }
}

static const char *unit_of(int measure)
{
    const bool is_share = measure == STUDY_M_S3_MINUS_THIRD || measure == STUDY_M_S3_PLUS_FIRST;
    if (is_share || rows[measure].kind == STUDY_COUNT) {
        return "";
    }
    return measure == STUDY_M_S9_HOLE2 ? "m2" : "m";
}

static void name_measures(study_measure *measures)
{
    for (int i = 0; i < STUDY_M_S7_HOLES; i++) {
        measures[i] = (study_measure){
            .unit = unit_of(i), .kind = rows[i].kind, .count_max = rows[i].count_max};
        snprintf(measures[i].key, STUDY_KEY_MAX, "%s", rows[i].key);
    }
    name_holes(measures + STUDY_M_S7_HOLES, "S7");
    name_holes(measures + STUDY_M_S8_HOLES, "S8");
}

/* Effective profiles decide the numbers; where they lie and their comments do not. */
static int read_profiles(study_paper *paper, FILE *all)
{
    for (int i = 0; i < STUDY_N_EXPERIMENTS; i++) {
        char text[8192];
        exk_rig rig;
        const int code = study_rig_open(&rig, paper->folder, (study_experiment)i);
        if (code != STUDY_GOOD) {
            return code;
        }
        paper->profiles[i] = rig.profile;
        exk_profile_print(&rig.profile, text, sizeof text);
        fprintf(all, "%s\n%s\n", study_experiment_at((study_experiment)i)->name, text);
        exk_rig_close(&rig);
    }
    return STUDY_GOOD;
}

static const char *noise_of(const exk_profile *profiles)
{
    const char *word = "none";
    for (int i = 0; i < STUDY_N_EXPERIMENTS; i++) {
        const char *here = exk_noise_word(&profiles[i]);
        if (strcmp(here, "none") != 0 && strcmp(word, "none") != 0 && strcmp(here, word) != 0) {
            return "mixed";
        }
        word = strcmp(here, "none") != 0 ? here : word;
    }
    return word;
}

int study_paper_init(study_paper *paper, const char *folder)
{
    char *text = NULL;
    size_t size = 0;
    FILE *all = open_memstream(&text, &size);
    if (!study_find_profiles(folder, paper->folder) || all == NULL) {
        if (all != NULL) {
            fclose(all);
        }
        free(text);
        return STUDY_INPUT;
    }
    name_measures(paper->measures);
    const int code = read_profiles(paper, all);
    fclose(all);
    paper->noise = noise_of(paper->profiles);
    paper->task = (study_task){.name = "exk-study paper",
                               .measures = paper->measures,
                               .n_measures = STUDY_N_PAPER,
                               .hash = study_hash(paper->measures, STUDY_N_PAPER, text),
                               .setup = paper,
                               .open = open_set,
                               .close = close_set,
                               .run = run_trial};
    free(text);
    return code;
}
