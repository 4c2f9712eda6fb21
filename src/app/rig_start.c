#include <math.h>
#include <stdlib.h>

#include "exk/rig.h"

/* sigma_rad of the profile names the spread of the innovation. Half walk, half white, both of this
 * share of it, give an innovation of just that spread (guard.h: P + R with Q = R). */
static const double share_of_sigma = 0.6180339887498949;

/* A machine on the bus has its own faults; the profile's are put into twin and log. */
static exk_source source_of(exk_rig *rig)
{
    if (rig->from == EXK_FROM_BUS) {
        return rig->bus;
    }
    if (rig->from == EXK_FROM_REPLAY) {
        exk_replay_rewind(&rig->replay);
        return exk_inject_source(&rig->inject, exk_replay_source(&rig->replay));
    }
    return exk_inject_source(&rig->inject, exk_twin_source(&rig->twin));
}

/* What was recorded answered another command: only its own spread, given by hand, can judge it. */
static exk_guard_config guard_of(const exk_rig *rig)
{
    const exk_guard_keys *keys = &rig->profile.guard;
    const bool replays = rig->from == EXK_FROM_REPLAY;
    const double duration_s = (double)rig->plan.n_ticks * rig->plan.cfg.dt_s;
    exk_guard_config guard = exk_guard_default();
    exk_guard_expect(&rig->profile.twin, duration_s, &guard);
    guard.n_sigmas = keys->n_sigmas;
    guard.stuck_s = keys->stuck_s;
    guard.start_rad = keys->start_rad > 0.0 ? keys->start_rad : guard.start_rad;
    if (keys->sigma_rad > 0.0) {
        guard.white_rad = share_of_sigma * keys->sigma_rad;
        guard.walk_rad = share_of_sigma * keys->sigma_rad;
        guard.drift_rad = 0.0;
    } else if (replays) {
        guard.n_sigmas = (double)INFINITY;
    }
    return guard;
}

static exk_limits_config limits_of(const exk_rig *rig)
{
    const exk_limits_keys *keys = &rig->profile.limits;
    const exk_geometry *geo = &rig->profile.geometry;
    exk_limits_config limits = exk_limits_default();
    limits.angle_max_rad = geo->angle_max_rad;
    limits.correction_max_rad = keys->correction_rad;
    limits.rate_max_radps = keys->rate_radps;
    limits.leg_speed_max_mps = keys->leg_speed_mps;
    limits.following_rad = keys->following_rad;
    limits.following_time_s = keys->following_time_s;
    if (rig->profile.model == EXK_KIN_MACHINE) {
        limits.leg_min_m = geo->l_min_m + keys->leg_margin_m;
        limits.leg_max_m = geo->l_min_m + geo->d5_m - keys->leg_margin_m;
    }
    for (int i = 0; i < 3; i++) {
        limits.box_min_m[i] = keys->box_min_m[i];
        limits.box_max_m[i] = keys->box_max_m[i];
    }
    return limits;
}

static exk_loop_config config_of(exk_rig *rig)
{
    const exk_profile *profile = &rig->profile;
    return (exk_loop_config){.kin = &rig->kin,
                             .plan = &rig->plan,
                             .source = source_of(rig),
                             .feedback = profile->feedback,
                             .angle_max_rad = profile->geometry.angle_max_rad,
                             .n_bad_max = profile->timing.n_bad_max,
                             .guard = guard_of(rig),
                             .limits = limits_of(rig),
                             .wait_s = profile->guard.retract_after_s,
                             .capture = rig->captured == NULL ? NULL : &rig->capture};
}

static exk_err start_twin(exk_rig *rig, exk_realisation which)
{
    const exk_profile *profile = &rig->profile;
    const exk_err err = exk_twin_init(&rig->twin, &profile->twin, which);
    return err != EXK_OK
               ? err
               : exk_inject_init(&rig->inject, &profile->inject, profile->timing.dt_s, which);
}

exk_err exk_rig_start_machine(exk_rig *rig, exk_realisation which, exk_source *out)
{
    const exk_err err = start_twin(rig, which);
    if (err == EXK_OK) {
        *out = exk_inject_source(&rig->inject, exk_twin_source(&rig->twin));
    }
    return err;
}

exk_err exk_rig_start(exk_rig *rig, exk_realisation which,
                      const double *const u_rad[EXK_N_AXES], size_t n_u)
{
    const exk_err err = start_twin(rig, which);
    if (err != EXK_OK) {
        return err;
    }
    exk_loop_config cfg = config_of(rig);
    for (int i = 0; i < EXK_N_AXES && u_rad != NULL; i++) {
        cfg.u_rad[i] = u_rad[i];
    }
    cfg.n_u = u_rad == NULL ? 0 : n_u;
    return exk_loop_init(&rig->loop, &cfg);
}

bool exk_rig_capture(exk_rig *rig, double duration_s)
{
    const double n = ceil(duration_s / rig->profile.timing.dt_s);
    const size_t n_slots = n > 1.0 ? (size_t)n : 1;
    free(rig->captured);
    rig->captured = calloc(n_slots, sizeof *rig->captured);
    return rig->captured != NULL &&
           exk_capture_init(&rig->capture, rig->captured, n_slots) == EXK_OK;
}
