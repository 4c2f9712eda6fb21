#define _POSIX_C_SOURCE 200809L
/* One seed of the study is what exk-loop --fast records for that profile, to the last bit: the same rooms,
 * no second implementation. Untrained, with feedback, trained, and on the 25 holes. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "exk/log.h"
#include "experiments.h"
#include "task.h"
#include "unity.h"

static const char folder[] = EXK_SOURCE_DIR "/profiles/study";
static char work[] = "study_one_seed_XXXXXX";

typedef struct {
    const exk_run_log *log;
    size_t n_seen;
    size_t n_differ;
} comparison;

void setUp(void)
{
}

void tearDown(void)
{
}

static bool same(const double *a, const double *b, size_t n)
{
    return memcmp(a, b, n * sizeof *a) == 0;
}

static void compare(void *ctx, const exk_sample *sample)
{
    comparison *c = ctx;
    const size_t i = c->n_seen++;
    if (i >= c->log->n_samples) {
        return;
    }
    const exk_sample *logged = &c->log->samples[i];
    c->n_differ += sample->k != logged->k || !same(sample->real.tip_m, logged->real.tip_m, 3) ||
                   !same(sample->ref.tip_m, logged->ref.tip_m, 3) ||
                   !same(sample->theta_rad, logged->theta_rad, EXK_N_AXES) ||
                   !same(sample->m_rad, logged->m_rad, EXK_N_AXES) ||
                   !same(sample->c_rad, logged->c_rad, EXK_N_AXES) ||
                   !same(sample->u_rad, logged->u_rad, EXK_N_AXES);
}

static void shell(const char *command)
{
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, system(command), command);
}

/* Records run p of a series with the programs: trained by exk-ilc, run by exk-loop. */
static void record(study_experiment which, uint32_t series, int run, exk_run_log *log)
{
    const char *name = study_experiment_at(which)->name;
    char command[2048];
    char path[256];
    char why[512];
    char stored[256] = "";
    if (run > 1) {
        snprintf(command, sizeof command,
                 EXK_BIN_DIR "/exk-ilc train %s/%s.ini -n %d --series %" PRIu32
                             " -o %s/store.ilc > %s/out",
                 folder, name, run - 1, series, work, work);
        shell(command);
        snprintf(stored, sizeof stored, "--ilc %s/store.ilc", work);
    }
    snprintf(path, sizeof path, "%s/run.lcm", work);
    snprintf(command, sizeof command,
             EXK_BIN_DIR "/exk-loop %s/%s.ini --fast --quiet --series %" PRIu32
                         " --run %d %s --record %s > %s/out",
             folder, name, series, run, stored, path, work);
    remove(path);
    shell(command);
    exk_run_log_init(log);
    TEST_ASSERT_TRUE_MESSAGE(exk_run_log_read(log, path, why, sizeof why), why);
}

/* The brief run of the study against the sampled one before it. */
static void check_brief(study_lab *lab, uint32_t trial, int run)
{
    exk_series *series = &lab->series;
    const size_t n_bytes = series->n * sizeof(double);
    const size_t n_holes = lab->rig->n_holes * sizeof *series->results;
    double *e_rad = malloc(n_bytes);
    exk_hole_result *results = malloc(n_holes);
    exk_accuracy accuracy;
    memcpy(e_rad, series->e_rad[EXK_BETA], n_bytes);
    memcpy(results, series->results, n_holes);
    memset(series->e_rad[EXK_BETA], 0, n_bytes);
    series->on_sample = NULL;
    TEST_ASSERT_EQUAL_INT(STUDY_GOOD, study_lab_run(lab, trial, run, &accuracy));
    TEST_ASSERT_NOT_NULL_MESSAGE(series->way, "the run was not brief");
    TEST_ASSERT_EQUAL_MEMORY(e_rad, series->e_rad[EXK_BETA], n_bytes);
    TEST_ASSERT_EQUAL_MEMORY(results, series->results, n_holes);
    free(e_rad);
    free(results);
}

static void check(study_experiment which, uint32_t trial)
{
    const study_variant as_published = study_as_published();
    const int n_runs = study_experiment_at(which)->n_runs;
    exk_run_log log;
    exk_accuracy accuracy;
    study_lab lab;
    record(which, trial, n_runs, &log);
    TEST_ASSERT_EQUAL_INT(STUDY_GOOD, study_lab_open(&lab, folder, which, &as_published));
    TEST_ASSERT_EQUAL_INT(STUDY_GOOD, study_lab_trial(&lab, trial, &accuracy));
    comparison c = {.log = &log};
    lab.series.on_sample = compare;
    lab.series.sample_ctx = &c;
    TEST_ASSERT_EQUAL_INT(STUDY_GOOD, study_lab_run(&lab, trial, n_runs, &accuracy));
    TEST_ASSERT_EQUAL_UINT64(log.n_samples, c.n_seen);
    TEST_ASSERT_EQUAL_UINT64(lab.series.n, c.n_seen);
    TEST_ASSERT_EQUAL_UINT64(0, c.n_differ);
    check_brief(&lab, trial, n_runs);
    study_lab_close(&lab);
    exk_run_log_free(&log);
}

static void enlarged_sine_of_trial_0(void)
{
    check(STUDY_S1_BOTH, 0); /* later trials turn its phase */
}

static void enlarged_walk_of_trial_3(void)
{
    check(STUDY_S2_BOTH, 3);
}

static void trained_series_of_trial_7(void)
{
    check(STUDY_S5, 7);
}

static void feedback_of_trial_7(void)
{
    check(STUDY_S6, 7);
}

static void holes_of_trial_1(void)
{
    check(STUDY_S7, 1);
}

int main(void)
{
    if (mkdtemp(work) == NULL) {
        return EXIT_FAILURE;
    }
    UNITY_BEGIN();
    RUN_TEST(enlarged_sine_of_trial_0);
    RUN_TEST(enlarged_walk_of_trial_3);
    RUN_TEST(trained_series_of_trial_7);
    RUN_TEST(feedback_of_trial_7);
    RUN_TEST(holes_of_trial_1);
    char command[64];
    snprintf(command, sizeof command, "rm -r %s", work);
    return UNITY_END() + (system(command) == 0 ? 0 : 1);
}
