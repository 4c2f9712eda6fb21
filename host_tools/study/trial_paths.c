#include <math.h>

#include "trial_set.h"

static void look(void *ctx, const exk_judged_point *point)
{
    study_path *path = ctx;
    const int half = 2 * point->k >= path->n_all;
    double d_m[2];
    exk_plane_error(point->tool.tip_m, point->ref.tip_m, point->ref.axis, d_m);
    path->n_half[half]++;
    path->sum_sq_m2[half] += d_m[0] * d_m[0] + d_m[1] * d_m[1];
    path->n_first += d_m[0] > 0.0 && d_m[1] > 0.0;
    path->n_third += d_m[0] < 0.0 && d_m[1] < 0.0;
    path->last_m[0] = d_m[0];
    path->last_m[1] = d_m[1];
}

static double half_rms_m(const study_path *path, int half)
{
    return sqrt(path->sum_sq_m2[half] / (double)path->n_half[half]);
}

static double growth_m(const study_path *path)
{
    return half_rms_m(path, 1) - half_rms_m(path, 0);
}

static double rms_m(const study_path *path)
{
    return sqrt((path->sum_sq_m2[0] + path->sum_sq_m2[1]) / (double)path->n_all);
}

static double last_m(const study_path *path)
{
    return sqrt(path->last_m[0] * path->last_m[0] + path->last_m[1] * path->last_m[1]);
}

/* Share of the samples after the first, where orders 1 and 2 begin at zero. */
static double share(const study_path *path, int64_t n)
{
    return (double)n / (double)(path->n_all - 1);
}

static int run_path(study_set *set, study_experiment which, uint32_t trial, int run)
{
    study_lab *lab = &set->lab[which];
    exk_accuracy accuracy;
    set->path = (study_path){.n_all = (int64_t)lab->series.n};
    lab->series.on_point = look;
    lab->series.point_ctx = &set->path;
    if (run == 1) {
        study_lab_begin(lab, trial);
    }
    return study_lab_run(lab, trial, run, &accuracy);
}

/* rms of each of the experiments first, first + 1, ... into rms; path is then the last one's. */
static int run_paths(study_set *set, uint32_t trial, study_experiment first, int n,
                     study_paper_measure measure, study_tally *tallies, double *rms)
{
    int code = STUDY_GOOD;
    for (int i = 0; i < n && code == STUDY_GOOD; i++) {
        code = run_path(set, (study_experiment)((int)first + i), trial, 1);
        rms[i] = rms_m(&set->path);
        study_add(tallies, (int)measure + i, rms[i]);
    }
    return code;
}

int study_trial_s1(study_set *set, uint32_t trial, study_tally *tallies)
{
    double rms[4] = {0.0};
    const int code = run_paths(set, trial, STUDY_S1_NONE, 4, STUDY_M_S1_NONE_RMS, tallies, rms);
    study_add(tallies, STUDY_M_S1_ALPHA_LESS_BETA, rms[1] - rms[2]);
    study_add(tallies, STUDY_M_S1_BOTH_LESS_ALPHA, rms[3] - rms[1]);
    set->s1_m = rms[3];
    return code;
}

int study_trial_s2(study_set *set, uint32_t trial, study_tally *tallies)
{
    double rms[3] = {0.0};
    int code = run_paths(set, trial, STUDY_S2_ALPHA, 3, STUDY_M_S2_ALPHA_RMS, tallies, rms);
    study_add(tallies, STUDY_M_S2_ALPHA_LESS_BETA, rms[0] - rms[1]);
    study_add(tallies, STUDY_M_S2_GROWTH, growth_m(&set->path));
    set->s2_m = rms[2];
    if (code == STUDY_GOOD) {
        code = run_path(set, STUDY_S2_WHITE, trial, 1);
        study_add(tallies, STUDY_M_S2_WHITE_RMS, rms_m(&set->path));
        study_add(tallies, STUDY_M_S2_WHITE_GROWTH, growth_m(&set->path));
    }
    return code;
}

int study_trial_s3(study_set *set, uint32_t trial, study_tally *tallies)
{
    const study_path *path = &set->path;
    int code = run_path(set, STUDY_S3_MINUS, trial, 1);
    study_add(tallies, STUDY_M_S3_MINUS_THIRD, share(path, path->n_third));
    study_add(tallies, STUDY_M_S3_MINUS_END, path->last_m[0] < 0.0 && path->last_m[1] < 0.0);
    if (code == STUDY_GOOD) {
        code = run_path(set, STUDY_S3_PLUS, trial, 1);
    }
    study_add(tallies, STUDY_M_S3_PLUS_FIRST, share(path, path->n_first));
    study_add(tallies, STUDY_M_S3_PLUS_END, path->last_m[0] > 0.0 && path->last_m[1] > 0.0);
    study_add(tallies, STUDY_M_S3_RMS, rms_m(path));
    if (set->parts & 1U << STUDY_PART_S2) {
        study_add(tallies, STUDY_M_S3_LESS_S2, rms_m(path) - set->s2_m);
    }
    if (set->parts & 1U << STUDY_PART_S1) {
        study_add(tallies, STUDY_M_S3_LESS_S1, rms_m(path) - set->s1_m);
    }
    return code;
}

int study_trial_s4(study_set *set, uint32_t trial, study_tally *tallies)
{
    const study_path *path = &set->path;
    double before_m = 0.0;
    for (int run = 1; run <= 3; run++) {
        const int code = run_path(set, STUDY_S4, trial, run);
        if (code != STUDY_GOOD || exk_series_learn(&set->lab[STUDY_S4].series) != EXK_OK) {
            return code != STUDY_GOOD ? code : STUDY_MISS;
        }
        study_add(tallies, STUDY_M_S4_RMS_1 + run - 1, rms_m(path));
        if (run > 1) {
            study_add(tallies, STUDY_M_S4_FALL_2 + run - 2, before_m - rms_m(path));
        }
        before_m = rms_m(path);
    }
    study_add(tallies, STUDY_M_S4_GAP, last_m(path));
    study_add(tallies, STUDY_M_S4_DX_LESS_DY, fabs(path->last_m[0]) - fabs(path->last_m[1]));
    return STUDY_GOOD;
}
