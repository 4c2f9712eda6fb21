/* What any such controller can reach, against what ours does on noise that is fresh in every run:
 *
 *   ILC       y_p = d + w_p - u_p + v_p, u_{p+1} = u_p + K y_p; d repeats, w (variance s_w^2) and v
 *             (s_v^2) are new in each run; rho = s_v^2/s_w^2; the true error is d + w_p - u_p.
 *   Feedback  integral only on the twin: n the disturbance, v the sensor's noise, variance r.
 *
 * Seeds are fixed. Every learning RMS comes from 20000 independent samples, standard error
 * 1/sqrt(2 N) = 0.5 %; every feedback RMS from 120000 samples whose squares are correlated, 0.4 % at
 * most (the slowest loop, gain 0.27: sqrt(3.3/120000)/sqrt(2)). All are held to 2 %. */
#include <math.h>
#include <string.h>

#include "exk/feedback.h"
#include "exk/ilc.h"
#include "exk/twin.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static void check_ratio(double want, double got, const char *name)
{
    TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(0.02, 1.0, got / want, name);
}

/* --- learning: samples of one long run are independent machines ------------------------------- */

enum { N = 20000, N_RUNS_MAX = 24 };

typedef struct {
    double sigma_d, sigma_w, sigma_v;
    uint64_t seed;
} world;

static double draw(const world *w, uint8_t source, uint32_t run, int k)
{
    const exk_stream s = {.seed = w->seed, .run = run, .source = source};
    return exk_normal(&s, k);
}

/* One run: y for the learner; returns the RMS of the true error. */
static double run_once(const world *w, uint32_t p, const double *d, const double *u, double *y)
{
    double sum = 0.0;
    for (int k = 0; k < N; k++) {
        const double e = d[k] + w->sigma_w * draw(w, 1, p, k) - u[k];
        y[k] = e + (w->sigma_v > 0.0 ? w->sigma_v * draw(w, 2, p, k) : 0.0);
        sum += e * e;
    }
    return sqrt(sum / N);
}

typedef double (*gain_fn)(const world *w, double k_fixed, int p);

/* rms[p]: true RMS after p updates, the gain of update p + 1 being gain(p). */
static void learn_runs(const world *w, gain_fn gain, double k_fixed, int n_updates, double *rms)
{
    static double d[N];
    static double u[N];
    static double next[N];
    static double y[N];
    static const double none[N];
    memset(u, 0, sizeof u);
    for (int k = 0; k < N; k++) {
        d[k] = w->sigma_d * draw(w, 0, 0, k);
    }
    for (int p = 0; p <= n_updates; p++) {
        rms[p] = run_once(w, (uint32_t)p + 1, d, u, y);
        exk_ilc_config cfg = exk_ilc_default();
        cfg.gain = gain(w, k_fixed, p);
        cfg.u_max_rad = 1e9;
        TEST_ASSERT_EQUAL(EXK_OK, exk_ilc_learn(&cfg, u, y, none, N, next));
        memcpy(u, next, sizeof u);
    }
}

static double fixed_gain(const world *w, double k_fixed, int p)
{
    (void)w;
    (void)p;
    return k_fixed;
}

static double averaging_gain(const world *w, double k_fixed, int p)
{
    (void)w;
    (void)k_fixed;
    return 1.0 / (p + 1.0);
}

/* P_{p+1} = P_p R/(P_p + R) from P_0 = sigma_d^2, that is P_p = P0 R/(p P0 + R). */
static double kalman_gain(const world *w, double k_fixed, int p)
{
    (void)k_fixed;
    const double p0 = w->sigma_d * w->sigma_d;
    const double r = w->sigma_w * w->sigma_w + w->sigma_v * w->sigma_v;
    const double now = p0 * r / (p * p0 + r);
    return now / (now + r);
}

/* s_w^2 [1 + K (1 + rho)/(2 - K)], and the figures the table prints for it. */
static void a_fixed_gain_ends_above_the_floor(void)
{
    static const struct {
        const char *name;
        double gain, sigma_v, printed;
        int n_updates;
    } rows[] = {
        {"K = 0.5", 0.5, 0.0, 1.155, 10},          {"K = 1", 1.0, 0.0, 1.414, 2},
        {"K = 1, rho = 1", 1.0, 1.0, 1.732, 2},    {"K = 1.3", 1.3, 0.0, 1.69, 6},
        {"K = 0.5, rho = 1/4", 0.5, 0.5, 0.0, 10},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const world w = {5.0, 1.0, rows[i].sigma_v, 80 + i};
        const double k = rows[i].gain;
        const double rho = rows[i].sigma_v * rows[i].sigma_v;
        const double want = sqrt(1.0 + k * (1.0 + rho) / (2.0 - k));
        double rms[N_RUNS_MAX];
        learn_runs(&w, fixed_gain, k, rows[i].n_updates, rms);
        check_ratio(want, rms[rows[i].n_updates], rows[i].name);
        TEST_ASSERT_TRUE(rows[i].printed == 0.0 || fabs(want - rows[i].printed) < 0.005);
    }
}

/* On the way there: (1-K)^(2p) d^2 + s_w^2 + [K/(2-K)] (s_w^2 + s_v^2) [1 - (1-K)^(2p)]. */
static void a_fixed_gain_approaches_by_its_formula(void)
{
    const world w = {5.0, 1.0, 0.7, 90};
    const double k = 0.4;
    double rms[N_RUNS_MAX];
    learn_runs(&w, fixed_gain, k, 8, rms);
    for (int p = 0; p <= 8; p++) {
        const double left = pow(1.0 - k, 2.0 * p);
        const double want =
            sqrt(left * 25.0 + 1.0 + k / (2.0 - k) * (1.0 + 0.49) * (1.0 - left));
        check_ratio(want, rms[p], "after p updates");
    }
}

/* s_w^2 [1 + (1 + rho)/p]; printed for rho = 0: p = 3 1.155, 5 1.095, 10 1.049, 20 1.025. */
static void averaging_approaches_the_floor_as_one_over_p(void)
{
    static const int marks[] = {1, 2, 3, 5, 10, 20};
    static const double printed[] = {1.414, 1.225, 1.155, 1.095, 1.049, 1.025};
    for (int i = 0; i < 2; i++) {
        const world w = {5.0, 1.0, i, 100 + (uint64_t)i};
        double rms[N_RUNS_MAX];
        learn_runs(&w, averaging_gain, 0.0, 20, rms);
        for (int j = 0; j < 6; j++) {
            const double want = sqrt(1.0 + (1.0 + i) / marks[j]);
            check_ratio(want, rms[marks[j]], i == 0 ? "rho = 0" : "rho = 1");
            TEST_ASSERT_TRUE(i == 1 || fabs(want - printed[j]) < 0.0006);
        }
    }
}

/* s_w^2 + P0 R/(p P0 + R), below averaging from the first update on. */
static void the_kalman_gain_is_the_best_from_the_first_update(void)
{
    static const double sigma_d[] = {0.5, 1.0};
    for (int i = 0; i < 2; i++) {
        const world w = {sigma_d[i], 1.0, 0.5, 110 + (uint64_t)i};
        const double p0 = sigma_d[i] * sigma_d[i];
        double rms[N_RUNS_MAX];
        double averaged[N_RUNS_MAX];
        learn_runs(&w, kalman_gain, 0.0, 8, rms);
        learn_runs(&w, averaging_gain, 0.0, 8, averaged);
        for (int p = 0; p <= 8; p++) {
            check_ratio(sqrt(1.0 + p0 * 1.25 / (p * p0 + 1.25)), rms[p], "Kalman");
            TEST_ASSERT_TRUE(p == 0 || rms[p] < averaged[p]);
        }
    }
}

/* --- feedback: integral only on the twin ------------------------------------------------------ */

enum { N_STEPS = 60000, N_SETTLE = 1000 };

typedef struct {
    int order;
    double q; /* variance of the white noise, or of a step of the walk */
    double r; /* variance of the measurement noise */
} plant;

static exk_twin twin_of(const plant *p, uint64_t seed, uint32_t series)
{
    exk_twin_config cfg = exk_twin_default();
    cfg.dt_s = 1.0;
    cfg.sensor_sigma_rad = sqrt(p->r);
    cfg.n_disturbances = 1;
    cfg.disturbance[0] = exk_disturbance_default();
    cfg.disturbance[0].wave = EXK_WAVE_GAUSSIAN;
    cfg.disturbance[0].order = p->order;
    cfg.disturbance[0].amplitude = sqrt(p->q);
    cfg.disturbance[0].frozen = false;
    exk_twin twin;
    TEST_ASSERT_EQUAL(EXK_OK, exk_twin_init(&twin, &cfg, (exk_realisation){seed, series, 1}));
    return twin;
}

static exk_feedback pi_of(double kp, double g)
{
    const exk_feedback_config cfg = {.kind = EXK_FEEDBACK_PID,
                                     .pid = {.kp = kp, .ki = g, .c_max_rad = 1e9, .dt_s = 1.0}};
    exk_feedback fb;
    TEST_ASSERT_EQUAL(EXK_OK, exk_feedback_init(&fb, &cfg));
    return fb;
}

/* RMS of the true angles under PI, both channels, reference 0. */
static double closed_loop_rms(const plant *p, double kp, double g, uint64_t seed)
{
    exk_twin twin = twin_of(p, seed, 0);
    exk_feedback fb = pi_of(kp, g);
    double c[EXK_N_AXES] = {0.0, 0.0};
    double sum = 0.0;
    for (int k = 0; k < N_SETTLE + N_STEPS; k++) {
        exk_reading m;
        exk_twin_step(&twin, k, c, &m);
        const double e[EXK_N_AXES] = {-m.measured_rad[0], -m.measured_rad[1]};
        if (k >= N_SETTLE) {
            sum += m.true_rad[0] * m.true_rad[0] + m.true_rad[1] * m.true_rad[1];
        }
        exk_feedback_step(&fb, e, c);
    }
    return sqrt(sum / (EXK_N_AXES * (double)N_STEPS));
}

/* Nothing white can be predicted: floor s_w, every gain ends above it. */
static void white_noise_is_only_amplified_by_feedback(void)
{
    static const struct {
        const char *name;
        double kp, g, want, printed;
    } rows[] = {
        {"integral 0.5", 0.0, 0.5, 4.0 / 3.0, 1.155},
        {"integral 1", 0.0, 1.0, 2.0, 1.414},
        {"PI 0.2/0.5", 0.2, 0.5, 2.0 / (1.2 * 1.1), 1.23},
    };
    const plant white = {0, 1.0, 0.0};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double got = closed_loop_rms(&white, rows[i].kp, rows[i].g, 120 + i);
        check_ratio(sqrt(rows[i].want), got, rows[i].name);
        check_ratio(rows[i].printed, got, rows[i].name);
        TEST_ASSERT_TRUE(got > 1.0);
    }
}

/* Floor P = q/2 + sqrt(q^2/4 + q r), reached by the integral alone with K = P/(P + r). */
static void the_integral_reaches_the_floor_of_a_random_walk(void)
{
    static const struct {
        const char *name;
        double q, r, printed;
    } rows[] = {
        {"the table's walk, s_v = 0.5", 1.0, 0.25, 1.10},
        {"as much measurement noise as walk", 1.0, 1.0, 1.27},
        {"mostly measurement noise", 0.1, 1.0, 0.61},
        {"no measurement noise", 1.0, 0.0, 1.0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const plant walk = {1, rows[i].q, rows[i].r};
        const double q = rows[i].q;
        const double floor_var = 0.5 * q + sqrt(0.25 * q * q + q * rows[i].r);
        const double best = floor_var / (floor_var + rows[i].r);
        const double got = closed_loop_rms(&walk, 0.0, best, 130 + i);
        check_ratio(sqrt(floor_var), got, rows[i].name);
        TEST_ASSERT_DOUBLE_WITHIN(0.01, rows[i].printed, sqrt(floor_var));
    }
}

/* Other gains end above that floor, where (q + K^2 r)/(K (2 - K)) puts them. */
static void other_gains_miss_the_floor_of_a_random_walk(void)
{
    static const double factors[] = {0.4, 0.7, 1.5};
    const plant walk = {1, 1.0, 1.0};
    const double floor_var = 0.5 + sqrt(1.25);
    for (int i = 0; i < 3; i++) {
        const double k = factors[i] * floor_var / (floor_var + 1.0);
        const double want = sqrt((1.0 + k * k) / (k * (2.0 - k)));
        check_ratio(want, closed_loop_rms(&walk, 0.0, k, 140 + (uint64_t)i), "other gain");
        TEST_ASSERT_TRUE(want > 1.02 * sqrt(floor_var));
    }
}

/* --- random walk, the end of a run over many series ------------------------------------------- */

enum { N_SERIES = 10000, N_END = 16 };

static double end_of_walk(uint64_t seed, uint32_t series, uint32_t run, int axis)
{
    exk_disturbance_config cfg = exk_disturbance_default();
    cfg.wave = EXK_WAVE_GAUSSIAN;
    cfg.order = 1;
    cfg.amplitude = 1.0;
    cfg.frozen = false;
    cfg.channel[1 - axis] = false;
    exk_disturbance d;
    double n[EXK_N_AXES] = {0.0, 0.0};
    TEST_ASSERT_EQUAL(
        EXK_OK, exk_disturbance_init(&d, &cfg, 1.0, (exk_realisation){seed, series, run}, 0));
    exk_disturbance_add(&d, N_END, n);
    return n[axis];
}

/* Open loop ends at N q; feedback with K = 1 holds q: it wins sqrt(N). ILC with K = 1 replays the
 * last run's walk against a new one: sqrt 2 worse than no control. */
static void a_fresh_walk_is_won_by_feedback_and_lost_by_learning(void)
{
    double open = 0.0;
    double learned = 0.0;
    for (uint32_t series = 0; series < N_SERIES; series++) {
        for (int axis = 0; axis < EXK_N_AXES; axis++) {
            const double now = end_of_walk(150, series, 2, axis);
            const double before = end_of_walk(150, series, 1, axis);
            exk_ilc_config ilc = exk_ilc_default();
            ilc.gain = 1.0;
            ilc.u_max_rad = 1e9;
            const double e = -before;
            const double zero = 0.0;
            double u;
            TEST_ASSERT_EQUAL(EXK_OK, exk_ilc_learn(&ilc, &zero, &e, &zero, 1, &u));
            open += now * now;
            learned += (now + u) * (now + u);
        }
    }
    const double count = (double)N_SERIES * EXK_N_AXES;
    const plant walk = {1, 1.0, 0.0};
    check_ratio(4.0, sqrt(open / count) / closed_loop_rms(&walk, 0.0, 1.0, 151), "sqrt(N)");
    check_ratio(sqrt(2.0), sqrt(learned / open), "learning against no control");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_fixed_gain_ends_above_the_floor);
    RUN_TEST(a_fixed_gain_approaches_by_its_formula);
    RUN_TEST(averaging_approaches_the_floor_as_one_over_p);
    RUN_TEST(the_kalman_gain_is_the_best_from_the_first_update);
    RUN_TEST(white_noise_is_only_amplified_by_feedback);
    RUN_TEST(the_integral_reaches_the_floor_of_a_random_walk);
    RUN_TEST(other_gains_miss_the_floor_of_a_random_walk);
    RUN_TEST(a_fresh_walk_is_won_by_feedback_and_lost_by_learning);
    return UNITY_END();
}
