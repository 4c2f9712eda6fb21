#include <stdio.h>
#include <string.h>

#include "exk/event_file.h"
#include "exk/log.h"
#include "exk/plural.h"

static bool feed_all(exk_run_log *log, exk_event_reader *reader)
{
    exk_event_status status = exk_event_reader_next(reader);
    while (status == EXK_EVENT_OK) {
        if (!exk_run_log_feed(log, reader->channel, reader->data, reader->bytes)) {
            return false;
        }
        status = exk_event_reader_next(reader);
    }
    log->truncated = status == EXK_EVENT_CUT;
    log->n_damaged = reader->n_damaged;
    return status != EXK_EVENT_NO_MEMORY;
}

static void say_unusable(const exk_run_log *log, const char *path, char *why, size_t why_size)
{
    if (log->n_undecoded > 0) {
        snprintf(
            why, why_size,
            "%s: no pose of ours: %lld message%s on our channels %s of other types; was it "
            "written by another version of exk?",
            path, (long long)log->n_undecoded, exk_plural_s(log->n_undecoded),
            log->n_undecoded == 1 ? "is" : "are");
    } else {
        snprintf(
            why, why_size,
            "%s: an LCM log, but without EXK_POSE (%lld message%s of other channels%s); record "
            "one with exk-log or exk-loop --record",
            path, (long long)log->n_other, exk_plural_s(log->n_other),
            log->truncated ? ", and cut at its end" : "");
    }
}

bool exk_run_log_read(exk_run_log *log, const char *path, char *why, size_t why_size)
{
    exk_event_reader reader;
    if (!exk_event_reader_open(&reader, path, why, why_size)) {
        return false;
    }
    const bool whole = feed_all(log, &reader);
    exk_event_reader_close(&reader);
    if (!whole) {
        snprintf(why, why_size, "%s: cannot be read on: no memory, or a failing disk", path);
        return false;
    }
    if (log->n_poses == 0) {
        say_unusable(log, path, why, why_size);
        return false;
    }
    return true;
}
