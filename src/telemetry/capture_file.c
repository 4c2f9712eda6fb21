#include "exk/capture_file.h"

#include <stdio.h>
#include <stdlib.h>

#include "messages.h"

static const exk_ring_figures no_ring = {0, 0};

static void put_samples(exk_messages *m, const exk_capture *capture, const exk_record *end)
{
    const size_t n = exk_capture_count(capture);
    for (size_t i = 0; i < n; i++) {
        exk_slot slot = {.seq = (int64_t)i, .previous_k = -1, .previous_seq = -1};
        slot.record = *end;
        slot.record.n_notes = 0;
        slot.record.sample = *exk_capture_at(capture, i);
        exk_messages_take(m, &slot);
    }
}

/* Every message of the run but those of the bus, from what was kept. */
static bool put_all(exk_messages *m, const exk_capture *capture, const exk_record *end,
                    char *why, size_t why_size)
{
    const size_t n = exk_capture_count(capture);
    exk_messages_begin(m);
    put_samples(m, capture, end);
    exk_messages_end(m, exk_capture_at(capture, n - 1)->k, (int64_t)n, &no_ring);
    if (!m->out.file_ok) {
        snprintf(why, why_size, "%s", m->out.why);
    }
    return m->out.file_ok;
}

bool exk_capture_file_write(const char *path, const exk_run_info *info,
                            const exk_capture *capture, const exk_record *end, char *why,
                            size_t why_size)
{
    exk_messages *m = malloc(sizeof *m);
    exk_profile *profile = malloc(sizeof *profile);
    bool good = m != NULL && profile != NULL && exk_capture_count(capture) > 0;
    snprintf(why, why_size, "%s: out of memory", path);
    if (good) {
        exk_run_info copy = *info;
        *profile = *info->profile;
        profile->telemetry.every = 1;
        copy.profile = profile;
        copy.url = NULL;
        copy.record_path = path;
        copy.fast = true;
        good = exk_messages_init(m, &copy, why, why_size);
        if (good) {
            good = put_all(m, capture, end, why, why_size);
            exk_messages_free(m);
        }
    }
    free(profile);
    free(m);
    return good;
}
