#define _POSIX_C_SOURCE 200809L
#include "paper.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "noise_word.h"
#include "trial.h"

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

int study_paper_init(study_paper *paper, const char *folder, uint32_t parts)
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
    paper->variant = study_as_published();
    paper->parts = parts;
    name_measures(paper->measures);
    fprintf(all, "parts %#x\n", (unsigned)parts);
    const int code = read_profiles(paper, all);
    fclose(all);
    paper->noise = noise_of(paper->profiles);
    paper->task = (study_task){.name = "exk-study paper",
                               .measures = paper->measures,
                               .n_measures = STUDY_N_PAPER,
                               .hash = study_hash(paper->measures, STUDY_N_PAPER, text),
                               .setup = paper,
                               .open = study_trial_open,
                               .close = study_trial_close,
                               .run = study_trial_run};
    free(text);
    return code;
}
