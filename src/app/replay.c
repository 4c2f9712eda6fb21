#include "exk/replay.h"

#include <stdio.h>
#include <stdlib.h>

#include "exk/log.h"

static bool copy_samples(exk_replay *replay, const exk_run_log *log)
{
    replay->samples = malloc(log->n_samples * sizeof *replay->samples);
    if (replay->samples == NULL) {
        return false;
    }
    for (size_t i = 0; i < log->n_samples; i++) {
        exk_replay_sample *to = &replay->samples[i];
        to->k = log->samples[i].k;
        to->m_rad[EXK_ALPHA] = log->samples[i].m_rad[EXK_ALPHA];
        to->m_rad[EXK_BETA] = log->samples[i].m_rad[EXK_BETA];
    }
    replay->n_samples = log->n_samples;
    return true;
}

bool exk_replay_open(exk_replay *replay, const char *path, char *why, size_t why_size)
{
    exk_run_log log;
    *replay = (exk_replay){.samples = NULL};
    exk_run_log_init(&log);
    bool good = exk_run_log_read(&log, path, why, why_size);
    if (good && !copy_samples(replay, &log)) {
        snprintf(why, why_size, "%s: out of memory for %zu samples", path, log.n_samples);
        good = false;
    }
    exk_run_log_free(&log);
    return good;
}

void exk_replay_close(exk_replay *replay)
{
    free(replay->samples);
    *replay = (exk_replay){.samples = NULL};
}

void exk_replay_rewind(exk_replay *replay)
{
    replay->next = 0;
}

static exk_err exchange(void *ctx, int64_t k, const exk_drive *drive, exk_reading *out)
{
    exk_replay *replay = ctx;
    (void)drive;
    while (replay->next < replay->n_samples && replay->samples[replay->next].k < k) {
        replay->next++;
    }
    if (replay->next >= replay->n_samples) {
        return EXK_ERR_END;
    }
    const exk_replay_sample *sample = &replay->samples[replay->next];
    *out = (exk_reading){.fresh = sample->k == k};
    out->measured_rad[EXK_ALPHA] = sample->m_rad[EXK_ALPHA];
    out->measured_rad[EXK_BETA] = sample->m_rad[EXK_BETA];
    return EXK_OK;
}

exk_source exk_replay_source(exk_replay *replay)
{
    return (exk_source){.exchange = exchange, .ctx = replay};
}
