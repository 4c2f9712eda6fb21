#include <math.h>
#include <string.h>

#include "report.h"
#include "unity.h"

enum { N_HOLES = 3, PER_HOLE = 4, N_SAMPLES = N_HOLES * PER_HOLE };

static exk_hole holes[N_HOLES];
static exk_sample samples[N_SAMPLES];
static exk_run_log run;
static hole_report report;
static char why[512];

/* Each hole: travel, dwell, dwell (judged), drill. Errors 10, 20, 30 um in x, half of it estimated. */
void setUp(void)
{
    exk_run_log_init(&run);
    for (int i = 0; i < N_SAMPLES; i++) {
        static const exk_phase phases[PER_HOLE] = {EXK_PHASE_TRAVEL, EXK_PHASE_DWELL,
                                                   EXK_PHASE_DWELL, EXK_PHASE_DRILL};
        const int32_t h = i / PER_HOLE;
        exk_sample *s = &samples[i];
        holes[h] = (exk_hole){.id = 7 + h, .target_m = {0.1 * h, 0.0, 0.5}, .axis = {0, 0, 1}};
        *s = (exk_sample){.k = i, .hole = h, .phase = phases[i % PER_HOLE], .has_true = true};
        s->judged = i % PER_HOLE == 2;
        s->ref = (exk_tool){{0.1 * h, 0.0, 0.5}, {0, 0, 1}};
        s->real = s->est = s->ref;
        s->real.tip_m[0] += 10e-6 * (h + 1);
        s->est.tip_m[0] += 5e-6 * (h + 1);
    }
    run.has_job = true;
    run.tolerance_m = 25e-6;
    run.holes = holes;
    run.n_holes = N_HOLES;
    run.samples = samples;
    run.n_samples = N_SAMPLES;
    strcpy(run.profile_name, "made_up");
}

void tearDown(void)
{
    hole_report_free(&report);
}

static int make(double tolerance_m)
{
    return hole_report_make(&report, &run, "made.lcm", tolerance_m, why, sizeof why);
}

static void the_true_tip_is_judged_where_the_log_has_it(void)
{
    TEST_ASSERT_EQUAL(0, make(0.0));
    TEST_ASSERT_TRUE(report.on_true);
    TEST_ASSERT_EQUAL_size_t(2, report.accuracy.n_inside);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 20e-6, report.accuracy.mean_m);
    TEST_ASSERT_EQUAL_INT32(2, report.accuracy.worst);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 2.0 / 3.0, report.correct_rate);
    TEST_ASSERT_EQUAL_INT64(6, report.results[1].k);
    TEST_ASSERT_EQUAL_size_t(0, report.n_early);
    TEST_ASSERT_FALSE(hole_report_good(&report));
}

static void one_sample_without_truth_and_the_estimate_is_judged(void)
{
    samples[0].has_true = false;
    TEST_ASSERT_EQUAL(0, make(0.0));
    TEST_ASSERT_FALSE(report.on_true);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 10e-6, report.accuracy.mean_m);
    TEST_ASSERT_TRUE(hole_report_good(&report));
}

static void a_tolerance_asked_for_takes_the_place_of_the_jobs(void)
{
    TEST_ASSERT_EQUAL(0, make(31e-6));
    TEST_ASSERT_EQUAL_size_t(3, report.accuracy.n_inside);
    TEST_ASSERT_TRUE(hole_report_good(&report));
}

static void lost_samples_are_no_good_result(void)
{
    run.n_lost = 1;
    TEST_ASSERT_EQUAL(0, make(31e-6));
    TEST_ASSERT_FALSE(hole_report_good(&report));
    hole_report_free(&report);
    run.n_lost = 0;
    run.n_before = 4;
    TEST_ASSERT_EQUAL(0, make(31e-6));
    TEST_ASSERT_EQUAL_INT64(4, report.n_lost);
    TEST_ASSERT_FALSE(hole_report_good(&report));
}

static void a_run_cut_in_the_dwell_has_not_drilled_that_hole(void)
{
    run.n_samples = 2 * PER_HOLE + 2; /* the third hole's first dwell sample is the last one */
    TEST_ASSERT_EQUAL(0, make(0.0));
    TEST_ASSERT_EQUAL_size_t(2, report.accuracy.n_drilled);
    TEST_ASSERT_FALSE(report.results[2].drilled);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 2.0 / 3.0, report.correct_rate);
}

static void a_run_cut_right_after_the_judged_sample_has(void)
{
    run.n_samples = 2 * PER_HOLE + 3;
    TEST_ASSERT_EQUAL(0, make(0.0));
    TEST_ASSERT_EQUAL_size_t(3, report.accuracy.n_drilled);
}

static void a_missing_judged_sample_is_counted(void)
{
    samples[2] = samples[1]; /* the last of the first dwell never came */
    TEST_ASSERT_EQUAL(0, make(0.0));
    TEST_ASSERT_EQUAL_size_t(1, report.n_early);
    TEST_ASSERT_EQUAL_size_t(3, report.accuracy.n_drilled);
}

/* sigma = sqrt((100 + 400 + 900) / 6) um */
static void the_figures_are_those_of_the_statistics(void)
{
    TEST_ASSERT_EQUAL(0, make(0.0));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1e-6 * sqrt(1400.0 / 6.0), report.sigma_m);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 20e-6, report.pose.ap);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, exk_rayleigh_ppk(25e-6, report.sigma_m), report.ppk);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, exk_wilson(2, 3, 0.95).low, report.wilson.low);
    TEST_ASSERT_EQUAL_STRING("unknown", report.noise); /* no profile text in this log */
}

static void a_log_that_cannot_be_judged_says_why(void)
{
    run.has_job = false;
    TEST_ASSERT_EQUAL(2, make(0.0));
    TEST_ASSERT_EQUAL_STRING(
        "made.lcm: no EXK_JOB message, so the targets are not known: record "
        "for more than a second, the job is sent every second",
        why);
    run.has_job = true;
    run.tolerance_m = NAN;
    TEST_ASSERT_EQUAL(2, make(0.0));
    TEST_ASSERT_EQUAL_STRING(
        "made.lcm: the job in the log cannot be judged: no hole, or a target, "
        "an axis or the tolerance is not valid",
        why);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_true_tip_is_judged_where_the_log_has_it);
    RUN_TEST(one_sample_without_truth_and_the_estimate_is_judged);
    RUN_TEST(a_tolerance_asked_for_takes_the_place_of_the_jobs);
    RUN_TEST(lost_samples_are_no_good_result);
    RUN_TEST(a_run_cut_in_the_dwell_has_not_drilled_that_hole);
    RUN_TEST(a_run_cut_right_after_the_judged_sample_has);
    RUN_TEST(a_missing_judged_sample_is_counted);
    RUN_TEST(the_figures_are_those_of_the_statistics);
    RUN_TEST(a_log_that_cannot_be_judged_says_why);
    return UNITY_END();
}
