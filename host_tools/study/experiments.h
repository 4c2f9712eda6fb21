/** The study's experiments: a profile each, and how many runs its learning series has.
 *
 *  Files    profiles/study/NAME.ini; each is an ordinary profile that exk-loop and exk-ilc run too.
 *  Set      the rigs of all experiments, opened once for each worker; a rig serves every trial.
 *  Errors   open: an exit code, faults of profiles on stderr as exk_rig_open prints them.
 *  Memory   a set is on the heap and must not be moved: loops point into their rigs.
 */
#ifndef STUDY_EXPERIMENTS_H
#define STUDY_EXPERIMENTS_H

#include "exk/series.h"

typedef enum {
    STUDY_S1_NONE,
    STUDY_S1_ALPHA,
    STUDY_S1_BETA,
    STUDY_S1_BOTH,
    STUDY_S2_ALPHA,
    STUDY_S2_BETA,
    STUDY_S2_BOTH,
    STUDY_S2_WHITE,
    STUDY_S3_MINUS,
    STUDY_S3_PLUS,
    STUDY_S4,
    STUDY_S5,
    STUDY_S6,
    STUDY_S7,
    STUDY_S8,
    STUDY_S9,
    STUDY_N_EXPERIMENTS
} study_experiment;

/* S1 to S9, each with its experiments. */
typedef enum {
    STUDY_PART_S1,
    STUDY_PART_S2,
    STUDY_PART_S3,
    STUDY_PART_S4,
    STUDY_PART_S5,
    STUDY_PART_S6,
    STUDY_PART_S7,
    STUDY_PART_S8,
    STUDY_PART_S9,
    STUDY_N_PARTS
} study_part;

enum { STUDY_ALL_PARTS = (1 << STUDY_N_PARTS) - 1 };

typedef struct {
    const char *name; /* of the profile, without .ini */
    int n_runs;       /* of its series; the last one is judged */
    study_part part;
} study_experiment_info;

/** A departure from the profiles, for calibration and sensitivity; NaN and false: as they say. */
typedef struct {
    double ilc_gain;
    double dwell_s;
    double feed_mps;
    double walk_sigma;  /* first-order intensity of S5, S6, S8 [rad/s^0.5] */
    double white_sigma; /* zero-order sigma of S7, S9 [rad] */
    double ki_per_s;    /* of S6 */
    bool universal;     /* model U in place of the profile's */
    bool s9_walk;       /* S9 with the first-order noise */
} study_variant;

study_variant study_as_published(void);

const study_experiment_info *study_experiment_at(study_experiment which);

enum { STUDY_FOLDER_MAX = 2048 };

/** Folder of the profiles: given, else profiles/study here, beside the program or where it is
 *  installed. False when none is there. */
bool study_find_profiles(const char *given, char folder[STUDY_FOLDER_MAX]);

int study_rig_open(exk_rig *rig, const char *folder, study_experiment which);

/** One series of an experiment on its rig: trial i, all its runs. */
typedef struct {
    study_experiment which;
    exk_rig *rig;
    exk_series series;
    double phase_rad; /* of the profile's sine */
} study_lab;

int study_lab_open(study_lab *lab, const char *folder, study_experiment which,
                   const study_variant *variant);
void study_lab_close(study_lab *lab);

/** Before trial i: nothing learned, and the sine of S1 at its phase. */
void study_lab_begin(study_lab *lab, uint32_t trial);

/** Run p = 1, 2, ... of a trial; the sample callback of lab->series sees each step. 0, or 1 after a
 *  message. */
int study_lab_run(study_lab *lab, uint32_t trial, int run, exk_accuracy *out);

/** All runs of a trial, learning between them; out is the last one's. */
int study_lab_trial(study_lab *lab, uint32_t trial, exk_accuracy *out);

#endif
