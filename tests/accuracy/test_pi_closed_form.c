/* PI on the unit-gain axis with one step of delay against its closed form: e[k] = -(n[k] + c[k]).
 *
 * With g = ki dt the error obeys e[k+2] + (kp + g - 1) e[k+1] - kp e[k] = -(n[k+2] - n[k+1]), whose
 * roots l1, l2 are real: their product is -kp. */
#include <complex.h>
#include <math.h>

#include "exk/pid.h"
#include "exk/random.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static const struct {
    double kp, g;
} gains[] = {
    {0.0, 0.1}, {0.0, 0.5}, {0.0, 1.0}, {0.0, 1.5}, {0.0, 1.9},  {0.2, 0.5},
    {0.2, 1.4}, {0.5, 0.1}, {0.5, 0.9}, {0.8, 0.1}, {0.9, 0.15},
};
enum { N_GAINS = sizeof gains / sizeof *gains };

static exk_pid start(int i)
{
    const double dt_s = 1e-3;
    const exk_pid_config cfg = {
        .kp = gains[i].kp, .ki = gains[i].g / dt_s, .c_max_rad = 1e6, .dt_s = dt_s};
    exk_pid pid;
    TEST_ASSERT_EQUAL(EXK_OK, exk_pid_init(&pid, &cfg));
    return pid;
}

typedef struct {
    double l1, l2;
} roots;

static roots roots_of(int i)
{
    const double half = 0.5 * (1.0 - gains[i].kp - gains[i].g);
    const double root = sqrt(half * half + gains[i].kp);
    return (roots){half + root, half - root};
}

/* The combination of l1^k and l2^k that starts with x0, x1. A double root is 0 here: kp = 0, g = 1. */
static double mode(roots l, double x0, double x1, int k)
{
    if (!(l.l1 > l.l2)) {
        return k == 0 ? x0 : (k == 1 ? x1 : 0.0);
    }
    const double a = (x1 - l.l2 * x0) / (l.l1 - l.l2);
    return a * pow(l.l1, k) + (x0 - a) * pow(l.l2, k);
}

static void a_constant_is_integrated_away(void)
{
    const double d = 2e-3;
    for (int i = 0; i < N_GAINS; i++) {
        exk_pid pid = start(i);
        const double e1 = -d * (1.0 - gains[i].kp - gains[i].g);
        double c = 0.0;
        for (int k = 0; k < 200; k++) {
            const double e = -(d + c);
            TEST_ASSERT_DOUBLE_WITHIN(1e-13 * d, mode(roots_of(i), -d, e1, k), e);
            if (gains[i].kp == 0.0) {
                TEST_ASSERT_DOUBLE_WITHIN(1e-13 * d, -d * pow(1.0 - gains[i].g, k), e);
            }
            c = exk_pid_step(&pid, e);
        }
    }
}

/* n[k] = a k: the error ends at -a/g, what the integral needs to follow the slope. */
static void a_ramp_leaves_its_slope_over_the_integral_gain(void)
{
    const double a = 1e-5;
    for (int i = 0; i < N_GAINS; i++) {
        exk_pid pid = start(i);
        const double rest = -a / gains[i].g;
        double c = 0.0;
        double e = 0.0;
        for (int k = 0; k < 2000; k++) {
            e = -(a * k + c);
            TEST_ASSERT_DOUBLE_WITHIN(1e-10 * a, rest + mode(roots_of(i), -rest, -a - rest, k),
                                      e);
            c = exk_pid_step(&pid, e);
        }
        TEST_ASSERT_DOUBLE_WITHIN(1e-10 * a, rest, e);
    }
}

/* S(z) = z (z - 1) / (z^2 + (kp + g - 1) z - kp), e = -S n. */
static double complex sensitivity(int i, double omega)
{
    const double complex z = cexp(I * omega);
    return z * (z - 1.0) / (z * z + (gains[i].kp + gains[i].g - 1.0) * z - gains[i].kp);
}

/* Once the start has died out: the slowest of these roots, -0.974, is 1e-17 after 1500 steps. */
static void a_sine_is_scaled_by_the_sensitivity(void)
{
    static const double omegas[] = {0.001, 0.03, 0.3, 1.0, 2.0, 3.0};
    for (int i = 0; i < N_GAINS; i++) {
        for (int j = 0; j < 6; j++) {
            exk_pid pid = start(i);
            const double complex s = sensitivity(i, omegas[j]);
            double c = 0.0;
            for (int k = 0; k < 2000; k++) {
                const double e = -(sin(omegas[j] * k) + c);
                const double want = -cabs(s) * sin(omegas[j] * k + carg(s));
                if (k > 1500) {
                    TEST_ASSERT_DOUBLE_WITHIN(1e-11, want, e);
                }
                c = exk_pid_step(&pid, e);
            }
        }
    }
}

/* White noise of variance 1: var e = ||S||^2 = 2 / ((1 + kp)(2 - 2 kp - g)), which is 2/(2 - K) for
 * the integral alone: nothing white can be predicted, every gain adds. */
static double white_variance(int i)
{
    return 2.0 / ((1.0 + gains[i].kp) * (2.0 - 2.0 * gains[i].kp - gains[i].g));
}

/* Squares of a record whose slowest root is l are worth (1 - l^2)/(1 + l^2) independent ones each;
 * the record is longer by as much, so the standard error of its variance is sqrt(2/50000) = 0.63 %
 * for every row. */
enum { N_INDEPENDENT = 50000, N_SETTLE = 1000 };

static int record_length(int i)
{
    const roots l = roots_of(i);
    const double slowest = fmax(fabs(l.l1), fabs(l.l2));
    return (int)(N_INDEPENDENT * (1.0 + slowest * slowest) / (1.0 - slowest * slowest));
}

static double measured_variance(int i)
{
    const exk_stream stream = {.seed = 60, .series = (uint32_t)i};
    const int n = record_length(i);
    exk_pid pid = start(i);
    double c = 0.0;
    double sum = 0.0;
    for (int k = 0; k < N_SETTLE + n; k++) {
        const double e = -(exk_normal(&stream, k) + c);
        sum += k >= N_SETTLE ? e * e : 0.0;
        c = exk_pid_step(&pid, e);
    }
    return sum / n;
}

/* Four standard errors. */
static void white_noise_is_amplified_by_the_closed_form(void)
{
    for (int i = 0; i < N_GAINS; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(0.025, 1.0, measured_variance(i) / white_variance(i));
        TEST_ASSERT_TRUE(white_variance(i) > 1.0);
    }
}

/* The published figures of the same formula: PI 0.2/0.5 1.23, K = 0.5 1.155, K = 1 1.414. */
static void the_closed_form_gives_the_figures_of_the_limits_table(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(0.005, 1.23, sqrt(white_variance(5)));
    TEST_ASSERT_DOUBLE_WITHIN(0.0005, 1.155, sqrt(white_variance(1)));
    TEST_ASSERT_DOUBLE_WITHIN(0.0005, 1.414, sqrt(white_variance(2)));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_constant_is_integrated_away);
    RUN_TEST(a_ramp_leaves_its_slope_over_the_integral_gain);
    RUN_TEST(a_sine_is_scaled_by_the_sensitivity);
    RUN_TEST(white_noise_is_amplified_by_the_closed_form);
    RUN_TEST(the_closed_form_gives_the_figures_of_the_limits_table);
    return UNITY_END();
}
