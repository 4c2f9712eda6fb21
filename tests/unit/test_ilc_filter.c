/* Q alone: with zero error and feedback the law is u_{p+1} = clip(Q(u_p)). */
#include <math.h>

#include "exk/ilc.h"
#include "exk/units.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { N = 4000 };

static double u[N];
static double out[N];
static const double zero[N];

static void filter(double cutoff_Hz, double u_max)
{
    const exk_ilc_config cfg = {
        .gain = 1.0, .cutoff_Hz = cutoff_Hz, .u_max_rad = u_max, .dt_s = 1e-3};
    TEST_ASSERT_EQUAL(EXK_OK, exk_ilc_learn(&cfg, u, zero, zero, N, out));
}

static void fill_sine(double freq_Hz)
{
    for (int k = 0; k < N; k++) {
        u[k] = sin(2.0 * EXK_PI * freq_Hz * 1e-3 * (k - N / 2) + 0.4);
    }
}

/* The start on the first sample: a constant is its own rest state, bit for bit. */
static void a_constant_passes_as_it_is(void)
{
    static const double cutoffs_Hz[] = {1e-3, 1.0, 50.0, 249.0};
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < N; k++) {
            u[k] = -0.3;
        }
        filter(cutoffs_Hz[i], 1.0);
        for (int k = 0; k < N; k++) {
            TEST_ASSERT_TRUE(out[k] == -0.3);
        }
    }
}

/* |H|^2 of a bilinear Butterworth of second order: 1 / (1 + (tan(pi f dt)/tan(pi fc dt))^4), and no
 * phase: the middle of the record is the same sine, scaled. The start-up has died out there: its
 * slowest pole, exp(-2 pi fc dt / sqrt 2) at 5 Hz, is 1e-16 after 1660 of the 2000 samples. */
static void sines_are_scaled_without_phase(void)
{
    static const struct {
        const char *name;
        double cutoff_Hz, freq_Hz;
    } rows[] = {
        {"at the cutoff", 40.0, 40.0},   {"an octave below", 40.0, 20.0},
        {"an octave above", 40.0, 80.0}, {"far above", 40.0, 333.0},
        {"low cutoff", 5.0, 7.0},        {"high cutoff", 240.0, 300.0},
    };
    for (int i = 0; i < 6; i++) {
        const double ratio =
            tan(EXK_PI * rows[i].freq_Hz * 1e-3) / tan(EXK_PI * rows[i].cutoff_Hz * 1e-3);
        const double gain = 1.0 / (1.0 + pow(ratio, 4.0));
        fill_sine(rows[i].freq_Hz);
        filter(rows[i].cutoff_Hz, 10.0);
        for (int k = N / 2 - 100; k < N / 2 + 100; k++) {
            TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-12, gain * u[k], out[k], rows[i].name);
        }
    }
}

static void the_gain_at_the_cutoff_is_one_half(void)
{
    fill_sine(40.0);
    filter(40.0, 10.0);
    TEST_ASSERT_DOUBLE_WITHIN(1e-13, 0.5 * u[N / 2], out[N / 2]);
}

/* An impulse in the middle: the answer is even about it, and its samples sum to the gain at 0. */
static void an_impulse_answers_evenly_and_keeps_its_area(void)
{
    for (int k = 0; k < N; k++) {
        u[k] = k == N / 2 ? 1.0 : 0.0;
    }
    filter(40.0, 10.0);
    double sum = 0.0;
    for (int k = 0; k < N; k++) {
        sum += out[k];
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1.0, sum);
    for (int k = 1; k < 1000; k++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, out[N / 2 - k], out[N / 2 + k]);
    }
}

/* The limit comes after Q: a spike that Q takes away does not meet it, a level above does. */
static void the_limit_is_applied_after_the_filter(void)
{
    for (int k = 0; k < N; k++) {
        u[k] = k == 100 ? 5.0 : 0.0;
    }
    filter(1.0, 1.0);
    TEST_ASSERT_TRUE(out[100] > 0.0 && out[100] < 0.05);
    const double at_spike = out[100];
    u[100] = 50.0;
    filter(1.0, 1.0);
    TEST_ASSERT_DOUBLE_WITHIN(1e-14, 10.0 * at_spike, out[100]);
    for (int k = 0; k < N; k++) {
        u[k] = k < N / 2 ? 3.0 : -3.0;
    }
    filter(10.0, 1.0);
    TEST_ASSERT_TRUE(out[0] == 1.0 && out[N - 1] == -1.0);
}

/* The same filter in its textbook form, y = b0 x + b1 x1 + b2 x2 - a1 y1 - a2 y2, with all four
 * memories on the first sample: every sample, the edges too. */
static void textbook(double cutoff_Hz, double *x, int from, int to)
{
    const double g = tan(EXK_PI * cutoff_Hz * 1e-3);
    const double a0 = 1.0 + sqrt(2.0) * g + g * g;
    const double b = g * g / a0;
    const double a1 = 2.0 * (g * g - 1.0) / a0;
    const double a2 = (1.0 - sqrt(2.0) * g + g * g) / a0;
    const int step = from < to ? 1 : -1;
    double x1 = x[from];
    double x2 = x1;
    double y1 = x1;
    double y2 = x1;
    for (int k = from; k != to + step; k += step) {
        const double y = b * (x[k] + 2.0 * x1 + x2) - a1 * y1 - a2 * y2;
        x2 = x1;
        x1 = x[k];
        y2 = y1;
        y1 = y;
        x[k] = y;
    }
}

static void every_sample_is_that_of_the_textbook_form(void)
{
    static const double cutoffs_Hz[] = {5.0, 40.0, 200.0};
    static double want[N];
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < N; k++) {
            u[k] = sin(0.001 * k * k) + 0.001 * k;
            want[k] = u[k];
        }
        textbook(cutoffs_Hz[i], want, 0, N - 1);
        textbook(cutoffs_Hz[i], want, N - 1, 0);
        filter(cutoffs_Hz[i], 10.0);
        for (int k = 0; k < N; k++) {
            TEST_ASSERT_DOUBLE_WITHIN(1e-11, want[k], out[k]);
        }
    }
}

static void one_sample_is_its_own_constant(void)
{
    const double one[1] = {0.25};
    const exk_ilc_config cfg = {.gain = 1.0, .cutoff_Hz = 40.0, .u_max_rad = 1.0, .dt_s = 1e-3};
    double next[1];
    TEST_ASSERT_EQUAL(EXK_OK, exk_ilc_learn(&cfg, one, zero, zero, 1, next));
    TEST_ASSERT_TRUE(next[0] == 0.25);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_constant_passes_as_it_is);
    RUN_TEST(sines_are_scaled_without_phase);
    RUN_TEST(the_gain_at_the_cutoff_is_one_half);
    RUN_TEST(an_impulse_answers_evenly_and_keeps_its_area);
    RUN_TEST(the_limit_is_applied_after_the_filter);
    RUN_TEST(every_sample_is_that_of_the_textbook_form);
    RUN_TEST(one_sample_is_its_own_constant);
    return UNITY_END();
}
