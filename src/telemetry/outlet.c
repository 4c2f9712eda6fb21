#include "outlet.h"

#include <stdio.h>
#include <string.h>

#include "exk/realtime.h"
#include "exk/wire.h"

bool exk_outlet_open(exk_outlet *out, const char *url, const char *record_path, bool fast,
                     char *why, size_t why_size)
{
    *out = (exk_outlet){.fast = fast, .bus_ok = true, .file_ok = true};
    if (record_path != NULL) {
        out->file = exk_event_writer_create(record_path, why, why_size);
        if (out->file == NULL) {
            return false;
        }
    }
    if (url != NULL) {
        out->bus = exk_bus_open(url, false, why, why_size);
        if (out->bus == NULL) {
            exk_event_writer_drop(out->file);
            return false;
        }
    }
    return true;
}

static void note(exk_outlet *out, const char *what)
{
    if (out->why[0] == '\0') {
        snprintf(out->why, sizeof out->why, "%s", what);
    }
    fprintf(stderr, "exk-loop: %s\n", what);
}

static void send_bus(exk_outlet *out, const char *channel, const void *data, int bytes)
{
    if (out->bus_down && strcmp(channel, EXK_CHANNEL_JOB) != 0) {
        return;
    }
    const bool sent = exk_bus_send(out->bus, channel, data, (size_t)bytes);
    if (!sent && out->bus_ok) {
        note(out, "the bus refuses messages (exk-doctor finds out why); the run goes on, "
                  "subscribers see a gap");
    }
    out->bus_down = !sent;
    out->bus_ok = out->bus_ok && sent;
}

static void check_file(exk_outlet *out, bool written)
{
    if (!written && out->file_ok) {
        out->file_ok = false;
        note(out, exk_event_writer_why(out->file));
    }
}

void exk_outlet_send(exk_outlet *out, const char *channel, const void *data, int bytes,
                     int64_t time_us)
{
    if (bytes < 0) {
        return;
    }
    if (out->bus != NULL) {
        send_bus(out, channel, data, bytes);
    }
    if (out->file != NULL && out->file_ok) {
        const int64_t stamp_us = out->fast ? time_us : exk_wall_us();
        check_file(out,
                   exk_event_writer_add(out->file, stamp_us, channel, data, (size_t)bytes));
    }
}

void exk_outlet_flush(exk_outlet *out)
{
    if (out->file != NULL && out->file_ok) {
        check_file(out, exk_event_writer_flush(out->file));
    }
}

void exk_outlet_close(exk_outlet *out)
{
    char why[512];
    exk_bus_close(out->bus);
    out->bus = NULL;
    if (out->file != NULL && !exk_event_writer_close(out->file, why, sizeof why) &&
        out->file_ok) {
        out->file_ok = false;
        note(out, why);
    }
    out->file = NULL;
}
