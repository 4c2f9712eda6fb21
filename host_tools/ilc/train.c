#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "exk/fault_text.h"
#include "exk/plural.h"
#include "exk/progress_line.h"
#include "exk/series.h"
#include "exk/stop_signal.h"
#include "exk/store.h"
#include "exk/units.h"
#include "ilc_tool.h"
#include "json_file.h"
#include "noise_word.h"

typedef struct {
    const ilc_options *options;
    exk_rig rig;
    exk_series series;
    json_t *rows; /* NULL: a table */
    uint32_t p;   /* the next run */
    bool progress;
} training;

/* A table on the terminal is progress enough; rows that go elsewhere, or come at the end, are not. */
static void show_progress(const training *t)
{
    if (t->progress) {
        exk_progress_show("exk-ilc: run %" PRIu32 " of %" PRIu32, t->p, t->options->n_runs);
    }
}

static void end_progress(const training *t)
{
    if (t->progress) {
        exk_progress_clear();
    }
}

static void tell(training *t, const exk_accuracy *accuracy)
{
    const double last_mm = accuracy->last_point_m * EXK_MM_PER_M;
    const double mean_mm = accuracy->mean_m * EXK_MM_PER_M;
    const double rms_mm = accuracy->rms_path_m * EXK_MM_PER_M;
    if (t->rows == NULL) {
        printf("%9" PRIu32 "  %13.6f  %12.6f  %9.6f  %4zu of %zu\n", t->p, last_mm, mean_mm,
               rms_mm, accuracy->n_inside, t->rig.n_holes);
        fflush(stdout);
        return;
    }
    json_array_append_new(t->rows,
                          json_pack("{s:I, s:f, s:f, s:f, s:I}", "iteration", (json_int_t)t->p,
                                    "last_point_mm", last_mm, "mean_hole_mm", mean_mm, "rms_mm",
                                    rms_mm, "n_inside", (json_int_t)accuracy->n_inside));
}

static int run_failed(const training *t, exk_err err)
{
    char text[EXK_FAULT_TEXT_MAX];
    const exk_loop *loop = &t->rig.loop;
    if (loop->fault != EXK_OK) {
        exk_fault_text(&loop->report, text, sizeof text);
    } else {
        snprintf(text, sizeof text, "%s", exk_err_name(err));
    }
    fprintf(stderr, "exk-ilc: run %" PRIu32 " ended by fault: %s\n", t->p, text);
    return ILC_MISSED;
}

/* One run, its line, one update. */
static int iterate(training *t, double *last_mm)
{
    exk_accuracy accuracy;
    const exk_realisation which = {
        .seed = t->rig.profile.timing.seed, .series = t->options->series, .run = t->p};
    show_progress(t);
    exk_err err = exk_series_run(&t->series, which, &accuracy);
    end_progress(t);
    if (err != EXK_OK) {
        return run_failed(t, err);
    }
    tell(t, &accuracy);
    *last_mm = accuracy.last_point_m * EXK_MM_PER_M;
    if (t->series.n_bad > 0 && !t->options->allow_bad) {
        fprintf(stderr,
                "exk-ilc: run %" PRIu32 " had %" PRId64
                " rejected sensor sample%s: nothing is learned from "
                "it; --allow-bad learns all the same\n",
                t->p, t->series.n_bad, exk_plural_s(t->series.n_bad));
        return ILC_INPUT;
    }
    err = exk_series_learn(&t->series);
    if (err != EXK_OK) {
        fprintf(stderr, "exk-ilc: the update of run %" PRIu32 " is refused: %s\n", t->p,
                exk_err_name(err));
        return ILC_INPUT;
    }
    t->p++;
    return ILC_GOOD;
}

static int say_stopped(const training *t)
{
    fprintf(stderr, "exk-ilc: stopped by %s after run %" PRIu32 " of %" PRIu32 "\n",
            strsignal(exk_stop_signal()), t->p - 1, t->options->n_runs);
    return ILC_MISSED;
}

static int run_series(training *t)
{
    double last_mm = 0.0;
    int code = ILC_GOOD;
    const double until_mm = t->options->until_mm;
    bool reached = false;
    while (code == ILC_GOOD && t->p <= t->options->n_runs && !reached &&
           exk_stop_signal() == 0) {
        code = iterate(t, &last_mm);
        reached = until_mm > 0.0 && last_mm < until_mm;
    }
    if (code == ILC_GOOD && exk_stop_signal() != 0 && t->p <= t->options->n_runs && !reached) {
        return say_stopped(t);
    }
    if (code == ILC_GOOD && until_mm > 0.0 && !reached) {
        fprintf(stderr, "exk-ilc: %g mm was not reached in %" PRIu32 " runs: %g mm\n", until_mm,
                t->options->n_runs, last_mm);
        code = ILC_MISSED;
    }
    return code;
}

static int save(const training *t)
{
    char why[512];
    const exk_store store = {.job_hash = t->rig.job_hash,
                             .dt_s = t->rig.plan.cfg.dt_s,
                             .iteration = t->p,
                             .n_samples = t->series.n,
                             .u_rad = {t->series.u_rad[0], t->series.u_rad[1]}};
    if (t->options->output == NULL) {
        return ILC_GOOD;
    }
    const exk_store_err err = exk_store_save(t->options->output, &store, why, sizeof why);
    if (err != EXK_STORE_OK) {
        fprintf(stderr, "exk-ilc: %s\n", why);
        return err == EXK_STORE_IO ? ILC_IO : ILC_INPUT;
    }
    fprintf(stderr, "exk-ilc: %s holds the correction for run %" PRIu32 "\n",
            t->options->output, t->p);
    return ILC_GOOD;
}

static int print_json(training *t)
{
    char why[512];
    json_t *root =
        json_pack("{s:s, s:s, s:f, s:f, s:o}", "profile", t->rig.profile.name, "noise",
                  exk_noise_word(&t->rig.profile), "ilc_gain", t->rig.profile.ilc.gain, "dt_s",
                  t->rig.plan.cfg.dt_s, "iterations", t->rows);
    const int code = exk_json_write(root, "-", "profile", why, sizeof why);
    json_decref(root);
    if (code != ILC_GOOD) {
        fprintf(stderr, "exk-ilc: %s\n", why);
    }
    return code;
}

static int train_open(training *t)
{
    if (!exk_series_open(&t->series, &t->rig)) {
        fprintf(stderr, "exk-ilc: out of memory for %" PRId64 " ticks\n", t->rig.plan.n_ticks);
        return ILC_IO;
    }
    if (t->options->json) {
        t->rows = json_array();
    } else {
        printf("%s, %s noise, gain %g\n", t->rig.profile.name, exk_noise_word(&t->rig.profile),
               t->rig.profile.ilc.gain);
        printf("iteration  last_point_mm  mean_hole_mm     rms_mm  inside\n");
    }
    int code = run_series(t);
    if (t->rows != NULL) {
        const int printed = print_json(t);
        code = code != ILC_GOOD ? code : printed;
    }
    const int saved = t->p > 1 ? save(t) : ILC_GOOD; /* whatever ended the series */
    exk_series_close(&t->series);
    return saved != ILC_GOOD ? saved : code;
}

int ilc_train(const ilc_options *options)
{
    training t = {.options = options,
                  .p = 1,
                  .progress =
                      exk_progress_wanted() && (options->json || isatty(STDOUT_FILENO) != 1)};
    /* A run takes a moment: the one under way ends, and what was learned so far is kept. */
    exk_stop_catch();
    int code = exk_rig_open(&t.rig, options->input);
    if (code == ILC_GOOD && t.rig.from == EXK_FROM_BUS) {
        fprintf(stderr,
                "exk-ilc: %s: source = bus in [loop]: a series is trained on a twin in this "
                "process; take source = twin, or learn from logs: exk-loop -r, exk-ilc learn\n",
                options->input);
        exk_rig_close(&t.rig);
        return ILC_INPUT;
    }
    if (code == ILC_GOOD) {
        code = train_open(&t);
        exk_rig_close(&t.rig);
    }
    return code;
}
