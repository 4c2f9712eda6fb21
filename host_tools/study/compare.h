/** Controllers side by side on frozen and on fresh noise, each with its theoretical floor.
 *
 *  Setting   the rectangle of s5_ilc.ini, v = 0, one step of delay; noise white, first or second order.
 *  Errors    rms of the whole path and of the last point, radial, geometry in; of the last run of a
 *            learning series. Root of the mean square over the trials, so that it can be compared with
 *            a variance.
 *  Floor     what no causal controller goes below on noise that is new in every run: white: sigma; first
 *            order: one step's increment; second order: the predictor of level and rate, Riccati
 *            with exact observation of the level (control_limits, section 1). Frozen noise can be learned
 *            entirely: floor 0 for whatever learns.
 *  Theory    what this very law should give: the noise through the loop's own impulse response, times
 *            the learning's factor: fresh sqrt(1 + K/(2-K) (1 - (1-K)^2n)), frozen (1-K)^n, n updates.
 */
#ifndef STUDY_COMPARE_H
#define STUDY_COMPARE_H

#include "experiments.h"
#include "task.h"

enum { STUDY_N_NOISES = 3, STUDY_N_CONTROLLERS = 7, STUDY_COMPARE_UPDATES = 6 };

enum {
    STUDY_N_CELLS = STUDY_N_NOISES * 2 * STUDY_N_CONTROLLERS,
    STUDY_N_COMPARE = 3 * STUDY_N_CELLS /* path squared, last squared, last */
};

typedef struct {
    const char *name;
    const char *word; /* for people */
    int order;
    double sigma; /* [rad], [rad/s^0.5], [rad/s^1.5] */
} study_noise;

typedef struct {
    const char *name;
    const char *word;
    bool feedback;
    bool dead_beat;  /* ki dt = 1, kp = 0 in place of the study's PI */
    double ilc_gain; /* 0: does not learn */
} study_controller;

/** One cell of the table. */
typedef struct {
    int noise;
    bool frozen;
    int controller;
} study_cell;

typedef struct {
    char folder[STUDY_FOLDER_MAX];
    study_noise noises[STUDY_N_NOISES];
    double kp; /* of s6_pi.ini */
    double ki;
    study_measure measures[STUDY_N_COMPARE];
    study_task task;
} study_compare;

int study_compare_init(study_compare *compare, const char *folder);
const study_controller *study_controller_at(int i);
study_cell study_cell_at(int i);

/** Sets noise and controller of a cell in an opened rig. */
void study_cell_apply(const study_compare *compare, study_cell cell, exk_rig *rig);

/** Radial rms [m] over the path and at the last point. */
typedef struct {
    double path_m;
    double last_m;
} study_rms;

study_rms study_cell_floor(const study_compare *compare, study_cell cell, const exk_rig *rig);

/** cell applied to the rig. */
study_rms study_cell_theory(const study_compare *compare, study_cell cell, const exk_rig *rig);

#endif
