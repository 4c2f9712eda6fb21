/* A log file of any bytes: every record lies inside the file, reading ends, and what is made a run of
 * holds together. */
#include <math.h>
#include <string.h>

#include "exk/event_file.h"
#include "exk/log.h"
#include "fuzz.h"
#include "memory_file.h"

static void read_events(const char *path, size_t size)
{
    exk_event_reader reader;
    char why[256] = "";
    size_t total = 0;
    if (!exk_event_reader_open(&reader, path, why, sizeof why)) {
        PROMISE(why[0] != '\0');
        return;
    }
    while (exk_event_reader_next(&reader) == EXK_EVENT_OK) {
        total += reader.bytes;
        PROMISE(total < size && reader.at <= (int64_t)size);
        PROMISE(memchr(reader.channel, '\0', sizeof reader.channel) != NULL);
    }
    PROMISE(reader.n_damaged <= (int64_t)size);
    exk_event_reader_close(&reader);
}

static void read_run(const char *path)
{
    exk_run_log log;
    char why[256] = "";
    exk_run_log_init(&log);
    if (exk_run_log_read(&log, path, why, sizeof why)) {
        PROMISE(log.n_poses > 0 && (size_t)log.n_poses == log.n_samples);
        PROMISE(log.n_samples <= log.capacity);
        for (size_t i = 1; i < log.n_samples; i++) {
            PROMISE(log.samples[i].k > log.samples[i - 1].k);
        }
    } else {
        PROMISE(why[0] != '\0' && memchr(why, '\0', sizeof why) != NULL);
    }
    exk_run_log_free(&log);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const char *path = memory_file(data, size);
    read_events(path, size);
    read_run(path);
    return 0;
}
