#define _POSIX_C_SOURCE 200809L
#include "experiments.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "exk/units.h"
#include "task.h"
#include "variant.h"

static const study_experiment_info table[STUDY_N_EXPERIMENTS] = {
    [STUDY_S1_NONE] = {"s1_none", 1, STUDY_PART_S1},
    [STUDY_S1_ALPHA] = {"s1_alpha", 1, STUDY_PART_S1},
    [STUDY_S1_BETA] = {"s1_beta", 1, STUDY_PART_S1},
    [STUDY_S1_BOTH] = {"s1_both", 1, STUDY_PART_S1},
    [STUDY_S2_ALPHA] = {"s2_alpha", 1, STUDY_PART_S2},
    [STUDY_S2_BETA] = {"s2_beta", 1, STUDY_PART_S2},
    [STUDY_S2_BOTH] = {"s2_both", 1, STUDY_PART_S2},
    [STUDY_S2_WHITE] = {"s2_white", 1, STUDY_PART_S2},
    [STUDY_S3_MINUS] = {"s3_minus", 1, STUDY_PART_S3},
    [STUDY_S3_PLUS] = {"s3_plus", 1, STUDY_PART_S3},
    [STUDY_S4] = {"s4_ilc", 3, STUDY_PART_S4},
    [STUDY_S5] = {"s5_ilc", 3, STUDY_PART_S5},
    [STUDY_S6] = {"s6_pi", 1, STUDY_PART_S6},
    [STUDY_S7] = {"s7_grid25_white", 5, STUDY_PART_S7},
    [STUDY_S8] = {"s8_grid25_walk", 5, STUDY_PART_S8},
    [STUDY_S9] = {"s9_grid45_white", 5, STUDY_PART_S9},
};

/* Successive multiples of it fill the circle evenly, however many are taken. */
static const double golden_ratio = 0.61803398874989484820;

const study_experiment_info *study_experiment_at(study_experiment which)
{
    return &table[which];
}

static bool holds_profiles(const char *folder)
{
    char path[STUDY_FOLDER_MAX + 64];
    snprintf(path, sizeof path, "%s/%s.ini", folder, table[STUDY_S1_NONE].name);
    return access(path, R_OK) == 0;
}

/* Beside the program: BUILD/bin of a source tree, or PREFIX/bin of an installed one. */
static bool find_beside_program(char folder[STUDY_FOLDER_MAX])
{
    static const char *const places[] = {"../share/exk/profiles/study",
                                         "../../../profiles/study"};
    char program[STUDY_FOLDER_MAX / 2];
    const ssize_t n = readlink("/proc/self/exe", program, sizeof program - 1);
    program[n > 0 ? n : 0] = '\0';
    char *slash = strrchr(program, '/');
    if (slash == NULL) {
        return false;
    }
    *slash = '\0';
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        snprintf(folder, STUDY_FOLDER_MAX, "%s/%s", program, places[i]);
        if (holds_profiles(folder)) {
            return true;
        }
    }
    return false;
}

bool study_find_profiles(const char *given, char folder[STUDY_FOLDER_MAX])
{
    snprintf(folder, STUDY_FOLDER_MAX, "%s", given != NULL ? given : "profiles/study");
    if (holds_profiles(folder)) {
        return true;
    }
    if (given == NULL && find_beside_program(folder)) {
        return true;
    }
    fprintf(stderr,
            "exk-study: the study's profiles (%s.ini and the others) are not in %s; name their "
            "folder with --profiles\n",
            table[STUDY_S1_NONE].name, given != NULL ? given : "profiles/study");
    return false;
}

int study_rig_open(exk_rig *rig, const char *folder, study_experiment which)
{
    char path[STUDY_FOLDER_MAX + 64];
    snprintf(path, sizeof path, "%s/%s.ini", folder, table[which].name);
    return exk_rig_open(rig, path);
}

int study_lab_open(study_lab *lab, const char *folder, study_experiment which,
                   const study_variant *variant)
{
    *lab = (study_lab){.which = which, .rig = calloc(1, sizeof *lab->rig)};
    int code = lab->rig == NULL ? STUDY_IO : study_rig_open(lab->rig, folder, which);
    if (code == STUDY_GOOD) {
        code = study_vary(lab->rig, which, variant);
    }
    if (code == STUDY_GOOD && !exk_series_open(&lab->series, lab->rig)) {
        fprintf(stderr, "exk-study: out of memory\n");
        exk_rig_close(lab->rig);
        code = STUDY_IO;
    }
    if (code != STUDY_GOOD) {
        free(lab->rig);
        lab->rig = NULL;
        return code;
    }
    lab->phase_rad = lab->rig->profile.twin.disturbance[0].phase_rad;
    return STUDY_GOOD;
}

void study_lab_close(study_lab *lab)
{
    if (lab->rig != NULL) {
        exk_series_close(&lab->series);
        exk_rig_close(lab->rig);
        free(lab->rig);
    }
    lab->rig = NULL;
}

void study_lab_begin(study_lab *lab, uint32_t trial)
{
    const double turn = golden_ratio * trial;
    lab->rig->profile.twin.disturbance[0].phase_rad =
        lab->phase_rad + 2.0 * EXK_PI * (turn - floor(turn));
    exk_series_reset(&lab->series);
}

static int say_failed(const study_lab *lab, uint32_t trial, int run, exk_err err)
{
    fprintf(stderr,
            "exk-study: %s: run %d of trial %" PRIu32 " failed at tick %" PRId64 ": %s\n",
            table[lab->which].name, run, trial, lab->rig->loop.last.k, exk_err_name(err));
    return STUDY_MISS;
}

int study_lab_run(study_lab *lab, uint32_t trial, int run, exk_accuracy *out)
{
    const exk_realisation which = {
        .seed = lab->rig->profile.timing.seed, .series = trial, .run = (uint32_t)run};
    const exk_err err = exk_series_run(&lab->series, which, out);
    return err == EXK_OK ? STUDY_GOOD : say_failed(lab, trial, run, err);
}

int study_lab_trial(study_lab *lab, uint32_t trial, exk_accuracy *out)
{
    const int n_runs = table[lab->which].n_runs;
    study_lab_begin(lab, trial);
    for (int run = 1; run <= n_runs; run++) {
        const int code = study_lab_run(lab, trial, run, out);
        if (code != STUDY_GOOD) {
            return code;
        }
        const exk_err err = run < n_runs ? exk_series_learn(&lab->series) : EXK_OK;
        if (err != EXK_OK) {
            return say_failed(lab, trial, run, err);
        }
    }
    return STUDY_GOOD;
}
