#include "exk/series.h"

#include <stdlib.h>
#include <string.h>

enum { ARRAYS = 5 };

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
        series->noise_rad[i] = at + 4 * series->n;
    }
    return true;
}

void exk_series_close(exk_series *series)
{
    free(series->block);
    free(series->results);
    free(series->way);
    *series = (exk_series){.n = 0};
}

void exk_series_reset(exk_series *series)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        memset(series->u_rad[i], 0, series->n * sizeof *series->u_rad[i]);
    }
    series->drawn.run = 0;
}

static void keep_point(exk_series *series, exk_judge *judge, const exk_judged_point *point,
                       const double e_rad[EXK_N_AXES], const double c_rad[EXK_N_AXES])
{
    exk_judge_push(judge, point);
    if (series->on_point != NULL) {
        series->on_point(series->point_ctx, point);
    }
    for (int i = 0; i < EXK_N_AXES; i++) {
        series->e_rad[i][point->k] = e_rad[i];
        series->c_rad[i][point->k] = c_rad[i];
    }
}

static void keep(exk_series *series, exk_judge *judge, const exk_sample *sample)
{
    const exk_judged_point point = {.k = sample->k,
                                    .dwell = sample->phase == EXK_PHASE_DWELL,
                                    .hole = sample->hole,
                                    .ref = sample->ref,
                                    .tool = sample->has_true ? sample->real : sample->est};
    double e_rad[EXK_N_AXES];
    for (int i = 0; i < EXK_N_AXES; i++) {
        e_rad[i] = sample->r_rad[i] - sample->m_rad[i];
    }
    keep_point(series, judge, &point, e_rad, sample->c_rad);
    if (series->on_sample != NULL) {
        series->on_sample(series->sample_ctx, sample);
    }
}

static exk_err start(exk_series *series, exk_realisation which, exk_judge *judge)
{
    exk_rig *rig = series->rig;
    const double *const u_rad[EXK_N_AXES] = {series->u_rad[0], series->u_rad[1]};
    const exk_err err = exk_rig_start(rig, which, u_rad, series->n);
    return err != EXK_OK ? err
                         : exk_judge_init(judge, rig->holes, rig->n_holes,
                                          rig->profile.job.tolerance_m, series->results);
}

static exk_err run_by_steps(exk_series *series, exk_realisation which, exk_judge *judge)
{
    exk_rig *rig = series->rig;
    exk_err err = start(series, which, judge);
    for (int64_t k = 0; err == EXK_OK && k < rig->plan.n_ticks; k++) {
        exk_sample sample;
        err = exk_loop_step(&rig->loop, k, &sample);
        keep(series, judge, &sample);
    }
    return err;
}

/* Waypoints on the first call. */
static bool can_be_brief(exk_series *series)
{
    const exk_rig *rig = series->rig;
    if (series->by_steps || series->on_sample != NULL ||
        rig->profile.timing.from != EXK_FROM_TWIN) {
        return false;
    }
    if (series->way == NULL) {
        series->way = calloc(series->n, sizeof *series->way);
        if (series->way != NULL &&
            exk_waypoints(&rig->plan, &rig->kin, series->way) != EXK_OK) {
            free(series->way);
            series->way = NULL;
        }
    }
    return series->way != NULL;
}

/* Noise that repeats is drawn in the first run of a series and lent to the twin in all. */
static void lend_noise(exk_series *series, exk_realisation which)
{
    exk_twin *twin = &series->rig->twin;
    const exk_twin_config *cfg = &twin->cfg;
    const bool repeats =
        cfg->n_disturbances == 1 &&
        (cfg->disturbance[0].frozen || cfg->disturbance[0].wave != EXK_WAVE_GAUSSIAN);
    const bool known = series->drawn.run != 0 && series->drawn.seed == which.seed &&
                       series->drawn.series == which.series;
    if (!repeats || (!known && !exk_twin_draw(twin, series->n, series->noise_rad))) {
        return;
    }
    series->drawn = (exk_realisation){.seed = which.seed, .series = which.series, .run = 1};
    exk_twin_lend(twin, series->n, series->noise_rad);
}

static exk_err run_brief(exk_series *series, exk_realisation which, exk_judge *judge)
{
    exk_rig *rig = series->rig;
    exk_err err = start(series, which, judge);
    if (err == EXK_OK) {
        lend_noise(series, which);
    }
    for (int64_t k = 0; err == EXK_OK && k < rig->plan.n_ticks; k++) {
        const exk_waypoint *at = &series->way[k];
        exk_brief brief;
        err = exk_loop_brief(&rig->loop, k, at, &brief);
        if (err == EXK_OK) {
            const exk_judged_point point = {.k = k,
                                            .dwell = at->ref.phase == EXK_PHASE_DWELL,
                                            .hole = at->ref.hole,
                                            .ref = at->ref.tool,
                                            .tool = brief.tool};
            keep_point(series, judge, &point, brief.e_rad, brief.c_rad);
        }
    }
    return err;
}

exk_err exk_series_run(exk_series *series, exk_realisation which, exk_accuracy *out)
{
    exk_judge judge;
    exk_err err = can_be_brief(series) ? run_brief(series, which, &judge) : EXK_ERR_ARG;
    if (err != EXK_OK) {
        err = run_by_steps(series, which, &judge); /* says what is wrong, and where */
    }
    series->n_bad = series->rig->loop.n_bad;
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
