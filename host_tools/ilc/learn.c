#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "exk/log.h"
#include "exk/plural.h"
#include "exk/series.h"
#include "exk/store.h"
#include "ilc_tool.h"

static const double missing_max =
    0.01; /* share of ticks that may be filled from their neighbour */

static void take(exk_series *series, size_t k, const exk_sample *sample)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        series->u_rad[i][k] = sample->u_rad[i];
        series->e_rad[i][k] = sample->r_rad[i] - sample->m_rad[i];
        series->c_rad[i][k] = sample->c_rad[i];
    }
}

/* Fills the arrays tick by tick; a tick the log does not hold takes the values of the one before
 * it. Returns how many were filled so. */
static size_t fill(exk_series *series, const exk_run_log *log)
{
    size_t at = 0;
    size_t n_missing = 0;
    for (size_t k = 0; k < series->n; k++) {
        while (at + 1 < log->n_samples && log->samples[at + 1].k <= (int64_t)k) {
            at++;
        }
        n_missing += log->samples[at].k != (int64_t)k;
        take(series, k, &log->samples[at]);
    }
    return n_missing;
}

static size_t count_bad(const exk_run_log *log)
{
    size_t n_bad = 0;
    for (size_t i = 0; i < log->n_samples; i++) {
        n_bad += !log->samples[i].sensor_ok;
    }
    return n_bad;
}

/* Nothing is learned from this log, and why. */
__attribute__((format(printf, 2, 3))) static int refuse(const ilc_options *options,
                                                        const char *format, ...)
{
    va_list values;
    fprintf(stderr, "exk-ilc: %s: ", options->input);
    va_start(values, format);
    vfprintf(stderr, format, values);
    va_end(values);
    fputc('\n', stderr);
    return ILC_INPUT;
}

static int refuse_log(const ilc_options *options, const exk_run_log *log)
{
    const size_t n_bad = count_bad(log);
    if (!log->has_job) {
        return refuse(options,
                      "no EXK_JOB in it: the job it belongs to is not known; record it "
                      "again with exk-loop --record or exk-log");
    }
    if (log->n_lost > 0) {
        return refuse(options,
                      "%" PRId64 " sample%s lost on the way: nothing is learned; record with "
                      "exk-loop --record",
                      log->n_lost, exk_plural_s(log->n_lost));
    }
    if (log->has_status && log->status.loop.n_held > 0) {
        return refuse(options,
                      "the run was held for %" PRId64 " tick%s: its samples do not stand where "
                      "the plan has them; nothing is learned",
                      log->status.loop.n_held, exk_plural_s(log->status.loop.n_held));
    }
    if (n_bad > 0 && !options->allow_bad) {
        return refuse(
            options,
            "%zu rejected sensor sample%s: nothing is learned; --allow-bad learns all "
            "the same",
            n_bad, exk_plural_s((int64_t)n_bad));
    }
    return ILC_GOOD;
}

static int save(const ilc_options *options, const exk_run_log *log, const exk_series *series)
{
    char why[512];
    const exk_store store = {.job_hash = log->job_hash,
                             .dt_s = log->dt_s,
                             .iteration = log->run + 1,
                             .n_samples = series->n,
                             .u_rad = {series->u_rad[0], series->u_rad[1]}};
    const exk_store_err err = exk_store_save(options->output, &store, why, sizeof why);
    if (err != EXK_STORE_OK) {
        fprintf(stderr, "exk-ilc: %s\n", why);
        return err == EXK_STORE_IO ? ILC_IO : ILC_INPUT;
    }
    printf("%s: learned from run %" PRIu32
           " of %s, %zu samples; it holds the correction for run "
           "%" PRIu32 "\n",
           options->output, log->run, log->profile_name, series->n, store.iteration);
    return ILC_GOOD;
}

static int learn_and_save(const ilc_options *options, const exk_run_log *log,
                          exk_series *series)
{
    const size_t n_missing = fill(series, log);
    if (!((double)n_missing <= missing_max * (double)series->n)) {
        return refuse(options,
                      "%zu of %zu ticks are missing, at most %g %% are allowed: nothing is "
                      "learned; record a whole run",
                      n_missing, series->n, 100.0 * missing_max);
    }
    if (n_missing > 0) {
        fprintf(stderr,
                "exk-ilc: %s: %zu missing tick%s filled with the values of the tick before\n",
                options->input, n_missing, exk_plural_s((int64_t)n_missing));
    }
    const exk_err err = exk_series_learn(series);
    if (err != EXK_OK) {
        return refuse(options,
                      "the update is refused: %s; check ilc_gain and the run's samples",
                      exk_err_name(err));
    }
    return save(options, log, series);
}

static int learn_from(const ilc_options *options, const exk_run_log *log)
{
    exk_rig rig;
    exk_series series;
    int code = refuse_log(options, log);
    code = code != ILC_GOOD ? code
                            : exk_rig_open_text(&rig, log->profile_name, log->profile_text,
                                                log->holes, log->n_holes);
    if (code != ILC_GOOD) {
        return code;
    }
    if (exk_series_open(&series, &rig)) {
        code = learn_and_save(options, log, &series);
        exk_series_close(&series);
    } else {
        fprintf(stderr, "exk-ilc: out of memory\n");
        code = ILC_IO;
    }
    exk_rig_close(&rig);
    return code;
}

int ilc_learn(const ilc_options *options)
{
    exk_run_log log;
    char why[512];
    int code = ILC_INPUT;
    exk_run_log_init(&log);
    if (exk_run_log_read(&log, options->input, why, sizeof why)) {
        code = learn_from(options, &log);
    } else {
        fprintf(stderr, "exk-ilc: %s\n", why);
    }
    exk_run_log_free(&log);
    return code;
}
