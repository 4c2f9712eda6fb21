#include "variant.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "task.h"

study_variant study_as_published(void)
{
    return (study_variant){.ilc_gain = NAN,
                           .dwell_s = NAN,
                           .feed_mps = NAN,
                           .walk_sigma = NAN,
                           .white_sigma = NAN,
                           .ki_per_s = NAN};
}

static void set_if_given(double *to, double value)
{
    if (!isnan(value)) {
        *to = value;
    }
}

/* The noise of S5 to S9 has one source each: accumulating, or white in S7 and S9. */
static void vary_noise(exk_profile *profile, study_experiment which,
                       const study_variant *variant)
{
    exk_disturbance_config *noise = &profile->twin.disturbance[0];
    if (which == STUDY_S9 && variant->s9_walk) {
        noise->order = 1;
    }
    set_if_given(&noise->amplitude,
                 noise->order == 1 ? variant->walk_sigma : variant->white_sigma);
}

/* The hole list is kept: neither dwell nor model moves a hole. */
static int open_again(exk_rig *rig, const char *name, const exk_profile *profile)
{
    const size_t length = exk_profile_print(profile, NULL, 0);
    char *text = malloc(length + 1);
    exk_hole *holes = rig->holes;
    const size_t n_holes = rig->n_holes;
    int code = STUDY_IO;
    rig->holes = NULL;
    exk_rig_close(rig);
    if (text != NULL) {
        exk_profile_print(profile, text, length + 1);
        code = exk_rig_open_text(rig, name, text, holes, n_holes);
    }
    free(text);
    free(holes);
    return code;
}

int study_vary(exk_rig *rig, study_experiment which, const study_variant *variant)
{
    exk_profile profile = rig->profile;
    if (which < STUDY_S5) {
        return STUDY_GOOD;
    }
    set_if_given(&profile.ilc.gain, variant->ilc_gain);
    set_if_given(&profile.job.plan.dwell_s, variant->dwell_s);
    set_if_given(&profile.job.plan.feed_mps, variant->feed_mps);
    if (which == STUDY_S6) {
        set_if_given(&profile.feedback.pid.ki, variant->ki_per_s);
    }
    vary_noise(&profile, which, variant);
    profile.model = variant->universal ? EXK_KIN_UNIVERSAL : profile.model;
    const bool new_plan = profile.job.plan.dwell_s != rig->profile.job.plan.dwell_s ||
                          profile.job.plan.feed_mps != rig->profile.job.plan.feed_mps ||
                          profile.model != rig->profile.model;
    if (new_plan) {
        return open_again(rig, study_experiment_at(which)->name, &profile);
    }
    rig->profile = profile;
    return STUDY_GOOD;
}
