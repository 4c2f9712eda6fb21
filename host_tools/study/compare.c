#define _POSIX_C_SOURCE 200809L
#include "compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { STUDY_N_SOURCES = 3 }; /* profiles that sigma and gains are read from */

static const study_controller controllers[STUDY_N_CONTROLLERS] = {
    {"none", "no control", false, false, 0.0},
    {"pi", "PI of the study", true, false, 0.0},
    {"dead_beat", "integral, ki dt = 1", true, true, 0.0},
    {"ilc", "ILC, K = 0.5", false, false, 0.5},
    {"ilc_k1", "ILC, K = 1", false, false, 1.0},
    {"pi_ilc", "PI + ILC, K = 0.5", true, false, 0.5},
    {"dead_beat_ilc", "dead-beat + ILC, K = 0.5", true, true, 0.5},
};

/* Ratios do not depend on it; of the size that bends the path as much as the others. */
static const double second_order_sigma = 1e-5;

const study_controller *study_controller_at(int i)
{
    return &controllers[i];
}

study_cell study_cell_at(int i)
{
    return (study_cell){.noise = i / (2 * STUDY_N_CONTROLLERS),
                        .frozen = i / STUDY_N_CONTROLLERS % 2 == 0,
                        .controller = i % STUDY_N_CONTROLLERS};
}

void study_cell_apply(const study_compare *compare, study_cell cell, exk_rig *rig)
{
    const study_controller *controller = &controllers[cell.controller];
    exk_profile *profile = &rig->profile;
    exk_disturbance_config *noise = &profile->twin.disturbance[0];
    noise->order = compare->noises[cell.noise].order;
    noise->amplitude = compare->noises[cell.noise].sigma;
    noise->frozen = cell.frozen;
    profile->feedback.kind = controller->feedback ? EXK_FEEDBACK_PID : EXK_FEEDBACK_NONE;
    profile->feedback.pid.kp = controller->dead_beat ? 0.0 : compare->kp;
    profile->feedback.pid.ki = controller->dead_beat ? 1.0 / profile->timing.dt_s : compare->ki;
    if (controller->ilc_gain > 0.0) {
        profile->ilc.gain = controller->ilc_gain;
    }
}

static int run_cell(const study_compare *compare, int i, study_lab *lab, uint32_t trial,
                    study_tally *tallies)
{
    const study_cell cell = study_cell_at(i);
    const bool learns = controllers[cell.controller].ilc_gain > 0.0;
    const int n_runs = learns ? STUDY_COMPARE_UPDATES + 1 : 1;
    exk_accuracy a = {.n_drilled = 0};
    int code = STUDY_GOOD;
    study_cell_apply(compare, cell, lab->rig);
    study_lab_begin(lab, trial);
    for (int run = 1; run <= n_runs && code == STUDY_GOOD; run++) {
        code = study_lab_run(lab, trial, run, &a);
        if (code == STUDY_GOOD && run < n_runs && exk_series_learn(&lab->series) != EXK_OK) {
            code = STUDY_MISS;
        }
    }
    study_tally_add(&tallies[3 * i], a.rms_path_m * a.rms_path_m);
    study_tally_add(&tallies[3 * i + 1], a.last_point_m * a.last_point_m);
    study_tally_add(&tallies[3 * i + 2], a.last_point_m);
    return code;
}

typedef struct {
    const study_compare *compare;
    study_lab lab;
} compare_worker;

static int run_trial(void *worker, uint32_t trial, study_tally *tallies)
{
    compare_worker *w = worker;
    int code = STUDY_GOOD;
    for (int i = 0; i < STUDY_N_CELLS && code == STUDY_GOOD; i++) {
        code = run_cell(w->compare, i, &w->lab, trial, tallies);
    }
    return code;
}

static void close_worker(void *worker)
{
    compare_worker *w = worker;
    study_lab_close(&w->lab);
    free(w);
}

static int open_worker(const void *setup, void **worker)
{
    const study_variant as_published = study_as_published();
    compare_worker *w = calloc(1, sizeof *w);
    if (w == NULL) {
        return STUDY_IO;
    }
    w->compare = setup;
    const int code = study_lab_open(&w->lab, w->compare->folder, STUDY_S5, &as_published);
    if (code != STUDY_GOOD) {
        free(w);
        return code;
    }
    *worker = w;
    return STUDY_GOOD;
}

static void name_measures(study_compare *compare)
{
    static const char *const what[] = {"path2", "last2", "last"};
    for (int i = 0; i < STUDY_N_COMPARE; i++) {
        study_measure *measure = &compare->measures[i];
        *measure = (study_measure){.unit = i % 3 == 2 ? "m" : "m2", .kind = STUDY_SIGNED};
        snprintf(measure->key, STUDY_KEY_MAX, "cell%02d_%s", i / 3, what[i % 3]);
    }
}

/* What a source of numbers says, and its text for the hash. */
static int read_source(study_compare *compare, int i, FILE *all)
{
    static const study_experiment sources[STUDY_N_SOURCES] = {STUDY_S9, STUDY_S5, STUDY_S6};
    char text[8192];
    exk_rig rig;
    const int code = study_rig_open(&rig, compare->folder, sources[i]);
    if (code != STUDY_GOOD) {
        return code;
    }
    if (sources[i] == STUDY_S6) {
        compare->kp = rig.profile.feedback.pid.kp;
        compare->ki = rig.profile.feedback.pid.ki;
    } else {
        compare->noises[i].sigma = rig.profile.twin.disturbance[0].amplitude;
    }
    exk_profile_print(&rig.profile, text, sizeof text);
    fputs(text, all);
    exk_rig_close(&rig);
    return STUDY_GOOD;
}

static int read_numbers(study_compare *compare)
{
    char *text = NULL;
    size_t size = 0;
    FILE *all = open_memstream(&text, &size);
    int code = all == NULL ? STUDY_IO : STUDY_GOOD;
    for (int i = 0; i < STUDY_N_SOURCES && code == STUDY_GOOD; i++) {
        code = read_source(compare, i, all);
    }
    if (all != NULL && fclose(all) == 0) {
        compare->task.hash = study_hash(compare->measures, STUDY_N_COMPARE, text);
    }
    free(text);
    return code;
}

int study_compare_init(study_compare *compare, const char *folder)
{
    *compare =
        (study_compare){.noises = {{"white", "white (zero order)", 0, 0.0},
                                   {"first_order", "random walk (first order)", 1, 0.0},
                                   {"second_order", "second order", 2, second_order_sigma}}};
    if (!study_find_profiles(folder, compare->folder)) {
        return STUDY_INPUT;
    }
    name_measures(compare);
    compare->task = (study_task){.name = "exk-study compare",
                                 .measures = compare->measures,
                                 .n_measures = STUDY_N_COMPARE,
                                 .setup = compare,
                                 .open = open_worker,
                                 .close = close_worker,
                                 .run = run_trial};
    return read_numbers(compare);
}
