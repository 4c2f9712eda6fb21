#include "exk/log.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void exk_run_log_init(exk_run_log *log)
{
    *log = (exk_run_log){.last_seq = -1, .last_k = -1, .every = 1};
}

void exk_run_log_free(exk_run_log *log)
{
    free(log->profile_text);
    free(log->holes);
    free(log->samples);
    exk_run_log_init(log);
}

/* Is a message with this run_id of our run? The first one seen decides. */
static bool is_ours(exk_run_log *log, int64_t run_id)
{
    if (!log->has_run && (log->only_run_id == 0 || log->only_run_id == run_id)) {
        log->has_run = true;
        log->run_id = run_id;
    }
    if (log->has_run && log->run_id == run_id) {
        return true;
    }
    log->n_other++;
    log->n_other_run++;
    return false;
}

static bool keep(exk_run_log *log, const exk_sample *sample)
{
    if (log->keep_none) {
        return true;
    }
    if (log->n_samples == log->capacity) {
        const size_t capacity = log->capacity > 0 ? 2 * log->capacity : 1024;
        exk_sample *samples = realloc(log->samples, capacity * sizeof *samples);
        if (samples == NULL) {
            return false;
        }
        log->samples = samples;
        log->capacity = capacity;
    }
    log->samples[log->n_samples++] = *sample;
    return true;
}

/* A gap in seq is loss; where seq is whole, a gap in k is missed ticks or decimation. */
static void count_gaps(exk_run_log *log, int64_t seq, int64_t k)
{
    if (log->n_poses == 0) {
        log->n_before = seq;
        log->first_k = k;
    } else if (seq > log->last_seq + 1) {
        log->n_lost += seq - log->last_seq - 1;
    } else {
        log->n_skipped_k += k - log->last_k - 1;
    }
}

static bool feed_pose(exk_run_log *log, const void *data, size_t bytes)
{
    exk_wire_pose pose;
    if (!exk_wire_pose_decode(data, bytes, &pose) || pose.seq < 0 || pose.sample.k < 0) {
        log->n_undecoded++;
        return true;
    }
    if (!is_ours(log, pose.run_id)) {
        return true;
    }
    if (pose.seq <= log->last_seq || pose.sample.k <= log->last_k) {
        log->n_repeated++;
        return true;
    }
    if (!keep(log, &pose.sample)) {
        return false;
    }
    count_gaps(log, pose.seq, pose.sample.k);
    log->n_poses++;
    log->last_seq = pose.seq;
    log->last_k = pose.sample.k;
    if (log->on_pose != NULL) {
        log->on_pose(log->ctx, &pose);
    }
    return true;
}

/* Takes over what the message owns. */
static void adopt_job(exk_run_log *log, exk_wire_job *job)
{
    log->has_job = true;
    memcpy(log->profile_name, job->profile_name, sizeof log->profile_name);
    memcpy(log->kinematics, job->kinematics, sizeof log->kinematics);
    memcpy(log->controller, job->controller, sizeof log->controller);
    log->job_hash = job->job_hash;
    log->series = job->series;
    log->run = job->run;
    log->seed = job->seed;
    log->dt_s = job->dt_s;
    log->tolerance_m = job->tolerance_m;
    log->n_ticks = job->n_ticks;
    log->every = job->every;
    log->profile_text = job->profile_text;
    log->holes = job->holes;
    log->n_holes = job->n_holes;
}

static bool feed_job(exk_run_log *log, const void *data, size_t bytes)
{
    exk_wire_job job;
    if (!exk_wire_job_decode(data, bytes, &job)) {
        log->n_undecoded++;
        return true;
    }
    if (is_ours(log, job.stamp.run_id) && !log->has_job) {
        adopt_job(log, &job);
    } else {
        exk_wire_job_free(&job);
    }
    return true;
}

/* The last status knows how many poses were sent: what is missing at the end is lost too. */
static void close_run(exk_run_log *log)
{
    if (!log->closed && log->n_poses > 0 && log->status.n_poses > log->last_seq + 1) {
        log->n_lost += log->status.n_poses - log->last_seq - 1;
    }
    log->closed = true;
}

static bool feed_status(exk_run_log *log, const void *data, size_t bytes)
{
    exk_wire_status status;
    if (!exk_wire_status_decode(data, bytes, &status)) {
        log->n_undecoded++;
        return true;
    }
    if (!is_ours(log, status.stamp.run_id)) {
        return true;
    }
    log->has_status = true;
    log->status = status;
    log->ended = log->ended || status.last || status.state == EXK_STATE_DONE ||
                 status.state == EXK_STATE_FAULT;
    if (status.last) {
        close_run(log);
    }
    return true;
}

/* Holes are judged anew by whoever reads; the message only has to be sound. */
static bool feed_hole(exk_run_log *log, const void *data, size_t bytes)
{
    exk_wire_hole hole;
    if (exk_wire_hole_decode(data, bytes, &hole)) {
        is_ours(log, hole.stamp.run_id);
    } else {
        log->n_undecoded++;
    }
    return true;
}

bool exk_run_log_feed(exk_run_log *log, const char *channel, const void *data, size_t bytes)
{
    if (strcmp(channel, EXK_CHANNEL_POSE) == 0) {
        return feed_pose(log, data, bytes);
    }
    if (strcmp(channel, EXK_CHANNEL_JOB) == 0) {
        return feed_job(log, data, bytes);
    }
    if (strcmp(channel, EXK_CHANNEL_STATUS) == 0) {
        return feed_status(log, data, bytes);
    }
    if (strcmp(channel, EXK_CHANNEL_HOLE) == 0) {
        return feed_hole(log, data, bytes);
    }
    log->n_other++;
    return true;
}
