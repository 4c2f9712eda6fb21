#include <math.h>
#include <string.h>

#include "exk/disturbance.h"
#include "exk/units.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static const exk_realisation first = {.seed = 11, .series = 2, .run = 1};

static exk_disturbance_config config(exk_wave wave, int order, double amplitude)
{
    exk_disturbance_config cfg = exk_disturbance_default();
    cfg.wave = wave;
    cfg.order = order;
    cfg.amplitude = amplitude;
    return cfg;
}

static exk_disturbance start(const exk_disturbance_config *cfg, double dt_s,
                             exk_realisation which, uint8_t source)
{
    exk_disturbance d;
    TEST_ASSERT_EQUAL(EXK_OK, exk_disturbance_init(&d, cfg, dt_s, which, source));
    return d;
}

static double value(exk_disturbance *d, int64_t k, int axis)
{
    double out[EXK_N_AXES] = {0.0, 0.0};
    exk_disturbance_add(d, k, out);
    return out[axis];
}

/* --- what init refuses ------------------------------------------------------------------------ */

static const struct {
    const char *name;
    exk_disturbance_config cfg;
    double dt_s;
    exk_err want;
} checks[] = {
    {"none", {.wave = EXK_WAVE_NONE}, 1e-3, EXK_OK},
    {"negative constant", {.wave = EXK_WAVE_CONSTANT, .amplitude = -1.0}, 1e-3, EXK_OK},
    {"negative sine", {.wave = EXK_WAVE_SINE, .amplitude = -1.0}, 1e-3, EXK_OK},
    {"sine of 0 Hz", {.wave = EXK_WAVE_SINE, .order = 2}, 1e-3, EXK_OK},
    {"sigma 0", {.wave = EXK_WAVE_GAUSSIAN, .order = 1}, 1e-3, EXK_OK},
    {"negative sigma", {.wave = EXK_WAVE_GAUSSIAN, .amplitude = -1.0}, 1e-3, EXK_ERR_ARG},
    {"negative frequency", {.wave = EXK_WAVE_SINE, .freq_Hz = -1.0}, 1e-3, EXK_ERR_ARG},
    {"wave past the end", {.wave = EXK_WAVE_COUNT}, 1e-3, EXK_ERR_ARG},
    {"wave below the first", {.wave = (exk_wave)-1}, 1e-3, EXK_ERR_ARG},
    {"order 3", {.wave = EXK_WAVE_SINE, .order = 3}, 1e-3, EXK_ERR_ARG},
    {"order -1", {.wave = EXK_WAVE_SINE, .order = -1}, 1e-3, EXK_ERR_ARG},
    {"amplitude NaN", {.wave = EXK_WAVE_SINE, .amplitude = NAN}, 1e-3, EXK_ERR_ARG},
    {"amplitude Inf", {.wave = EXK_WAVE_CONSTANT, .amplitude = INFINITY}, 1e-3, EXK_ERR_ARG},
    {"sigma NaN", {.wave = EXK_WAVE_GAUSSIAN, .amplitude = NAN}, 1e-3, EXK_ERR_ARG},
    {"frequency NaN", {.wave = EXK_WAVE_SINE, .freq_Hz = NAN}, 1e-3, EXK_ERR_ARG},
    {"frequency Inf", {.wave = EXK_WAVE_SINE, .freq_Hz = INFINITY}, 1e-3, EXK_ERR_ARG},
    {"phase NaN", {.wave = EXK_WAVE_SINE, .phase_rad = NAN}, 1e-3, EXK_ERR_ARG},
    {"phase -Inf", {.wave = EXK_WAVE_SINE, .phase_rad = -INFINITY}, 1e-3, EXK_ERR_ARG},
    {"dt 0", {.wave = EXK_WAVE_SINE}, 0.0, EXK_ERR_ARG},
    {"dt negative", {.wave = EXK_WAVE_SINE}, -1e-3, EXK_ERR_ARG},
    {"dt NaN", {.wave = EXK_WAVE_SINE}, NAN, EXK_ERR_ARG},
    {"dt Inf", {.wave = EXK_WAVE_SINE}, INFINITY, EXK_ERR_ARG},
};

static void init_accepts_and_refuses_by_the_table(void)
{
    for (size_t i = 0; i < sizeof checks / sizeof *checks; i++) {
        exk_disturbance d;
        memset(&d, 0x5a, sizeof d);
        const exk_disturbance before = d;
        const exk_err err = exk_disturbance_init(&d, &checks[i].cfg, checks[i].dt_s, first, 0);
        TEST_ASSERT_EQUAL_MESSAGE(checks[i].want, err, checks[i].name);
        const int untouched = memcmp(&before, &d, sizeof d) == 0;
        TEST_ASSERT_EQUAL_MESSAGE(checks[i].want != EXK_OK, untouched, checks[i].name);
    }
}

static void the_default_is_accepted_and_adds_nothing(void)
{
    const exk_disturbance_config cfg = exk_disturbance_default();
    exk_disturbance d = start(&cfg, 1e-3, first, 0);
    double out[EXK_N_AXES] = {1.0, 2.0};
    exk_disturbance_add(&d, 1000, out);
    TEST_ASSERT_TRUE(out[EXK_ALPHA] == 1.0 && out[EXK_BETA] == 2.0);
}

static void every_wave_has_a_name_of_its_own(void)
{
    for (int i = 0; i < EXK_WAVE_COUNT; i++) {
        TEST_ASSERT_NOT_EQUAL(0, strcmp("unknown", exk_wave_name((exk_wave)i)));
        for (int j = 0; j < i; j++) {
            TEST_ASSERT_NOT_EQUAL(
                0, strcmp(exk_wave_name((exk_wave)i), exk_wave_name((exk_wave)j)));
        }
    }
    TEST_ASSERT_EQUAL_STRING("unknown", exk_wave_name(EXK_WAVE_COUNT));
    TEST_ASSERT_EQUAL_STRING("unknown", exk_wave_name((exk_wave)-1));
}

/* --- constant and sine: exact integrals ------------------------------------------------------- */

static double wave_at(const exk_disturbance_config *cfg, double t)
{
    return cfg->wave == EXK_WAVE_CONSTANT
               ? cfg->amplitude
               : cfg->amplitude * sin(2.0 * EXK_PI * cfg->freq_Hz * t + cfg->phase_rad);
}

/* The n-fold integral of w from 0 to t as one: integral of w(s) (t - s)^(n-1), n = 1 or 2, by
 * Simpson's rule on 8000 intervals. */
static double integral(const exk_disturbance_config *cfg, double t)
{
    enum { N = 8000 };
    double sum = 0.0;
    for (int i = 0; i <= N; i++) {
        const double s = t * i / N;
        const double weight = i == 0 || i == N ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        sum += weight * wave_at(cfg, s) * (cfg->order == 2 ? t - s : 1.0);
    }
    return sum * t / (3.0 * N);
}

/* Simpson's error relative to A t^order: (x/8000)^4 / (180 x) with x = 2 pi f t up to 314, 5e-11. */
static void waves_are_the_integrals_of_their_formula(void)
{
    static const double freqs_Hz[] = {0.0, 1e-6, 0.01, 0.15, 0.17, 1.0, 5.0};
    static const double phases_rad[] = {0.0, 0.5 * EXK_PI, 1.0, -2.0};
    static const int64_t ticks[] = {1, 2, 10, 500, 1000, 10000};
    const double dt_s = 1e-3;
    for (int order = 0; order <= 2; order++) {
        for (int i = 0; i < 7 * 4 * 6; i++) {
            exk_disturbance_config cfg = config(EXK_WAVE_SINE, order, 0.7);
            cfg.freq_Hz = freqs_Hz[i % 7];
            cfg.phase_rad = phases_rad[i / 7 % 4];
            const int64_t k = ticks[i / 28];
            const double t = (double)k * dt_s;
            exk_disturbance d = start(&cfg, dt_s, first, 0);
            const double want = order == 0 ? wave_at(&cfg, t) : integral(&cfg, t);
            const double scale = 0.7 * pow(t, order);
            TEST_ASSERT_DOUBLE_WITHIN(1e-10 * scale, want, value(&d, k, EXK_BETA));
        }
    }
}

static void a_constant_gives_its_powers_of_time(void)
{
    static const struct {
        int order;
        double want;
    } rows[] = {{0, -2.0}, {1, -2.0 * 1.5}, {2, -2.0 * 1.5 * 1.5 / 2.0}};
    for (size_t i = 0; i < 3; i++) {
        const exk_disturbance_config cfg = config(EXK_WAVE_CONSTANT, rows[i].order, -2.0);
        exk_disturbance d = start(&cfg, 1.0 / 1024.0, first, 0);
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, rows[i].want, value(&d, 1536, EXK_ALPHA));
    }
}

/* Orders 1 and 2 start at 0, order 2 also with rate 0: n[1] is of second order in dt. */
static void integrals_start_at_rest(void)
{
    for (int wave = EXK_WAVE_CONSTANT; wave <= EXK_WAVE_GAUSSIAN; wave++) {
        for (int order = 1; order <= 2; order++) {
            exk_disturbance_config cfg = config((exk_wave)wave, order, 1.0);
            cfg.freq_Hz = 3.0;
            cfg.phase_rad = 1.0;
            exk_disturbance d = start(&cfg, 1e-6, first, 0);
            TEST_ASSERT_TRUE(value(&d, 0, EXK_ALPHA) == 0.0);
            TEST_ASSERT_TRUE(value(&d, 0, EXK_BETA) == 0.0);
            if (order == 2) { /* gaussian: sigma is dt^1.5 / sqrt 3 = 6e-10 */
                TEST_ASSERT_DOUBLE_WITHIN(5e-9, 0.0, value(&d, 1, EXK_BETA));
            }
        }
    }
}

/* --- gaussian: the recursion, draw for draw --------------------------------------------------- */

static void gaussian_orders_follow_their_recursion(void)
{
    const double dt_s = 0.01;
    const double s = 0.3;
    const exk_stream stream = {.seed = 11, .series = 2, .run = 0, .source = 7, .channel = 1};
    exk_disturbance d[3];
    for (int order = 0; order < 3; order++) {
        const exk_disturbance_config cfg = config(EXK_WAVE_GAUSSIAN, order, s);
        d[order] = start(&cfg, dt_s, first, 7);
    }
    double n1 = 0.0;
    double n2 = 0.0;
    double rate = 0.0;
    for (int64_t k = 0; k < 100; k++) {
        double z[2];
        exk_normal_pair(&stream, k, z);
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, s * z[0], value(&d[0], k, EXK_BETA));
        TEST_ASSERT_DOUBLE_WITHIN(1e-14, n1, value(&d[1], k, EXK_BETA));
        TEST_ASSERT_DOUBLE_WITHIN(1e-14, n2, value(&d[2], k, EXK_BETA));
        TEST_ASSERT_DOUBLE_WITHIN(1e-14, rate, d[2].rate_radps[EXK_BETA]);
        n1 += s * sqrt(dt_s) * z[0];
        n2 += rate * dt_s + s * pow(dt_s, 1.5) * (0.5 * z[0] + z[1] / sqrt(12.0));
        rate += s * sqrt(dt_s) * z[0];
    }
}

/* --- ticks, channels, realisations ------------------------------------------------------------ */

static void for_every_kind(void (*check)(const exk_disturbance_config *cfg))
{
    for (int wave = EXK_WAVE_NONE; wave < EXK_WAVE_COUNT; wave++) {
        for (int order = 0; order <= 2; order++) {
            exk_disturbance_config cfg = config((exk_wave)wave, order, 0.5);
            cfg.freq_Hz = 2.0;
            cfg.phase_rad = 0.3;
            check(&cfg);
        }
    }
}

static void check_skipping(const exk_disturbance_config *cfg)
{
    exk_disturbance every = start(cfg, 1e-3, first, 0);
    exk_disturbance some = start(cfg, 1e-3, first, 0);
    for (int64_t k = 0; k <= 300; k++) {
        double a[EXK_N_AXES] = {0.0, 0.0};
        exk_disturbance_add(&every, k, a);
        if (k % 7 == 3 || k > 295) {
            TEST_ASSERT_TRUE(a[EXK_ALPHA] == value(&some, k, EXK_ALPHA));
            TEST_ASSERT_TRUE(a[EXK_BETA] == value(&some, k, EXK_BETA));
        }
    }
}

static void skipped_ticks_are_integrated(void)
{
    for_every_kind(check_skipping);
}

static void check_earlier(const exk_disturbance_config *cfg)
{
    exk_disturbance d = start(cfg, 1e-3, first, 0);
    const double at_zero = value(&d, -5, EXK_ALPHA);
    TEST_ASSERT_TRUE(at_zero == value(&d, 0, EXK_ALPHA));
    const double there = value(&d, 50, EXK_ALPHA);
    TEST_ASSERT_TRUE(there == value(&d, 50, EXK_ALPHA));
    TEST_ASSERT_TRUE(there == value(&d, 20, EXK_ALPHA));
    const double next = value(&d, 51, EXK_ALPHA);
    exk_disturbance_reset(&d);
    TEST_ASSERT_TRUE(at_zero == value(&d, 0, EXK_ALPHA));
    TEST_ASSERT_TRUE(next == value(&d, 51, EXK_ALPHA));
}

static void an_earlier_tick_gives_the_state_and_reset_begins_again(void)
{
    for_every_kind(check_earlier);
}

static void check_channels(const exk_disturbance_config *cfg)
{
    exk_disturbance both = start(cfg, 1e-3, first, 0);
    for (int axis = 0; axis < EXK_N_AXES; axis++) {
        exk_disturbance_config one = *cfg;
        one.channel[1 - axis] = false;
        exk_disturbance d = start(&one, 1e-3, first, 0);
        TEST_ASSERT_TRUE(value(&d, 40, 1 - axis) == 0.0);
        TEST_ASSERT_TRUE(value(&d, 40, axis) == value(&both, 40, axis));
    }
    const bool alike = value(&both, 40, EXK_ALPHA) == value(&both, 40, EXK_BETA);
    TEST_ASSERT_EQUAL(cfg->wave != EXK_WAVE_GAUSSIAN, alike);
}

static void channels_act_alone_and_gaussian_ones_differ(void)
{
    for_every_kind(check_channels);
}

static double last_of(bool frozen, exk_realisation which, uint8_t source, int order)
{
    exk_disturbance_config cfg = config(EXK_WAVE_GAUSSIAN, order, 1.0);
    cfg.frozen = frozen;
    exk_disturbance d = start(&cfg, 1e-3, which, source);
    return value(&d, 25, EXK_ALPHA);
}

static void frozen_repeats_over_runs_and_fresh_does_not(void)
{
    static const struct {
        const char *name;
        bool frozen;
        exk_realisation other;
        uint8_t source;
        bool alike;
    } rows[] = {
        {"frozen, another run", true, {11, 2, 9}, 0, true},
        {"fresh, another run", false, {11, 2, 9}, 0, false},
        {"fresh, the same run", false, {11, 2, 1}, 0, true},
        {"frozen, another series", true, {11, 3, 1}, 0, false},
        {"frozen, another seed", true, {12, 2, 1}, 0, false},
        {"frozen, another source", true, {11, 2, 1}, 1, false},
        {"fresh, another series", false, {11, 3, 1}, 0, false},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        for (int order = 0; order <= 2; order++) {
            const double a = last_of(rows[i].frozen, first, 0, order);
            const double b = last_of(rows[i].frozen, rows[i].other, rows[i].source, order);
            TEST_ASSERT_EQUAL_MESSAGE(rows[i].alike, a == b, rows[i].name);
        }
    }
    TEST_ASSERT_TRUE(last_of(true, first, 0, 0) != last_of(false, first, 0, 0));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(init_accepts_and_refuses_by_the_table);
    RUN_TEST(the_default_is_accepted_and_adds_nothing);
    RUN_TEST(every_wave_has_a_name_of_its_own);
    RUN_TEST(waves_are_the_integrals_of_their_formula);
    RUN_TEST(a_constant_gives_its_powers_of_time);
    RUN_TEST(integrals_start_at_rest);
    RUN_TEST(gaussian_orders_follow_their_recursion);
    RUN_TEST(skipped_ticks_are_integrated);
    RUN_TEST(an_earlier_tick_gives_the_state_and_reset_begins_again);
    RUN_TEST(channels_act_alone_and_gaussian_ones_differ);
    RUN_TEST(frozen_repeats_over_runs_and_fresh_does_not);
    return UNITY_END();
}
