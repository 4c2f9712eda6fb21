#include "exk/wire.h"

#include <stdlib.h>
#include <string.h>

#include "exk_job_t.h"
#include "wire_text.h"

enum { N_TEXTS = 4, BYTES_PER_HOLE = 4 + 6 * 8, HOLES_MAX = 1000000 };

static void pack_fixed(exk_job_t *m, const exk_wire_job *job)
{
    m->run_id = job->stamp.run_id;
    m->seq = job->stamp.seq;
    m->k = job->stamp.k;
    m->time_us = job->stamp.time_us;
    m->start_utime_us = job->start_utime_us;
    memcpy(&m->job_hash, &job->job_hash, sizeof m->job_hash);
    memcpy(&m->seed, &job->seed, sizeof m->seed);
    memcpy(&m->series, &job->series, sizeof m->series);
    memcpy(&m->run, &job->run, sizeof m->run);
    m->n_ticks = job->n_ticks;
    m->every = job->every;
    m->dt_s = job->dt_s;
    m->tolerance_m = job->tolerance_m;
}

static void pack_holes(exk_job_t *m, const exk_wire_job *job, const exk_wire_scratch *scratch)
{
    m->n_holes = (int32_t)job->n_holes;
    m->hole_id = scratch->ids;
    m->target_m = scratch->rows;
    m->axis = scratch->rows + job->n_holes;
    for (size_t i = 0; i < job->n_holes; i++) {
        scratch->ids[i] = job->holes[i].id;
        m->target_m[i] = job->holes[i].target_m;
        m->axis[i] = job->holes[i].axis;
    }
}

int exk_wire_job_encode(const exk_wire_job *job, const exk_wire_scratch *scratch, void *buffer,
                        size_t size)
{
    if (job->n_holes > HOLES_MAX || size > INT32_MAX) {
        return -1;
    }
    exk_wire_job copy = *job; /* the generated struct wants char pointers that it may write */
    exk_job_t m = {.profile_name = copy.profile_name,
                   .kinematics = copy.kinematics,
                   .controller = copy.controller,
                   .profile_text = copy.profile_text};
    pack_fixed(&m, job);
    pack_holes(&m, job, scratch);
    return exk_job_t_encode(buffer, 0, (int)size, &m);
}

/* All before hole_id: what a job without holes takes, less its four empty strings. */
static size_t fixed_bytes(void)
{
    char empty[] = "";
    const exk_job_t m = {
        .profile_name = empty, .kinematics = empty, .controller = empty, .profile_text = empty};
    return (size_t)exk_job_t_encoded_size(&m) - N_TEXTS * (4 + 1);
}

size_t exk_wire_job_bytes(const exk_wire_job *job)
{
    return fixed_bytes() + job->n_holes * BYTES_PER_HOLE + N_TEXTS * (4 + 1) +
           strlen(job->profile_name) + strlen(job->kinematics) + strlen(job->controller) +
           strlen(job->profile_text);
}

static bool looks_whole(const void *data, size_t bytes)
{
    size_t at = fixed_bytes();
    if (bytes < at || bytes > INT32_MAX) {
        return false;
    }
    const int32_t n_holes = exk_wire_int_at(data, at - 4);
    if (n_holes < 0 || n_holes > HOLES_MAX || (size_t)n_holes > (bytes - at) / BYTES_PER_HOLE) {
        return false;
    }
    at += (size_t)n_holes * BYTES_PER_HOLE;
    for (int i = 0; i < N_TEXTS; i++) {
        if (!exk_wire_skip_text(data, bytes, &at)) {
            return false;
        }
    }
    return at == bytes;
}

static void unpack_fixed(exk_wire_job *job, const exk_job_t *m)
{
    job->stamp = (exk_wire_stamp){m->run_id, m->seq, m->k, m->time_us};
    job->start_utime_us = m->start_utime_us;
    memcpy(&job->job_hash, &m->job_hash, sizeof job->job_hash);
    memcpy(&job->seed, &m->seed, sizeof job->seed);
    memcpy(&job->series, &m->series, sizeof job->series);
    memcpy(&job->run, &m->run, sizeof job->run);
    job->n_ticks = m->n_ticks;
    job->every = m->every;
    job->dt_s = m->dt_s;
    job->tolerance_m = m->tolerance_m;
    exk_wire_copy_text(job->profile_name, sizeof job->profile_name, m->profile_name);
    exk_wire_copy_text(job->kinematics, sizeof job->kinematics, m->kinematics);
    exk_wire_copy_text(job->controller, sizeof job->controller, m->controller);
}

/* Memory of its own for holes and text; false when there is none. */
static bool unpack_owned(exk_wire_job *job, const exk_job_t *m)
{
    const size_t n_text = strlen(m->profile_text) + 1;
    job->n_holes = (size_t)m->n_holes;
    job->holes = calloc(job->n_holes + 1, sizeof *job->holes);
    job->profile_text = malloc(n_text);
    if (job->holes == NULL || job->profile_text == NULL) {
        exk_wire_job_free(job);
        return false;
    }
    memcpy(job->profile_text, m->profile_text, n_text);
    for (size_t i = 0; i < job->n_holes; i++) {
        job->holes[i].id = m->hole_id[i];
        memcpy(job->holes[i].target_m, m->target_m[i], sizeof job->holes[i].target_m);
        memcpy(job->holes[i].axis, m->axis[i], sizeof job->holes[i].axis);
    }
    return true;
}

bool exk_wire_job_decode(const void *data, size_t bytes, exk_wire_job *out)
{
    exk_job_t m = {0};
    if (!looks_whole(data, bytes) || exk_job_t_decode(data, 0, (int)bytes, &m) != (int)bytes) {
        return false;
    }
    exk_wire_job job = {0};
    unpack_fixed(&job, &m);
    const bool ok = unpack_owned(&job, &m);
    exk_job_t_decode_cleanup(&m);
    if (ok) {
        *out = job;
    }
    return ok;
}

void exk_wire_job_free(exk_wire_job *job)
{
    free(job->holes);
    free(job->profile_text);
    job->holes = NULL;
    job->profile_text = NULL;
    job->n_holes = 0;
}
