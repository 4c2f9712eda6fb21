#define _DEFAULT_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <lcm/eventlog.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "exk/event_file.h"
#include "wire_text.h"

enum { BUFFER_BYTES = 256 * 1024, HEADER_BYTES = 28, NAME_MAX_BYTES = 1024 };

struct exk_event_writer {
    char path[NAME_MAX_BYTES];
    char part[NAME_MAX_BYTES]; /* path and ".part": written under this name */
    lcm_eventlog_t *log;
    int lock; /* second descriptor of the part: one writer at a time */
    int64_t n_records;
    int64_t n_bytes;
    char why[512]; /* first failure, empty while all is well */
    char buffer[BUFFER_BYTES];
};

static bool begins_like_a_log(const char *path)
{
    unsigned char first[4] = {0};
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return false;
    }
    const size_t n = fread(first, 1, sizeof first, file);
    fclose(file);
    return n == sizeof first && exk_wire_int_at(first, 0) == (int32_t)0xEDA1DA01;
}

static bool may_replace(const char *path, char *why, size_t why_size)
{
    struct stat info;
    if (stat(path, &info) != 0 && errno == ENOENT) {
        return true;
    }
    if (S_ISREG(info.st_mode) && (info.st_size == 0 || begins_like_a_log(path))) {
        return true;
    }
    snprintf(why, why_size,
             "%s exists and is not an LCM log: not overwritten; choose another name or move it "
             "away",
             path);
    return false;
}

static bool part_of(const char *path, char part[NAME_MAX_BYTES], char *why, size_t why_size)
{
    const int n = snprintf(part, NAME_MAX_BYTES, "%s.part", path);
    if (n < 0 || n >= NAME_MAX_BYTES) {
        snprintf(why, why_size, "%.60s...: more than %d characters: use a shorter name", path,
                 NAME_MAX_BYTES - 6);
        return false;
    }
    return true;
}

bool exk_event_path_allowed(const char *path, char *why, size_t why_size)
{
    char part[NAME_MAX_BYTES];
    return part_of(path, part, why, why_size) && may_replace(path, why, why_size) &&
           may_replace(part, why, why_size);
}

static bool name(exk_event_writer *writer, const char *path, char *why, size_t why_size)
{
    if (!exk_event_path_allowed(path, why, why_size)) {
        return false;
    }
    snprintf(writer->path, sizeof writer->path, "%s", path);
    return part_of(path, writer->part, why, why_size);
}

static void discard(exk_event_writer *writer)
{
    if (writer->lock >= 0) {
        close(writer->lock);
    }
    free(writer);
}

/* Opens the part without emptying it, takes its lock, and only then empties it. */
static bool open_locked(exk_event_writer *writer, char *why, size_t why_size)
{
    const char *part = writer->part;
    writer->lock = open(part, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (writer->lock < 0) {
        snprintf(why, why_size, "%s: cannot be created: %s", part, strerror(errno));
        return false;
    }
    if (flock(writer->lock, LOCK_EX | LOCK_NB) != 0) {
        snprintf(why, why_size, "%s is being written by another process: choose another name",
                 part);
        return false;
    }
    writer->log = lcm_eventlog_create(part, "w");
    if (writer->log == NULL) {
        snprintf(why, why_size, "%s: cannot be opened: %s", part, strerror(errno));
        return false;
    }
    setvbuf(writer->log->f, writer->buffer, _IOFBF, sizeof writer->buffer);
    return true;
}

exk_event_writer *exk_event_writer_create(const char *path, char *why, size_t why_size)
{
    exk_event_writer *writer = calloc(1, sizeof *writer);
    if (writer == NULL) {
        snprintf(why, why_size, "%s: no memory for the log writer", path);
        return NULL;
    }
    writer->lock = -1;
    if (!name(writer, path, why, why_size) || !open_locked(writer, why, why_size)) {
        discard(writer);
        return NULL;
    }
    return writer;
}

/* Cuts the part behind its last whole record: what a failed write left of another goes. */
static void cut_at_whole_record(const exk_event_writer *writer)
{
    char why[64];
    exk_event_reader reader;
    int64_t end = 0;
    if (exk_event_reader_open(&reader, writer->part, why, sizeof why)) {
        while (exk_event_reader_next(&reader) == EXK_EVENT_OK) {
            end = reader.at;
        }
        exk_event_reader_close(&reader);
    }
    if (ftruncate(writer->lock, end) != 0) {
        return; /* the reader copes with a cut record too */
    }
}

static bool fail(exk_event_writer *writer)
{
    const int error = errno;
    const char *help = error == ENOSPC ? " (make room, or record elsewhere)" : "";
    snprintf(writer->why, sizeof writer->why,
             "%.160s: recording stopped: %s%s; all whole records before stay in %.160s",
             writer->path, strerror(error), help, writer->part);
    lcm_eventlog_destroy(
        writer->log); /* tries to flush once more: more whole records, or none */
    writer->log = NULL;
    cut_at_whole_record(writer);
    return false;
}

bool exk_event_writer_add(exk_event_writer *writer, int64_t stamp_us, const char *channel,
                          const void *data, size_t bytes)
{
    if (writer->log == NULL) {
        return false;
    }
    union {
        const void *read;
        void *write;
    } payload = {.read = data};
    char label[64] = {0};
    memcpy(label, channel, strnlen(channel, sizeof label - 1));
    lcm_eventlog_event_t event = {.timestamp = stamp_us,
                                  .channellen = (int32_t)strlen(label),
                                  .datalen = (int32_t)bytes,
                                  .channel = label,
                                  .data = payload.write};
    errno = 0;
    if (lcm_eventlog_write_event(writer->log, &event) != 0) {
        return fail(writer);
    }
    writer->n_records++;
    writer->n_bytes += HEADER_BYTES + event.channellen + event.datalen;
    return true;
}

bool exk_event_writer_flush(exk_event_writer *writer)
{
    if (writer->log == NULL) {
        return false;
    }
    errno = 0;
    return fflush(writer->log->f) == 0 || fail(writer);
}

const char *exk_event_writer_why(const exk_event_writer *writer)
{
    return writer->why;
}

int64_t exk_event_writer_count(const exk_event_writer *writer)
{
    return writer->n_records;
}

int64_t exk_event_writer_bytes(const exk_event_writer *writer)
{
    return writer->n_bytes;
}

/* A file system that cannot sync is no reason to fail; one that could not write is. */
static bool finish(exk_event_writer *writer)
{
    if (!exk_event_writer_flush(writer)) {
        return false;
    }
    if (fsync(fileno(writer->log->f)) != 0 && errno != EINVAL && errno != EROFS) {
        return fail(writer);
    }
    lcm_eventlog_destroy(writer->log);
    writer->log = NULL;
    if (rename(writer->part, writer->path) != 0) {
        snprintf(writer->why, sizeof writer->why, "%.200s: cannot be renamed to %.200s: %s",
                 writer->part, writer->path, strerror(errno));
        return false;
    }
    return true;
}

bool exk_event_writer_close(exk_event_writer *writer, char *why, size_t why_size)
{
    const bool ok = finish(writer);
    if (!ok) {
        snprintf(why, why_size, "%s", writer->why);
    }
    discard(writer);
    return ok;
}

void exk_event_writer_drop(exk_event_writer *writer)
{
    if (writer == NULL) {
        return;
    }
    if (writer->log != NULL) {
        lcm_eventlog_destroy(writer->log);
    }
    remove(writer->part);
    discard(writer);
}
