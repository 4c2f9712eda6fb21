#include "exk/profile.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "exk/job_csv.h"
#include "exk/random.h"
#include "exk/units.h"
#include "unity.h"

enum { MAX_FAULTS = 8, TEXT_SIZE = 8192 };

#define START "[kinematics]\nmodel = pendulum\n[job]\nkind = rectangle\n"

static exk_fault faults[MAX_FAULTS];
static char text[TEXT_SIZE];
static char again[TEXT_SIZE];

void setUp(void)
{
}

void tearDown(void)
{
    setlocale(LC_NUMERIC, "C");
}

static exk_profile parse(const char *source)
{
    exk_profile profile;
    size_t n = 0;
    const exk_err err = exk_profile_parse(source, &profile, faults, MAX_FAULTS, &n);
    TEST_ASSERT_EQUAL_MESSAGE(EXK_OK, err, n > 0 ? faults[0].message : "");
    TEST_ASSERT_EQUAL_UINT(0, n);
    return profile;
}

static const char *print(const exk_profile *profile, char out[TEXT_SIZE])
{
    TEST_ASSERT_TRUE(exk_profile_print(profile, out, TEXT_SIZE) < TEXT_SIZE);
    return out;
}

/* Bits, not values: 0 and -0 differ. */
static void same_bits(double want, double is)
{
    TEST_ASSERT_EQUAL_HEX64_ARRAY(&want, &is, 1);
}

static void what_is_left_out_has_its_default(void)
{
    const exk_profile p = parse(START);
    const exk_profile d = exk_profile_default();
    TEST_ASSERT_EQUAL_STRING(print(&d, again), print(&p, text));
    TEST_ASSERT_EQUAL_STRING("", p.name);
    TEST_ASSERT_EQUAL_UINT(0, p.twin.n_disturbances);
    same_bits(0.95, p.job.pattern.center_m[EXK_Z]);
    same_bits(3e-5, p.job.tolerance_m);
    same_bits(35.0 * EXK_RAD_PER_DEG, p.geometry.angle_max_rad);
}

static void values_come_in_si_to_the_last_bit(void)
{
    const exk_profile p = parse(
        "[machine]\nd1_mm = 901.3\nangle_max_deg = 60\nf_mm = -12.7\nwrist = CA\nservo_tau_s = "
        ".002\n[kinematics]\nmodel = machine\n[job]\nkind = grid\nwidth_mm = 1e2\nrows = 3\n"
        "columns = 7\ncenter_x_mm = +4.1\norder = serpentine\nrow_gap_mm = 0.3\nclosed = no\n"
        "feed_mmps = 123.456\naccel_mmps2 = inf\n[sensor]\nsigma_rad = 2e-6\nrepeat = frozen\n"
        "[control]\nfeedback = none\nc_max_mrad = 7\nilc_lead = 3\n[loop]\nrate_Hz = "
        "2000\nseed = "
        "18446744073709551615\nspin_us = 30\ncpu = -1\n[telemetry]\nurl = "
        "file:///x?a=b:c\nevery = "
        "10\n");
    same_bits(0.9013, p.geometry.d1_m);
    same_bits(60.0 * EXK_RAD_PER_DEG, p.geometry.angle_max_rad);
    same_bits(-0.0127, p.geometry.f_m);
    same_bits(0.002, p.twin.servo_tau_s);
    same_bits(0.1, p.job.pattern.width_m);
    same_bits(0.0041, p.job.pattern.center_m[EXK_X]);
    same_bits(0.95 + (0.2 + 0.3), p.job.pattern.center_m[EXK_Z]);
    same_bits(0.123456, p.job.plan.feed_mps);
    same_bits(30e-6, p.timing.spin_s);
    same_bits(7e-3, p.feedback.pid.c_max_rad);
    TEST_ASSERT_TRUE(isinf(p.job.plan.accel_mps2));
    TEST_ASSERT_EQUAL(EXK_WRIST_CA, p.wrist);
    TEST_ASSERT_EQUAL(EXK_KIN_MACHINE, p.model);
    TEST_ASSERT_EQUAL(EXK_JOB_GRID, p.job.kind);
    TEST_ASSERT_EQUAL(EXK_ORDER_SERPENTINE, p.job.order);
    TEST_ASSERT_EQUAL(EXK_FEEDBACK_NONE, p.feedback.kind);
    TEST_ASSERT_EQUAL_INT(7, p.job.pattern.columns);
    TEST_ASSERT_EQUAL_INT(3, p.ilc.lead);
    TEST_ASSERT_EQUAL_INT(-1, p.timing.cpu);
    TEST_ASSERT_EQUAL_INT(10, p.telemetry.every);
    TEST_ASSERT_EQUAL_UINT64(UINT64_MAX, p.timing.seed);
    TEST_ASSERT_FALSE(p.job.plan.closed);
    TEST_ASSERT_TRUE(p.twin.sensor_frozen);
    TEST_ASSERT_EQUAL_STRING("file:///x?a=b:c", p.telemetry.url);
}

static void the_sample_time_reaches_every_room(void)
{
    const exk_profile p = parse(START "[loop]\nrate_Hz = 2500\n");
    same_bits(1.0 / 2500.0, p.timing.dt_s);
    same_bits(1.0 / 2500.0, p.job.plan.dt_s);
    same_bits(1.0 / 2500.0, p.twin.dt_s);
    same_bits(1.0 / 2500.0, p.feedback.pid.dt_s);
    same_bits(1.0 / 2500.0, p.ilc.dt_s);
}

static void disturbances_stand_at_their_number(void)
{
    const exk_profile p = parse(
        START "[disturbance.3]\nwave = gaussian\norder = 2\nchannel = beta\n"
              "sigma_rad_per_s_sqrt_s = 4e-5\nrepeat = fresh\n[disturbance.1]\nwave = sine\n"
              "amplitude_rad = 0.1\nfreq_Hz = 2\nphase_deg = 90\nchannel = alpha\n");
    const exk_disturbance_config *d = p.twin.disturbance;
    TEST_ASSERT_EQUAL_UINT(3, p.twin.n_disturbances);
    TEST_ASSERT_EQUAL(EXK_WAVE_SINE, d[0].wave);
    TEST_ASSERT_EQUAL(EXK_WAVE_NONE, d[1].wave);
    TEST_ASSERT_EQUAL(EXK_WAVE_GAUSSIAN, d[2].wave);
    TEST_ASSERT_TRUE(d[0].channel[EXK_ALPHA] && !d[0].channel[EXK_BETA]);
    TEST_ASSERT_TRUE(!d[2].channel[EXK_ALPHA] && d[2].channel[EXK_BETA]);
    TEST_ASSERT_TRUE(d[0].frozen && !d[2].frozen);
    same_bits(4e-5, d[2].amplitude);
    same_bits(90.0 * EXK_RAD_PER_DEG, d[0].phase_rad);
}

static void comments_blanks_and_line_ends_do_not_matter(void)
{
    const exk_profile p =
        parse("\xef\xbb\xbf; mark\r\n\r\n  [kinematics]  ; why\r\n\tmodel=universal"
              " ; inline\r\n#x\r\n[job] # y\r\n    kind = rectangle\r\n        "
              "width_mm: 100\r\n   height_mm =90   \r\n[loop]\r\nseed = 7");
    TEST_ASSERT_EQUAL(EXK_KIN_UNIVERSAL, p.model);
    same_bits(0.1, p.job.pattern.width_m);
    same_bits(0.09, p.job.pattern.height_m);
    TEST_ASSERT_EQUAL_UINT64(7, p.timing.seed);
}

/* Exactly the longest line: 198 characters. */
static void the_longest_line_is_read(void)
{
    snprintf(text, sizeof(text), START "width_mm = %0187d\n", 5);
    const exk_profile p = parse(text);
    same_bits(0.005, p.job.pattern.width_m);
}

/* A double of any size that a key takes, from random bits. */
static double any_double(const exk_stream *stream, int64_t k, double largest)
{
    double z[2];
    exk_normal_pair(stream, k, z);
    const double value = fabs(z[0]) * pow(10.0, 4.0 * z[1]);
    return fmin(fmax(value, 1e-12), largest);
}

static void print_reads_back_to_the_same_bits(void)
{
    const exk_stream stream = {.seed = 4711};
    for (int64_t i = 0; i < 400; i++) {
        exk_profile p =
            parse(START "[disturbance.1]\nwave = sine\nfreq_Hz = 1\namplitude_rad = 1\n");
        double *const fields[] = {&p.job.plan.feed_mps,
                                  &p.job.plan.accel_mps2,
                                  &p.job.plan.dwell_s,
                                  &p.job.tolerance_m,
                                  &p.job.pattern.width_m,
                                  &p.job.pattern.center_m[EXK_Y],
                                  &p.job.pattern.center_m[2],
                                  &p.twin.servo_tau_s,
                                  &p.twin.sensor_quantum_rad,
                                  &p.feedback.pid.c_max_rad,
                                  &p.twin.disturbance[0].amplitude,
                                  &p.twin.disturbance[0].phase_rad,
                                  &p.geometry.angle_max_rad};
        const size_t n_fields = sizeof(fields) / sizeof(fields[0]);
        for (size_t f = 0; f < n_fields; f++) {
            const double largest = f + 1 == n_fields ? 1.0 : 1e9;
            *fields[f] = any_double(&stream, i * (int64_t)n_fields + (int64_t)f, largest);
        }
        const exk_profile q = parse(print(&p, text));
        for (size_t f = 0; f < n_fields; f++) {
            double back;
            memcpy(&back, (const char *)&q + ((const char *)fields[f] - (const char *)&p),
                   sizeof(back));
            same_bits(*fields[f], back);
        }
        TEST_ASSERT_EQUAL_STRING(text, print(&q, again));
    }
}

static void the_shortest_text_is_printed(void)
{
    const exk_profile p =
        parse(START "tolerance_mm = 0.030\nfeed_mmps = 1.0e2\ndwell_s = 1e-7\n"
                    "accel_mmps2 = 1e20\nstroke_mm = 12.50\n");
    print(&p, text);
    TEST_ASSERT_NOT_NULL(strstr(text, "\ntolerance_mm = 0.03\n"));
    TEST_ASSERT_NOT_NULL(strstr(text, "\nfeed_mmps = 100\n"));
    TEST_ASSERT_NOT_NULL(strstr(text, "\ndwell_s = 1e-7\n"));
    TEST_ASSERT_NOT_NULL(strstr(text, "\naccel_mmps2 = 1e20\n"));
    TEST_ASSERT_NOT_NULL(strstr(text, "\nstroke_mm = 12.5\n"));
    TEST_ASSERT_NOT_NULL(strstr(text, "\nangle_max_deg = 35\n"));
}

static void print_says_how_long_it_would_be(void)
{
    const exk_profile p = exk_profile_default();
    char little[10];
    const size_t length = exk_profile_print(&p, text, sizeof(text));
    TEST_ASSERT_EQUAL_UINT(strlen(text), length);
    TEST_ASSERT_EQUAL_UINT(length, exk_profile_print(&p, NULL, 0));
    TEST_ASSERT_EQUAL_UINT(length, exk_profile_print(&p, little, sizeof(little)));
    TEST_ASSERT_EQUAL_STRING_LEN(text, little, sizeof(little) - 1);
    TEST_ASSERT_EQUAL_CHAR('\0', little[sizeof(little) - 1]);
}

static const char *job_text(const exk_profile *p, const exk_hole *holes, char out[TEXT_SIZE])
{
    TEST_ASSERT_TRUE(exk_profile_job_text(p, holes, 2, out, TEXT_SIZE) < TEXT_SIZE);
    return out;
}

static void the_job_text_knows_what_learning_depends_on(void)
{
    const exk_hole holes[] = {{1, {0.1, 0.2, 0.95}, {0, 0, 1}},
                              {2, {0.3, 0.2, 0.95}, {0, 0, 1}}};
    const exk_profile base = parse(START);
    job_text(&base, holes, text);
    TEST_ASSERT_NOT_NULL(strstr(text, "\ndt_s = 0.001\nhole = 1, 0.1, 0.2, 0.95, 0, 0, 1\n"));
    exk_profile same =
        parse(START "[sensor]\nsigma_rad = 1e-6\n[control]\nki_per_s = 3\n[loop]\n"
                    "seed = 9\n[telemetry]\nevery = 2\n[disturbance.1]\nwave = "
                    "constant\namplitude_rad = 1\n");
    snprintf(same.name, sizeof(same.name), "other");
    snprintf(same.job.file, sizeof(same.job.file), "elsewhere.csv");
    TEST_ASSERT_EQUAL_STRING(text, job_text(&same, holes, again));
}

static void the_job_text_shows_every_change_of_the_job(void)
{
    static const char *const changes[] = {
        "feed_mmps = 101\n",
        "tolerance_mm = 0.031\n",
        "[machine]\nservo_tau_s = 0.001\n",
        "closed = no\n",
        "[machine]\nangle_max_deg = 34\n",
        "[loop]\nrate_Hz = 1001\n",
    };
    exk_hole holes[] = {{1, {0.1, 0.2, 0.95}, {0, 0, 1}}, {2, {0.3, 0.2, 0.95}, {0, 0, 1}}};
    const exk_profile base = parse(START);
    job_text(&base, holes, text);
    for (size_t i = 0; i < sizeof(changes) / sizeof(changes[0]); i++) {
        char source[256];
        snprintf(source, sizeof(source), "%s%s", START, changes[i]);
        const exk_profile other = parse(source);
        TEST_ASSERT_NOT_EQUAL_MESSAGE(0, strcmp(text, job_text(&other, holes, again)),
                                      changes[i]);
    }
    holes[1].target_m[EXK_Y] = nextafter(0.2, 1.0);
    TEST_ASSERT_NOT_EQUAL(0, strcmp(text, job_text(&base, holes, again)));
}

static void a_decimal_comma_in_the_locale_changes_nothing(void)
{
    static const char *const locales[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8",
                                          "nl_NL.UTF-8"};
    const exk_profile p = parse(START "width_mm = 100.25\n");
    print(&p, text);
    for (size_t i = 0; i < sizeof(locales) / sizeof(locales[0]); i++) {
        if (setlocale(LC_NUMERIC, locales[i]) != NULL) {
            const exk_profile q = parse(START "width_mm = 100.25\n");
            same_bits(0.10025, q.job.pattern.width_m);
            TEST_ASSERT_EQUAL_STRING(text, print(&q, again));
            return;
        }
    }
    TEST_IGNORE_MESSAGE("no locale with a decimal comma is installed here");
}

/* The words of the table stand for the values of the rooms' own enums. */
static void the_words_are_those_of_the_rooms(void)
{
    char source[256];
    for (int i = 0; i < EXK_KIN_COUNT; i++) {
        snprintf(source, sizeof(source), "[kinematics]\nmodel = %s\n[job]\nkind = grid\n",
                 exk_kin_name((exk_kin_model)i));
        TEST_ASSERT_EQUAL(i, parse(source).model);
    }
    for (int i = 0; i < EXK_FEEDBACK_COUNT; i++) {
        snprintf(source, sizeof(source), START "[control]\nfeedback = %s\n",
                 exk_feedback_name((exk_feedback_kind)i));
        TEST_ASSERT_EQUAL(i, parse(source).feedback.kind);
    }
    for (int i = 0; i < EXK_WAVE_COUNT; i++) {
        static const char *const amplitudes[] = {
            "", "amplitude_rad = 1", "amplitude_rad = 1\nfreq_Hz = 1", "sigma_rad = 1"};
        snprintf(source, sizeof(source), START "[disturbance.1]\nwave = %s\n%s\n",
                 exk_wave_name((exk_wave)i), amplitudes[i]);
        TEST_ASSERT_EQUAL(i, parse(source).twin.disturbance[0].wave);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(what_is_left_out_has_its_default);
    RUN_TEST(values_come_in_si_to_the_last_bit);
    RUN_TEST(the_sample_time_reaches_every_room);
    RUN_TEST(disturbances_stand_at_their_number);
    RUN_TEST(comments_blanks_and_line_ends_do_not_matter);
    RUN_TEST(the_longest_line_is_read);
    RUN_TEST(print_reads_back_to_the_same_bits);
    RUN_TEST(the_shortest_text_is_printed);
    RUN_TEST(print_says_how_long_it_would_be);
    RUN_TEST(the_job_text_knows_what_learning_depends_on);
    RUN_TEST(the_job_text_shows_every_change_of_the_job);
    RUN_TEST(a_decimal_comma_in_the_locale_changes_nothing);
    RUN_TEST(the_words_are_those_of_the_rooms);
    return UNITY_END();
}
