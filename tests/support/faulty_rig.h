/** A four-hole job on the machine model, small enough that every tick of it can be spoilt: plan, twin with
 *  sensor noise and quantum, PI feedback, guard and limits as a profile gives them.
 */
#ifndef EXK_TEST_FAULTY_RIG_H
#define EXK_TEST_FAULTY_RIG_H

#include <math.h>

#include "exk/inject.h"
#include "exk/loop.h"
#include "unity.h"

enum { FAULTY_HOLES_MAX = 32, FAULTY_SEGMENTS = 5 * FAULTY_HOLES_MAX + 1 };

typedef struct {
    exk_hole holes[FAULTY_HOLES_MAX];
    exk_segment segments[FAULTY_SEGMENTS];
    exk_kin kin;
    exk_plan plan;
    exk_twin_config twin_cfg;
    exk_twin twin;
    exk_inject inject;
    exk_loop_config cfg;
    exk_loop loop;
} faulty_rig;

static inline void faulty_set_loop(faulty_rig *rig)
{
    const exk_geometry geo = exk_geometry_default();
    rig->cfg = (exk_loop_config){.kin = &rig->kin,
                                 .plan = &rig->plan,
                                 .feedback = exk_feedback_default(),
                                 .angle_max_rad = geo.angle_max_rad,
                                 .n_bad_max = 20,
                                 .guard = exk_guard_default(),
                                 .limits = exk_limits_default(),
                                 .wait_s = 0.02};
    rig->cfg.feedback.kind = EXK_FEEDBACK_PID;
    rig->cfg.feedback.pid.kp = 0.05;
    rig->cfg.feedback.pid.ki = 100.0;
    rig->cfg.guard.n_sigmas = 5.5;
    exk_guard_expect(&rig->twin_cfg, (double)rig->plan.n_ticks * rig->plan.cfg.dt_s,
                     &rig->cfg.guard);
    rig->cfg.limits.angle_max_rad = geo.angle_max_rad;
    rig->cfg.limits.correction_max_rad = 0.005;
    rig->cfg.limits.rate_max_radps = 0.5;
    rig->cfg.limits.leg_speed_max_mps = 0.3;
    rig->cfg.limits.leg_min_m = geo.l_min_m;
    rig->cfg.limits.leg_max_m = geo.l_min_m + geo.d5_m;
    rig->cfg.limits.following_rad = 0.01;
    rig->cfg.limits.following_time_s = 0.05;
}

/** rows x columns holes, pitch_m apart, each dwelt on for dwell_s. */
static inline void faulty_set_up(faulty_rig *rig, int rows, int columns, double pitch_m,
                                 double dwell_s)
{
    const exk_geometry geo = exk_geometry_default();
    exk_plan_config plan = exk_plan_default();
    const double z_m = geo.z0_m + geo.e_m + geo.t_m;
    size_t n = 0;
    for (int i = 0; i < rows; i++) {
        for (int j = 0; j < columns; j++) {
            rig->holes[n] = (exk_hole){.id = (int32_t)n + 1,
                                       .target_m = {pitch_m * (j - 0.5 * (columns - 1)),
                                                    pitch_m * (i - 0.5 * (rows - 1)), z_m},
                                       .axis = {0.0, 0.0, 1.0}};
            n++;
        }
    }
    plan.dwell_s = dwell_s;
    plan.accel_mps2 = 5.0;
    plan.clearance_m = 0.0005;
    plan.stroke_m = 0.0005;
    plan.drill_mps = 0.05;
    plan.approach_mps = 0.05;
    plan.closed = false;
    TEST_ASSERT_EQUAL(EXK_OK, exk_kin_init(&rig->kin, EXK_KIN_MACHINE, EXK_WRIST_AB, &geo));
    TEST_ASSERT_EQUAL(EXK_OK, exk_plan_init(&rig->plan, &plan, rig->holes, n, rig->segments,
                                            FAULTY_SEGMENTS));
    rig->twin_cfg = exk_twin_default();
    rig->twin_cfg.sensor_sigma_rad = 2e-6;
    rig->twin_cfg.sensor_quantum_rad = 2.5e-7;
    rig->twin_cfg.servo_tau_s = 0.002;
    rig->twin_cfg.n_disturbances = 1;
    rig->twin_cfg.disturbance[0] = exk_disturbance_default();
    rig->twin_cfg.disturbance[0].wave = EXK_WAVE_GAUSSIAN;
    rig->twin_cfg.disturbance[0].order = 1;
    rig->twin_cfg.disturbance[0].amplitude = 1.16e-4;
    faulty_set_loop(rig);
}

/** One run: the same noise for the same seed, with the faults given in it. */
static inline void faulty_start(faulty_rig *rig, uint64_t seed, const exk_inject_config *faults)
{
    const exk_realisation which = {.seed = seed, .run = 1};
    TEST_ASSERT_EQUAL(EXK_OK, exk_twin_init(&rig->twin, &rig->twin_cfg, which));
    TEST_ASSERT_EQUAL(EXK_OK, exk_inject_init(&rig->inject, faults, rig->plan.cfg.dt_s, which));
    rig->cfg.source = exk_inject_source(&rig->inject, exk_twin_source(&rig->twin));
    TEST_ASSERT_EQUAL(EXK_OK, exk_loop_init(&rig->loop, &rig->cfg));
}

static inline bool faulty_is_finite(const exk_sample *s)
{
    double sum = s->h_m;
    for (int i = 0; i < 3; i++) {
        sum +=
            s->ref.tip_m[i] + s->ref.axis[i] + s->est.tip_m[i] + s->est.axis[i] + s->legs_m[i];
        sum += s->has_true ? s->real.tip_m[i] + s->real.axis[i] : 0.0;
    }
    for (int i = 0; i < EXK_N_AXES; i++) {
        sum += s->r_rad[i] + s->m_rad[i] + s->theta_rad[i] + s->q_rad[i] + s->c_rad[i] +
               s->u_rad[i] + s->wrist_rad[i];
    }
    return isfinite(sum);
}

#endif
