#include "exk/series.h"

#include <stdlib.h>
#include <string.h>

enum { ARRAYS = 4 };

bool exk_series_open(exk_series *series, exk_rig *rig)
{
    *series = (exk_series){.rig = rig, .n = (size_t)rig->plan.n_ticks};
    series->block = calloc(series->n * ARRAYS * EXK_N_AXES, sizeof *series->block);
    series->results = calloc(rig->n_holes, sizeof *series->results);
    if (series->block == NULL || series->results == NULL) {
        exk_series_close(series);
        return false;
    }
    double *at = series->block;
    for (int i = 0; i < EXK_N_AXES; i++, at += ARRAYS * series->n) {
        series->u_rad[i] = at;
        series->e_rad[i] = at + series->n;
        series->c_rad[i] = at + 2 * series->n;
        series->next_rad[i] = at + 3 * series->n;
    }
    return true;
}

void exk_series_close(exk_series *series)
{
    free(series->block);
    free(series->results);
    *series = (exk_series){.n = 0};
}

void exk_series_reset(exk_series *series)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        memset(series->u_rad[i], 0, series->n * sizeof *series->u_rad[i]);
    }
}

static void keep(exk_series *series, exk_judge *judge, const exk_sample *sample)
{
    const exk_judged_point point = {.k = sample->k,
                                    .dwell = sample->phase == EXK_PHASE_DWELL,
                                    .hole = sample->hole,
                                    .ref = sample->ref,
                                    .tool = sample->has_true ? sample->real : sample->est};
    exk_judge_push(judge, &point);
    for (int i = 0; i < EXK_N_AXES; i++) {
        series->e_rad[i][sample->k] = sample->r_rad[i] - sample->m_rad[i];
        series->c_rad[i][sample->k] = sample->c_rad[i];
    }
}

exk_err exk_series_run(exk_series *series, exk_realisation which, exk_accuracy *out)
{
    exk_rig *rig = series->rig;
    exk_judge judge;
    const double *const u_rad[EXK_N_AXES] = {series->u_rad[0], series->u_rad[1]};
    exk_err err = exk_rig_start(rig, which, u_rad, series->n);
    if (err == EXK_OK) {
        err = exk_judge_init(&judge, rig->holes, rig->n_holes, rig->profile.job.tolerance_m,
                             series->results);
    }
    for (int64_t k = 0; err == EXK_OK && k < rig->plan.n_ticks; k++) {
        exk_sample sample;
        err = exk_loop_step(&rig->loop, k, &sample);
        keep(series, &judge, &sample);
        if (series->on_sample != NULL) {
            series->on_sample(series->sample_ctx, &sample);
        }
    }
    series->n_bad = rig->loop.n_bad;
    if (err == EXK_OK) {
        exk_judge_end(&judge);
        exk_judge_summary(&judge, out);
    }
    return err;
}

exk_err exk_series_learn(exk_series *series)
{
    exk_err err = EXK_OK;
    for (int i = 0; i < EXK_N_AXES && err == EXK_OK; i++) {
        err = exk_ilc_learn(&series->rig->profile.ilc, series->u_rad[i], series->e_rad[i],
                            series->c_rad[i], series->n, series->next_rad[i]);
    }
    for (int i = 0; i < EXK_N_AXES && err == EXK_OK; i++) {
        double *old = series->u_rad[i];
        series->u_rad[i] = series->next_rad[i];
        series->next_rad[i] = old;
    }
    return err;
}
