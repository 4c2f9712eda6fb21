#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "messages.h"

static bool copy_texts(exk_wire_job *job, const exk_run_info *info)
{
    const exk_profile *p = info->profile;
    const char *text = info->profile_text != NULL ? info->profile_text : "";
    snprintf(job->profile_name, sizeof job->profile_name, "%s", p->name);
    snprintf(job->kinematics, sizeof job->kinematics, "%s", exk_kin_name(p->model));
    snprintf(job->controller, sizeof job->controller, "%s",
             exk_feedback_name(p->feedback.kind));
    job->profile_text = malloc(strlen(text) + 1);
    if (job->profile_text == NULL) {
        return false;
    }
    memcpy(job->profile_text, text, strlen(text) + 1);
    return true;
}

static bool copy_holes(exk_wire_job *job, const exk_run_info *info)
{
    job->n_holes = info->n_holes;
    job->holes = calloc(info->n_holes + 1, sizeof *job->holes);
    if (job->holes == NULL) {
        return false;
    }
    if (info->n_holes > 0) {
        memcpy(job->holes, info->holes, info->n_holes * sizeof *job->holes);
    }
    return true;
}

static bool fill_job(exk_wire_job *job, const exk_run_info *info)
{
    const exk_profile *p = info->profile;
    job->start_utime_us = info->fast ? 0 : info->start_utime_us;
    job->job_hash = info->job_hash;
    job->seed = p->timing.seed;
    job->series = info->series;
    job->run = info->run;
    job->n_ticks = info->n_ticks;
    job->every = p->telemetry.every > 1 ? p->telemetry.every : 1;
    job->dt_s = p->timing.dt_s;
    job->tolerance_m = p->job.tolerance_m;
    return copy_texts(job, info) && copy_holes(job, info);
}

static bool allocate(exk_messages *m, const exk_run_info *info)
{
    if (!fill_job(&m->job, info)) {
        return false;
    }
    const size_t n = info->n_holes + 1;
    m->job_bytes = exk_wire_job_bytes(&m->job);
    m->job_buffer = malloc(m->job_bytes);
    m->results = calloc(n, sizeof *m->results);
    m->scratch.ids = calloc(n, sizeof *m->scratch.ids);
    m->scratch.rows = calloc(2 * n, sizeof *m->scratch.rows);
    return m->job_buffer != NULL && m->results != NULL && m->scratch.ids != NULL &&
           m->scratch.rows != NULL;
}

static bool set_up(exk_messages *m, const exk_run_info *info, char *why, size_t why_size)
{
    if (!allocate(m, info)) {
        snprintf(why, why_size, "no memory for the telemetry of %zu holes", info->n_holes);
        return false;
    }
    const exk_err err =
        exk_judge_init(&m->judge, m->job.holes, m->job.n_holes, m->job.tolerance_m, m->results);
    if (err != EXK_OK) {
        snprintf(why, why_size, "the holes of this job cannot be judged: %s",
                 exk_err_name(err));
        return false;
    }
    return exk_outlet_open(&m->out, info->url, info->record_path, info->fast, why, why_size);
}

bool exk_messages_init(exk_messages *m, const exk_run_info *info, char *why, size_t why_size)
{
    const double rate_Hz = info->profile->telemetry.status_Hz;
    *m = (exk_messages){.fast = info->fast, .run_id = info->run_id, .next_job_us = 1000000};
    m->dt_s = info->profile->timing.dt_s;
    m->status_period_us = rate_Hz > 0.0 ? (int64_t)(1e6 / rate_Hz) : INT64_MAX / 2;
    m->next_status_us = m->status_period_us;
    m->lateness = info->fast ? NULL : info->lateness;
    m->step_time = info->fast ? NULL : info->step_time;
    m->status.state = EXK_STATE_INIT;
    if (!set_up(m, info, why, why_size)) {
        exk_messages_free(m);
        return false;
    }
    return true;
}

void exk_messages_free(exk_messages *m)
{
    exk_wire_job_free(&m->job);
    free(m->job_buffer);
    free(m->results);
    free(m->scratch.ids);
    free(m->scratch.rows);
}
