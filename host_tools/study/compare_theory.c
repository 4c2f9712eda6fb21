#include <math.h>
#include <stdlib.h>

#include "compare.h"
#include "exk/pid.h"

/* rms in the plane from the angle variances v[k], both angles alike: the mean over the path of
 * v[k] (|dp/dalpha|^2 + |dp/dbeta|^2), the derivatives by differences of the rig's own forward. */
static double arm2_m2(const exk_rig *rig, int64_t k)
{
    const double step_rad = 1e-6;
    exk_ref ref;
    exk_joints joints;
    double sum = 0.0;
    exk_plan_at(&rig->plan, k, &ref);
    exk_kin_inverse(&rig->kin, &ref.tool, &joints);
    for (int i = 0; i < EXK_N_AXES; i++) {
        exk_tool low, high;
        exk_joints at = joints;
        at.angle_rad[i] = joints.angle_rad[i] - step_rad;
        exk_kin_forward(&rig->kin, &at, &low);
        at.angle_rad[i] = joints.angle_rad[i] + step_rad;
        exk_kin_forward(&rig->kin, &at, &high);
        for (int j = EXK_X; j <= EXK_Y; j++) {
            const double slope = (high.tip_m[j] - low.tip_m[j]) / (2.0 * step_rad);
            sum += slope * slope;
        }
    }
    return sum;
}

static study_rms in_plane(const exk_rig *rig, const double *variance)
{
    const int64_t n = rig->plan.n_ticks;
    double sum_m2 = 0.0;
    double last_m2 = 0.0;
    for (int64_t k = 0; k < n; k++) {
        last_m2 = variance[k] * arm2_m2(rig, k);
        sum_m2 += last_m2;
    }
    return (study_rms){sqrt(sum_m2 / (double)n), sqrt(last_m2)};
}

/* Second order, level observed exactly, one step ahead: P = A (P - P H' (H P H')^-1 H P) A' + Q, and
 * what is left of P after an exact look at the level is the rate's variance r alone, so
 *   level variance ahead  r dt^2 + q dt^3/3,   rate after the look  P22 - P12^2 / P11. */
static void second_order_floor(double q, double dt, int64_t n, double *variance)
{
    double rate = 0.0; /* variance of the rate once the level of tick k is known */
    variance[0] = 0.0;
    for (int64_t k = 1; k < n; k++) {
        const double p11 = rate * dt * dt + q * dt * dt * dt / 3.0;
        const double p12 = rate * dt + q * dt * dt / 2.0;
        const double p22 = rate + q * dt;
        variance[k] = p11;
        rate = p22 - p12 * p12 / p11;
    }
}

static void floor_variance(const study_noise *noise, double dt, int64_t n, double *variance)
{
    const double s2 = noise->sigma * noise->sigma;
    if (noise->order == 2) {
        second_order_floor(s2, dt, n, variance);
        return;
    }
    for (int64_t k = 0; k < n; k++) {
        variance[k] = noise->order == 0 ? s2 : (k == 0 ? 0.0 : s2 * dt);
    }
}

study_rms study_cell_floor(const study_compare *compare, study_cell cell, const exk_rig *rig)
{
    const size_t n = (size_t)rig->plan.n_ticks;
    double *variance = calloc(n, sizeof *variance);
    study_rms rms = {NAN, NAN};
    if (cell.frozen && study_controller_at(cell.controller)->ilc_gain > 0.0) {
        rms = (study_rms){0.0, 0.0};
    } else if (variance != NULL) {
        floor_variance(&compare->noises[cell.noise], rig->plan.cfg.dt_s, (int64_t)n, variance);
        rms = in_plane(rig, variance);
    }
    free(variance);
    return rms;
}

/* Adds to variance[k] what one normal of each step does through the loop: response(m) is the noise
 * m steps after it, the loop answers with its own controller. */
static void add_response(const exk_rig *rig, double (*response)(double dt, int64_t m),
                         double scale, int64_t n, double *variance)
{
    exk_feedback fb;
    double c[EXK_N_AXES] = {0.0};
    double sum = 0.0;
    exk_feedback_init(&fb, &rig->profile.feedback);
    for (int64_t m = 0; m < n; m++) {
        const double e = -(scale * response(rig->plan.cfg.dt_s, m) + c[0]);
        const double error[EXK_N_AXES] = {e, e};
        exk_feedback_step(&fb, error, c);
        sum += e * e;
        variance[m] += sum;
    }
}

static double white_response(double dt, int64_t m)
{
    (void)dt;
    return m == 0 ? 1.0 : 0.0;
}

static double walk_response(double dt, int64_t m)
{
    return m == 0 ? 0.0 : sqrt(dt);
}

/* The two normals of a second-order step (disturbance.h). */
static double rate_response(double dt, int64_t m)
{
    return m == 0 ? 0.0 : dt * sqrt(dt) * ((double)m - 0.5);
}

static double level_response(double dt, int64_t m)
{
    return m == 0 ? 0.0 : dt * sqrt(dt) / sqrt(12.0);
}

static double learning_factor(double gain, bool frozen)
{
    const double left = pow(1.0 - gain, STUDY_COMPARE_UPDATES);
    if (gain <= 0.0) {
        return 1.0;
    }
    return frozen ? fabs(left) : sqrt(1.0 + gain / (2.0 - gain) * (1.0 - left * left));
}

study_rms study_cell_theory(const study_compare *compare, study_cell cell, const exk_rig *rig)
{
    const study_noise *noise = &compare->noises[cell.noise];
    const double factor =
        learning_factor(study_controller_at(cell.controller)->ilc_gain, cell.frozen);
    const int64_t n = rig->plan.n_ticks;
    double *variance = calloc((size_t)n, sizeof *variance);
    if (variance == NULL) {
        return (study_rms){NAN, NAN};
    }
    if (noise->order == 2) {
        add_response(rig, rate_response, noise->sigma, n, variance);
        add_response(rig, level_response, noise->sigma, n, variance);
    } else {
        add_response(rig, noise->order == 0 ? white_response : walk_response, noise->sigma, n,
                     variance);
    }
    const study_rms rms = in_plane(rig, variance);
    free(variance);
    return (study_rms){factor * rms.path_m, factor * rms.last_m};
}
