#include "record.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "exk/bus.h"
#include "exk/event_file.h"
#include "exk/progress_line.h"
#include "exk/stop_signal.h"
#include "exk/wire.h"
#include "now.h"

enum { WAIT_MS = 100, BAR = 24 };
static const double show_s = 0.2;    /* between two lines of progress */
static const double flush_s = 0.5;   /* between two flushes of the log */
static const double settle_s = 1.0;  /* after the end, for what is still on its way */
static const double silence_s = 5.0; /* a status comes ten times a second: then it is dead */

typedef struct {
    const record_request *request;
    exk_run_log *log;
    exk_event_writer *writer;
    bool failed;
    bool no_memory;
    double begin_s;
    double first_s; /* first message, 0: none yet */
    double heard_s; /* newest message */
    double done_s;  /* DONE or FAULT was heard, 0: not yet */
    double shown_s;
    int64_t shown_poses;
    double flushed_s;
} recorder;

static void on_message(void *ctx, const char *channel, const void *data, size_t bytes,
                       int64_t received_us)
{
    recorder *self = ctx;
    self->heard_s = exk_now_s();
    self->first_s = self->first_s > 0.0 ? self->first_s : self->heard_s;
    if (!exk_event_writer_add(self->writer, received_us, channel, data, bytes)) {
        self->failed = true;
    }
    if (!exk_run_log_feed(self->log, channel, data, bytes)) {
        self->no_memory = true;
    }
    if (self->log->ended && !(self->done_s > 0.0)) {
        self->done_s = self->heard_s;
    }
}

static void bar(char *out, int64_t k, int64_t n)
{
    const int64_t full = n > 0 ? (k + 1) * BAR / n : 0;
    for (int i = 0; i < BAR; i++) {
        out[i] = i < full ? '#' : '.';
    }
    out[BAR] = '\0';
}

static void show(recorder *self, double now)
{
    char drawn[BAR + 1];
    const exk_run_log *log = self->log;
    const double rate = (double)(log->n_poses - self->shown_poses) / (now - self->shown_s);
    self->shown_s = now;
    self->shown_poses = log->n_poses;
    if (log->n_poses == 0) {
        exk_progress_show("exk-log: waiting for a run");
    } else {
        bar(drawn, log->last_k, log->n_ticks);
        exk_progress_show("exk-log: %" PRId64 " lost, %.0f/s, %" PRId64 " samples [%s]",
                          log->n_lost, rate, log->n_poses, drawn);
    }
}

static void flush_log(recorder *self, double now)
{
    if (now - self->flushed_s > flush_s) {
        self->flushed_s = now;
        self->failed = !exk_event_writer_flush(self->writer) || self->failed;
    }
}

static bool is_over(const recorder *self, double now, record_end *end)
{
    const record_request *request = self->request;
    if (exk_stop_signal() != 0) {
        *end = RECORD_STOPPED;
        return true;
    }
    if (request->seconds > 0.0 && now - self->begin_s >= request->seconds) {
        *end = RECORD_TIME;
        return true;
    }
    if (request->until_done && self->log->has_run && now - self->heard_s > silence_s) {
        *end = RECORD_SILENT;
        return true;
    }
    *end = RECORD_DONE;
    return request->until_done && self->log->ended &&
           (self->log->closed || now - self->done_s > settle_s);
}

/* What LCM has received is recorded, whatever ended the wait; a run that goes on is not waited for. */
static void drain(exk_bus *bus)
{
    const double begin = exk_now_s();
    while (exk_bus_wait(bus, 0) > 0 && exk_now_s() - begin < settle_s) {
    }
}

static void follow(recorder *self, exk_bus *bus, record_result *out)
{
    double now = exk_now_s();
    self->begin_s = self->shown_s = self->flushed_s = now;
    while (!is_over(self, now, &out->end) && !self->failed && !self->no_memory) {
        if (exk_bus_wait(bus, WAIT_MS) < 0) {
            break;
        }
        now = exk_now_s();
        flush_log(self, now);
        if (self->request->progress && now - self->shown_s > show_s) {
            show(self, now);
        }
    }
    if (!self->failed) {
        drain(bus);
    }
    if (self->request->progress) {
        show(self, exk_now_s());
        fputc('\n', stderr);
    }
    out->seconds = self->heard_s - self->first_s;
}

static int finish(recorder *self, record_result *out, char *why, size_t why_size)
{
    out->n_messages = exk_event_writer_count(self->writer);
    out->n_bytes = exk_event_writer_bytes(self->writer);
    if (!exk_event_writer_close(self->writer, why, why_size)) {
        return 3;
    }
    if (self->no_memory) {
        snprintf(why, why_size, "no memory for the job of this run; the log itself is whole");
        return 3;
    }
    return 0;
}

/* Listening first: when the part is there, nothing is missed any more. */
static bool open_both(recorder *self, exk_bus **bus, char *why, size_t why_size)
{
    *bus = exk_bus_open(self->request->url, true, why, why_size);
    if (*bus == NULL) {
        return false;
    }
    if (exk_bus_listen(*bus, EXK_CHANNEL_ALL, on_message, self, why, why_size)) {
        self->writer = exk_event_writer_create(self->request->path, why, why_size);
    }
    if (self->writer == NULL) {
        exk_bus_close(*bus);
    }
    return self->writer != NULL;
}

int record_bus(exk_run_log *log, const record_request *request, record_result *out, char *why,
               size_t why_size)
{
    recorder self = {.request = request, .log = log};
    exk_bus *bus = NULL;
    *out = (record_result){.end = RECORD_STOPPED};
    if (!exk_event_path_allowed(request->path, why, why_size)) {
        return 2;
    }
    if (!open_both(&self, &bus, why, why_size)) {
        return 3;
    }
    exk_stop_catch();
    follow(&self, bus, out);
    exk_bus_close(bus);
    return finish(&self, out, why, why_size);
}
