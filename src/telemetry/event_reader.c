#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "exk/event_file.h"
#include "wire_text.h"

enum { HEADER_BYTES = 28, CHANNEL_MAX = 63 };
static const unsigned char sync_word[4] = {0xED, 0xA1, 0xDA, 0x01};

static bool refuse(exk_event_reader *reader, const char *path, const char *reason, char *why,
                   size_t why_size)
{
    snprintf(why, why_size, "%s: %s", path, reason);
    exk_event_reader_close(reader);
    return false;
}

bool exk_event_reader_open(exk_event_reader *reader, const char *path, char *why,
                           size_t why_size)
{
    *reader = (exk_event_reader){0};
    reader->file = fopen(path, "rb");
    struct stat info;
    if (reader->file == NULL || fstat(fileno(reader->file), &info) != 0) {
        return refuse(reader, path, strerror(errno), why, why_size);
    }
    if (!S_ISREG(info.st_mode)) {
        return refuse(reader, path, "not a file: an LCM log is needed", why, why_size);
    }
    reader->size = info.st_size;
    if (reader->size == 0) {
        return refuse(reader, path, "empty: no message was recorded", why, why_size);
    }
    unsigned char first[4] = {0};
    if (fread(first, 1, 4, reader->file) != 4 || memcmp(first, sync_word, 4) != 0) {
        return refuse(reader, path,
                      "not an LCM log: record with exk-log, exk-loop --record or lcm-logger",
                      why, why_size);
    }
    return true;
}

static int64_t long_at(const unsigned char *at)
{
    const uint64_t high = (uint32_t)exk_wire_int_at(at, 0);
    const uint64_t low = (uint32_t)exk_wire_int_at(at, 4);
    const uint64_t value = high << 32 | low;
    int64_t out;
    memcpy(&out, &value, sizeof out);
    return out;
}

static bool grow(exk_event_reader *reader, size_t need)
{
    if (need <= reader->capacity) {
        return true;
    }
    size_t capacity = reader->capacity > 0 ? reader->capacity : 4096;
    while (capacity < need) {
        capacity *= 2;
    }
    unsigned char *buffer = realloc(reader->buffer, capacity);
    if (buffer == NULL) {
        return false;
    }
    reader->buffer = buffer;
    reader->capacity = capacity;
    return true;
}

/* Reads the record at reader->at. CUT: what is there is not one whole record. */
static exk_event_status take(exk_event_reader *reader)
{
    unsigned char header[HEADER_BYTES];
    const int64_t left = reader->size - reader->at;
    if (left < HEADER_BYTES || fseeko(reader->file, reader->at, SEEK_SET) != 0 ||
        fread(header, 1, sizeof header, reader->file) != sizeof header ||
        memcmp(header, sync_word, 4) != 0) {
        return EXK_EVENT_CUT;
    }
    const int32_t n_channel = exk_wire_int_at(header, 20);
    const int32_t n_data = exk_wire_int_at(header, 24);
    if (n_channel < 1 || n_channel > CHANNEL_MAX || n_data < 0 ||
        n_data > left - HEADER_BYTES - n_channel) {
        return EXK_EVENT_CUT;
    }
    reader->bytes = (size_t)n_data;
    if (!grow(reader, reader->bytes + 1)) {
        return EXK_EVENT_NO_MEMORY;
    }
    memset(reader->channel, 0, sizeof reader->channel);
    if (fread(reader->channel, 1, (size_t)n_channel, reader->file) != (size_t)n_channel ||
        fread(reader->buffer, 1, reader->bytes, reader->file) != reader->bytes) {
        return EXK_EVENT_NO_MEMORY;
    }
    reader->data = reader->buffer;
    reader->stamp_us = long_at(header + 12);
    reader->at += HEADER_BYTES + n_channel + n_data;
    return EXK_EVENT_OK;
}

/* Moves at to the next sync word past the present place; false when there is none. */
static bool resync(exk_event_reader *reader)
{
    uint32_t last = 0;
    int64_t at = reader->at + 1;
    if (fseeko(reader->file, at, SEEK_SET) != 0) {
        return false;
    }
    for (int c = getc(reader->file); c != EOF; c = getc(reader->file)) {
        last = last << 8 | (uint32_t)c;
        at++;
        if (last == 0xEDA1DA01U) {
            reader->at = at - 4;
            return true;
        }
    }
    return false;
}

exk_event_status exk_event_reader_next(exk_event_reader *reader)
{
    while (reader->at < reader->size) {
        const exk_event_status status = take(reader);
        if (status != EXK_EVENT_CUT) {
            return status;
        }
        if (!resync(reader)) {
            reader->at = reader->size;
            return EXK_EVENT_CUT;
        }
        reader->n_damaged++;
    }
    return EXK_EVENT_END;
}

void exk_event_reader_close(exk_event_reader *reader)
{
    if (reader->file != NULL) {
        fclose(reader->file);
    }
    free(reader->buffer);
    reader->file = NULL;
    reader->buffer = NULL;
    reader->capacity = 0;
}
