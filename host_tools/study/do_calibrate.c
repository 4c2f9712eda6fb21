/* The three fitted numbers, by a procedure anyone can repeat:
 *   1. First-order intensity: mean of S5 over the seeds; the error is proportional to the intensity but
 *      for the curvature of the sine, so one scaling fits it; a second run verifies.
 *   2. Zero-order sigma: the same with the mean of S9.
 *   3. Integral gain: bisection on log ki with the fitted intensity, every step on the same random
 *      numbers; the mean of S6 falls as ki rises over the bracket.
 * Values are rounded to four digits, so that the profiles can be read. */
#include <math.h>
#include <stdio.h>

#include "exk/units.h"
#include "fit.h"
#include "ini_edit.h"
#include "out_file.h"
#include "result.h"
#include "study_tool.h"

enum { SEEDS = 2000, BISECTIONS = 14, PATH_SIZE = STUDY_FOLDER_MAX + 64, NUMBER_SIZE = 32 };

static const double target_s5_m = 0.123e-3;
static const double target_s6_m = 0.071e-3;
static const double target_s9_m = 0.023614e-3;
static const double ki_low = 0.2;
static const double ki_high = 20.0;

/* Bracket [ki_low, ki_high]; the error is larger at the lower end. */
static int fit_ki(study_paper *paper, const study_work *work, double *mean_m)
{
    double low = log(ki_low);
    double high = log(ki_high);
    int code = STUDY_GOOD;
    for (int i = 0; i < BISECTIONS && code == STUDY_GOOD; i++) {
        const double middle = 0.5 * (low + high);
        paper->variant.ki_per_s = exp(middle);
        code = study_mean_of(paper, work, STUDY_PART_S6, STUDY_M_S6_LAST, mean_m);
        if (*mean_m > target_s6_m) {
            low = middle;
        } else {
            high = middle;
        }
    }
    paper->variant.ki_per_s = study_round4(exp(0.5 * (low + high)));
    if (code == STUDY_GOOD) {
        code = study_mean_of(paper, work, STUDY_PART_S6, STUDY_M_S6_LAST, mean_m);
    }
    return code;
}

static void tell(const char *name, double value, const char *unit, const char *to,
                 double mean_m, double target_m)
{
    printf("%-22s %-10.4g %-11s %-8s %.6f mm, published %.6f mm\n", name, value, unit, to,
           EXK_MM_PER_M * mean_m, EXK_MM_PER_M * target_m);
    fflush(stdout);
}

static int fit_all(study_paper *paper, const study_work *work)
{
    const study_fit walk = {STUDY_PART_S5, STUDY_M_S5_LAST_3, target_s5_m,
                            paper->profiles[STUDY_S5].twin.disturbance[0].amplitude,
                            &paper->variant.walk_sigma};
    const study_fit white = {STUDY_PART_S9, STUDY_M_S9_MEAN, target_s9_m,
                             paper->profiles[STUDY_S9].twin.disturbance[0].amplitude,
                             &paper->variant.white_sigma};
    double mean_m = 0.0;
    int code = study_fit_scale(paper, work, &walk, &mean_m);
    if (code == STUDY_GOOD) {
        tell("first-order intensity", *walk.sigma, "rad/s^0.5", "S5", mean_m, target_s5_m);
        code = study_fit_scale(paper, work, &white, &mean_m);
    }
    if (code == STUDY_GOOD) {
        tell("zero-order sigma", *white.sigma, "rad", "S9_mean", mean_m, target_s9_m);
        code = fit_ki(paper, work, &mean_m);
    }
    if (code == STUDY_GOOD) {
        tell("integral gain", paper->variant.ki_per_s, "1/s", "S6", mean_m, target_s6_m);
    }
    return code;
}

static int write_values(const study_paper *paper)
{
    const study_variant *v = &paper->variant;
    const struct {
        study_experiment which;
        const char *section;
        const char *key;
        double value;
    } edits[] = {{STUDY_S5, "disturbance.1", "sigma_rad_per_sqrt_s", v->walk_sigma},
                 {STUDY_S6, "disturbance.1", "sigma_rad_per_sqrt_s", v->walk_sigma},
                 {STUDY_S8, "disturbance.1", "sigma_rad_per_sqrt_s", v->walk_sigma},
                 {STUDY_S7, "disturbance.1", "sigma_rad", v->white_sigma},
                 {STUDY_S9, "disturbance.1", "sigma_rad", v->white_sigma},
                 {STUDY_S6, "control", "ki_per_s", v->ki_per_s}};
    int code = STUDY_GOOD;
    for (size_t i = 0; i < sizeof edits / sizeof edits[0] && code == STUDY_GOOD; i++) {
        char path[PATH_SIZE];
        char number[NUMBER_SIZE];
        snprintf(path, sizeof path, "%s/%s.ini", paper->folder,
                 study_experiment_at(edits[i].which)->name);
        snprintf(number, sizeof number, "%.4g", edits[i].value);
        code = study_ini_set(path, edits[i].section, edits[i].key, number);
    }
    return code;
}

static int calibrate(const study_options *options, study_paper *paper)
{
    const uint64_t n = options->n_seeds > 0 ? options->n_seeds : SEEDS;
    const study_work work = {.n_trials = n, .n_threads = options->n_threads};
    int code = fit_all(paper, &work);
    if (code == STUDY_GOOD && options->write) {
        code = write_values(paper);
        if (code == STUDY_GOOD) {
            printf("written into the profiles of %s\n", paper->folder);
        }
    }
    return code != STUDY_GOOD ? code : exk_stdout_flush("exk-study");
}

int study_do_calibrate(const study_options *options)
{
    return study_with_paper(options, STUDY_ALL_PARTS, calibrate);
}
