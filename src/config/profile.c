#include "exk/profile.h"

#include <math.h>
#include <stdio.h>

#include "check.h"
#include "read.h"

/* The plane of the study: the plate itself, or the tip of a tool that hangs straight down. */
double exk_profile_plane_z(const exk_profile *profile)
{
    const exk_geometry *geo = &profile->geometry;
    const double tool_m = profile->model == EXK_KIN_MACHINE ? geo->e_m + geo->t_m : 0.0;
    return geo->z0_m + tool_m;
}

static exk_job_config default_job(void)
{
    return (exk_job_config){
        .kind = EXK_JOB_RECTANGLE,
        .pattern = {.width_m = 0.3, .height_m = 0.2, .rows = 5, .columns = 5},
        .order = EXK_ORDER_LISTED,
        .row_gap_m = 0.005,
        .tolerance_m = 3e-5, /* the study's circle */
        .plan = exk_plan_default(),
    };
}

static exk_timing_config default_timing(void)
{
    return (exk_timing_config){
        .rate_Hz = 1000.0,
        .dt_s = 1.0 / 1000.0,
        .seed = 1,
        .from = EXK_FROM_TWIN,
        .answer_s = 2.0,
        .n_missed_max = 20,
        .n_bad_max = 20,
        .priority = 80,
        .cpu = -1,
    };
}

/* Wide enough for every experiment of the study, narrow enough for a jump by a hole's distance. */
static exk_limits_keys default_limits(void)
{
    const double far_m = EXK_LENGTH_MAX_M;
    return (exk_limits_keys){
        .following_rad = (double)INFINITY,
        .following_time_s = 0.05,
        .correction_rad = 0.2,
        .rate_radps = 10.0,
        .leg_speed_mps = 10.0,
        .box_min_m = {-far_m, -far_m, -far_m},
        .box_max_m = {far_m, far_m, far_m},
    };
}

exk_profile exk_profile_default(void)
{
    exk_profile profile = {
        .geometry = exk_geometry_default(),
        .wrist = EXK_WRIST_AB,
        .model = EXK_KIN_PENDULUM,
        .job = default_job(),
        .twin = exk_twin_default(),
        .feedback = exk_feedback_default(),
        .ilc = exk_ilc_default(),
        .timing = default_timing(),
        .guard = {.n_sigmas = 5.5, .stuck_s = 0.015, .retract_after_s = 0.1},
        .limits = default_limits(),
        .telemetry = {.url = "udpm://239.255.76.67:7667?ttl=0",
                      .every = 1,
                      .ring_slots = 8192,
                      .status_Hz = 10.0},
        .command = {.timeout_s = 1.0, .fresh_s = 0.5},
    };
    for (int i = 0; i < EXK_MAX_INJECTED; i++) {
        profile.inject.fault[i] = exk_inject_default();
    }
    for (int i = 0; i < EXK_MAX_DISTURBANCES; i++) {
        profile.twin.disturbance[i] = exk_disturbance_default();
    }
    profile.job.pattern.center_m[EXK_Z] = exk_profile_plane_z(&profile);
    return profile;
}

exk_err exk_profile_parse(const char *text, exk_profile *profile, exk_fault *faults,
                          size_t capacity, size_t *n_faults)
{
    exk_profile_reader reading = {
        .profile = exk_profile_default(),
        .faults = {faults, capacity, 0},
    };
    exk_read_profile(&reading, text);
    exk_check_profile(&reading);
    *n_faults = reading.faults.n;
    if (reading.faults.n > 0) {
        return EXK_ERR_ARG;
    }
    *profile = reading.profile;
    return EXK_OK;
}
