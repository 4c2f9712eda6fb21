/* ILC over whole runs of the twin, both angles, with and without feedback beside it. */
#include <complex.h>
#include <math.h>
#include <string.h>

#include "exk/feedback.h"
#include "exk/ilc.h"
#include "exk/twin.h"
#include "exk/units.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { N = 600 };

/* One run: the error the loop saw, the feedback beside it, the correction in force. */
typedef struct {
    double e[EXK_N_AXES][N];
    double c[EXK_N_AXES][N];
    double u[EXK_N_AXES][N];
} record;

/* Amplitude of the sampled reference. */
static const double MOVING = 0.05;
static const double STILL = 0.0;

static double reference(double size, int axis, int k)
{
    return size * sin(0.01 * k + axis);
}

static void add_gaussian(exk_twin_config *cfg, int order, double sigma, bool frozen)
{
    exk_disturbance_config *d = &cfg->disturbance[cfg->n_disturbances++];
    *d = exk_disturbance_default();
    d->wave = EXK_WAVE_GAUSSIAN;
    d->order = order;
    d->amplitude = sigma;
    d->frozen = frozen;
}

/* Accumulating, white and constant noise, all repeating. */
static exk_twin_config frozen_noise(void)
{
    exk_twin_config cfg = exk_twin_default();
    add_gaussian(&cfg, 1, 1e-4, true);
    add_gaussian(&cfg, 0, 1e-5, true);
    exk_disturbance_config *d = &cfg.disturbance[cfg.n_disturbances++];
    *d = exk_disturbance_default();
    d->wave = EXK_WAVE_CONSTANT;
    d->amplitude = 3e-4;
    return cfg;
}

static exk_feedback_config pi_of(double kp, double g)
{
    exk_feedback_config cfg = exk_feedback_default();
    cfg.kind = kp > 0.0 || g > 0.0 ? EXK_FEEDBACK_PID : EXK_FEEDBACK_NONE;
    cfg.pid.kp = kp;
    cfg.pid.ki = g / cfg.pid.dt_s;
    return cfg;
}

static void drive_along(double size, const exk_twin_config *twin_cfg,
                        const exk_feedback_config *fb_cfg, uint32_t run, record *r)
{
    exk_twin twin;
    exk_feedback fb;
    const exk_realisation which = {.seed = 70, .series = 3, .run = run};
    TEST_ASSERT_EQUAL(EXK_OK, exk_twin_init(&twin, twin_cfg, which));
    TEST_ASSERT_EQUAL(EXK_OK, exk_feedback_init(&fb, fb_cfg));
    double c[EXK_N_AXES] = {0.0, 0.0};
    for (int k = 0; k < N; k++) {
        double q[EXK_N_AXES];
        double e[EXK_N_AXES];
        exk_reading m;
        for (int i = 0; i < EXK_N_AXES; i++) {
            q[i] = reference(size, i, k) + c[i] + exk_ilc_at(r->u[i], N, k);
        }
        exk_twin_step(&twin, k, q, &m);
        for (int i = 0; i < EXK_N_AXES; i++) {
            e[i] = reference(size, i, k) - m.measured_rad[i];
            r->e[i][k] = e[i];
            r->c[i][k] = c[i];
        }
        exk_feedback_step(&fb, e, c);
    }
}

static void drive(const exk_twin_config *twin_cfg, const exk_feedback_config *fb_cfg,
                  uint32_t run, record *r)
{
    drive_along(MOVING, twin_cfg, fb_cfg, run, r);
}

static void drive_still(const exk_twin_config *twin_cfg, uint32_t run, record *r)
{
    const exk_feedback_config none = pi_of(0.0, 0.0);
    drive_along(STILL, twin_cfg, &none, run, r);
}

static void learn(const exk_ilc_config *cfg, record *r)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        double next[N];
        TEST_ASSERT_EQUAL(EXK_OK, exk_ilc_learn(cfg, r->u[i], r->e[i], r->c[i], N, next));
        memcpy(r->u[i], next, sizeof next);
    }
}

static double rms(const record *r)
{
    double sum = 0.0;
    for (int i = 0; i < EXK_N_AXES; i++) {
        for (int k = 0; k < N; k++) {
            sum += r->e[i][k] * r->e[i][k];
        }
    }
    return sqrt(sum / (N * EXK_N_AXES));
}

static exk_ilc_config p_type(double gain)
{
    exk_ilc_config cfg = exk_ilc_default();
    cfg.gain = gain;
    return cfg;
}

/* Run p has the error of run 1 times (1 - K)^(p-1), sample by sample, whatever feedback works
 * beside it. Angles of 0.05 rad round at 7e-18; the loop with PI 0.2/1.4 amplifies that by 6. */
static void the_error_falls_as_the_power_law_in_every_sample(void)
{
    static const double gain[] = {0.3, 0.5, 1.0, 1.3};
    static const double pi[][2] = {
        {0.0, 0.0}, {0.0, 0.002}, {0.2, 0.5}, {0.8, 0.3}, {0.2, 1.4}};
    const exk_twin_config twin = frozen_noise();
    for (int j = 0; j < 4 * 5; j++) {
        const double kp = pi[j / 4][0];
        const exk_feedback_config fb = pi_of(kp, pi[j / 4][1]);
        const exk_ilc_config ilc = p_type(gain[j % 4]);
        static record first;
        record r = {.u = {{0.0}}};
        for (int p = 1; p <= 6; p++) {
            drive(&twin, &fb, (uint32_t)p, &r);
            first = p == 1 ? r : first;
            const double left = pow(1.0 - ilc.gain, p - 1);
            for (int k = 0; k < N; k++) {
                TEST_ASSERT_DOUBLE_WITHIN(1e-15, left * first.e[0][k], r.e[0][k]);
                TEST_ASSERT_DOUBLE_WITHIN(1e-15, left * first.e[1][k], r.e[1][k]);
            }
            learn(&ilc, &r);
        }
    }
}

/* 60 passes at K = 0.5 leave 2^-59 of 3e-4 rad: nothing but rounding. */
static void the_error_falls_to_numeric_zero(void)
{
    const exk_twin_config twin = frozen_noise();
    for (int with_pi = 0; with_pi < 2; with_pi++) {
        const exk_feedback_config fb = pi_of(0.2 * with_pi, 0.5 * with_pi);
        const exk_ilc_config ilc = p_type(0.5);
        record r = {.u = {{0.0}}};
        drive(&twin, &fb, 1, &r);
        TEST_ASSERT_TRUE(rms(&r) > 1e-6);
        for (uint32_t p = 2; p <= 61; p++) {
            learn(&ilc, &r);
            drive(&twin, &fb, p, &r);
        }
        TEST_ASSERT_TRUE(rms(&r) < 2e-17);
    }
}

/* Why the law has c_p in it: the error alone, learned beside PI, does not fall as (1 - K)^(p-1). */
static void learning_the_error_alone_stalls_beside_feedback(void)
{
    static const double none[N];
    exk_twin_config twin = exk_twin_default();
    add_gaussian(&twin, 1, 1e-4, true);
    const exk_feedback_config fb = pi_of(0.2, 0.5);
    const exk_ilc_config ilc = p_type(0.5);
    record r = {.u = {{0.0}}};
    drive(&twin, &fb, 1, &r);
    const double first = rms(&r);
    for (uint32_t p = 2; p <= 5; p++) {
        for (int i = 0; i < EXK_N_AXES; i++) {
            double next[N];
            TEST_ASSERT_EQUAL(EXK_OK, exk_ilc_learn(&ilc, r.u[i], r.e[i], none, N, next));
            memcpy(r.u[i], next, sizeof next);
        }
        drive(&twin, &fb, p, &r);
    }
    TEST_ASSERT_TRUE(rms(&r) > 4.0 * first / 16.0);
}

/* PD: a sine that repeats is scaled by |1 - K - h (1 - exp(-j w))| in a pass, and check accepts
 * exactly the gains with which every frequency shrinks. */
static double pass_gain(double gain, double h, double omega)
{
    const double re = 1.0 - gain - h * (1.0 - cos(omega));
    const double im = h * sin(omega);
    return sqrt(re * re + im * im);
}

static void check_accepts_the_gains_with_which_all_frequencies_shrink(void)
{
    int n_accepted = 0;
    for (int i = 1; i < 45; i++) {
        for (int j = 0; j < 25; j++) {
            exk_ilc_config cfg = p_type(0.05 * i + 0.007);
            const double h = 0.05 * j;
            cfg.d_gain_s = h * cfg.dt_s;
            double worst = 0.0;
            for (int k = 0; k <= 256; k++) {
                worst = fmax(worst, pass_gain(cfg.gain, h, EXK_PI * k / 256.0));
            }
            const bool good = exk_ilc_check(&cfg) == EXK_OK;
            TEST_ASSERT_EQUAL(worst < 1.0, good);
            n_accepted += good;
        }
    }
    TEST_ASSERT_INT_WITHIN(200, 500, n_accepted);
}

static void one_pass_scales_a_sine_by_the_formula(void)
{
    static const double omegas[] = {0.01, 0.3, 1.0, 2.0, 3.1};
    static const double h[] = {0.0, 0.2, 0.7};
    for (int i = 0; i < 5 * 3; i++) {
        const double w = omegas[i % 5];
        exk_ilc_config cfg = p_type(0.5);
        cfg.d_gain_s = h[i / 5] * cfg.dt_s;
        double u[N] = {0.0};
        double x[N];
        double next[N];
        for (int k = 0; k < N; k++) {
            x[k] = 1e-3 * sin(w * k + 0.2);
        }
        TEST_ASSERT_EQUAL(EXK_OK, exk_ilc_learn(&cfg, u, x, u, N, next));
        double before = 0.0; /* x and x - u in quadrature: amplitudes of neighbouring samples */
        double after = 0.0;
        for (int k = 1; k + 1 < N; k++) {
            before += x[k] * x[k] - x[k - 1] * x[k + 1];
            const double now = x[k] - next[k];
            after +=
                k > 1 ? now * now - (x[k - 1] - next[k - 1]) * (x[k + 1] - next[k + 1]) : 0.0;
        }
        const double ratio = sqrt(after / (N - 3) / (before / (N - 2)));
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, pass_gain(0.5, h[i / 5], w), ratio);
    }
}

/* A servo lag x[k] = a x[k-1] + (1 - a) q[k] is undone by PD with h = K a/(1 - a): the learned
 * correction is K times the lag's inverse, so the error falls by 1 - K again, in every sample. */
static void a_derivative_gain_undoes_a_servo_lag(void)
{
    exk_twin_config twin = frozen_noise();
    twin.servo_tau_s = 1e-3;
    const exk_feedback_config fb = pi_of(0.0, 0.0);
    exk_ilc_config ilc = p_type(0.7);
    const double a = exp(-1.0);
    ilc.d_gain_s = ilc.gain * a / (1.0 - a) * ilc.dt_s;
    record r = {.u = {{0.0}}};
    drive(&twin, &fb, 1, &r);
    const record first = r;
    for (int p = 2; p <= 6; p++) {
        learn(&ilc, &r);
        drive(&twin, &fb, (uint32_t)p, &r);
        for (int k = 0; k < N; k++) {
            const double left = pow(0.3, p - 1);
            TEST_ASSERT_DOUBLE_WITHIN(1e-15, left * first.e[0][k], r.e[0][k]);
        }
    }
}

/* Amplitude of a sine in the middle of the record: there e[k]^2 - e[k-1] e[k+1] is the square of the
 * amplitude times sin(w)^2. */
static double amplitude(const record *r, double omega)
{
    double sum = 0.0;
    for (int k = 300; k < 450; k++) {
        sum += r->e[0][k] * r->e[0][k] - r->e[0][k - 1] * r->e[0][k + 1];
    }
    return sqrt(sum / 150.0) / sin(omega);
}

/* A pass scales a repeating sine by |1 - K G(w) exp(j w lead)|, G = (1 - a)/(1 - a exp(-j w)): the
 * lead that cancels the phase of the lag learns faster. The edges of the record (start of the lag,
 * samples held past the end) stay out of its middle. */
static void a_lead_makes_up_for_the_phase_of_a_servo_lag(void)
{
    static const int leads[] = {0, 3, 7};
    const double omega = 2.0 * EXK_PI * 0.02; /* 20 Hz at 1 kHz */
    const double a = exp(-0.1);
    exk_twin_config twin = exk_twin_default();
    twin.servo_tau_s = 10e-3;
    twin.n_disturbances = 1;
    twin.disturbance[0] = (exk_disturbance_config){
        .wave = EXK_WAVE_SINE, .channel = {true, true}, .amplitude = 1e-3, .freq_Hz = 20.0};
    double ratio[3];
    for (int i = 0; i < 3; i++) {
        exk_ilc_config ilc = p_type(0.8);
        ilc.lead = leads[i];
        const double complex g = (1.0 - a) / (1.0 - a * cexp(-I * omega));
        ratio[i] = cabs(1.0 - ilc.gain * g * cexp(I * omega * leads[i]));
        record r = {.u = {{0.0}}};
        drive_still(&twin, 1, &r);
        for (uint32_t p = 2; p <= 6; p++) {
            const double before = amplitude(&r, omega);
            learn(&ilc, &r);
            drive_still(&twin, p, &r);
            TEST_ASSERT_DOUBLE_WITHIN(1e-6, ratio[i], amplitude(&r, omega) / before);
        }
    }
    TEST_ASSERT_TRUE(ratio[2] < ratio[1] && ratio[1] < ratio[0] && ratio[2] < 0.7 * ratio[0]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_error_falls_as_the_power_law_in_every_sample);
    RUN_TEST(the_error_falls_to_numeric_zero);
    RUN_TEST(learning_the_error_alone_stalls_beside_feedback);
    RUN_TEST(check_accepts_the_gains_with_which_all_frequencies_shrink);
    RUN_TEST(one_pass_scales_a_sine_by_the_formula);
    RUN_TEST(a_derivative_gain_undoes_a_servo_lag);
    RUN_TEST(a_lead_makes_up_for_the_phase_of_a_servo_lag);
    return UNITY_END();
}
