/** The published study as a task: each trial runs S1 to S9 once and measures what the study prints.
 *
 *  Lengths  metres, radial in the plane normal to the hole axis, on the true tip.
 *  Groups   S5 and S6 are also taken as means of 10 consecutive trials, as the study did; blocks are
 *           whole groups.
 *  Start    S7 and S8 leave the first hole out ("without the start point"): 24 holes.
 *  Places   edge: on the rim of the grid; turn: next to a change of row. The first hole counts in
 *           neither.
 */
#ifndef STUDY_PAPER_H
#define STUDY_PAPER_H

#include "experiments.h"
#include "task.h"

enum { STUDY_GRID25 = 25, STUDY_GRID45 = 45 };

typedef enum {
    STUDY_M_S1_NONE_RMS, /* rms distance from the reference, sample by sample */
    STUDY_M_S1_ALPHA_RMS,
    STUDY_M_S1_BETA_RMS,
    STUDY_M_S1_BOTH_RMS,
    STUDY_M_S1_ALPHA_LESS_BETA,
    STUDY_M_S1_BOTH_LESS_ALPHA,
    STUDY_M_S2_ALPHA_RMS,
    STUDY_M_S2_BETA_RMS,
    STUDY_M_S2_BOTH_RMS,
    STUDY_M_S2_ALPHA_LESS_BETA,
    STUDY_M_S2_GROWTH, /* rms of the second half less that of the first */
    STUDY_M_S2_WHITE_RMS,
    STUDY_M_S2_WHITE_GROWTH,
    STUDY_M_S3_MINUS_THIRD, /* share of the samples in the third quadrant */
    STUDY_M_S3_PLUS_FIRST,
    STUDY_M_S3_MINUS_END, /* 1 when the last sample is there */
    STUDY_M_S3_PLUS_END,
    STUDY_M_S3_RMS,
    STUDY_M_S3_LESS_S2,
    STUDY_M_S3_LESS_S1,
    STUDY_M_S4_RMS_1,
    STUDY_M_S4_RMS_2,
    STUDY_M_S4_RMS_3,
    STUDY_M_S4_FALL_2, /* rms of run 1 less that of run 2 */
    STUDY_M_S4_FALL_3,
    STUDY_M_S4_GAP,        /* last point from its reference, run 3 */
    STUDY_M_S4_DX_LESS_DY, /* |dx| - |dy| there */
    STUDY_M_S5_LAST_1,
    STUDY_M_S5_LAST_2,
    STUDY_M_S5_LAST_3,
    STUDY_M_S5_MEAN10,
    STUDY_M_S6_LAST,
    STUDY_M_S6_MEAN10,
    STUDY_M_S7_MIN,
    STUDY_M_S7_MAX,
    STUDY_M_S7_MEAN,
    STUDY_M_S7_EDGE, /* mean of the edge less that of the inner holes */
    STUDY_M_S7_TURN, /* mean of the turning points less that of the others */
    STUDY_M_S8_MIN,
    STUDY_M_S8_MAX,
    STUDY_M_S8_MEAN,
    STUDY_M_S8_EDGE,
    STUDY_M_S8_TURN,
    STUDY_M_S8_LESS_S7, /* of the means */
    STUDY_M_S9_INSIDE,
    STUDY_M_S9_MEAN,
    STUDY_M_S9_HOLE,  /* every hole of every trial */
    STUDY_M_S9_HOLE2, /* its square, for the Rician fit */
    STUDY_M_S7_HOLES,
    STUDY_M_S8_HOLES = STUDY_M_S7_HOLES + STUDY_GRID25,
    STUDY_N_PAPER = STUDY_M_S8_HOLES + STUDY_GRID25
} study_paper_measure;

/** Profiles folder, measures and hash; what the task's workers are opened with. */
typedef struct {
    char folder[STUDY_FOLDER_MAX];
    study_measure measures[STUDY_N_PAPER];
    exk_profile profiles[STUDY_N_EXPERIMENTS];
    study_variant variant;
    bool by_steps;     /* every run step by step, none brief: to show that nothing changes */
    uint32_t parts;    /* bits of study_part that are run; measures of the others stay empty */
    const char *noise; /* frozen, fresh or mixed, over all experiments */
    study_task task;
} study_paper;

/** Reads the profiles once; an exit code. parts: STUDY_ALL_PARTS or some of them. paper must outlive
 *  its task and not be moved. */
int study_paper_init(study_paper *paper, const char *folder, uint32_t parts);

#endif
