#include "live.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "exk/bus.h"
#include "exk/progress_line.h"
#include "exk/stop_signal.h"
#include "exk/wire.h"
#include "now.h"

enum { WAIT_MS = 100, LINES_PER_S = 5 };

static const double SILENCE_S = 5.0;

typedef struct {
    exk_run_log *log;
    double heard_s; /* time of the last message */
    bool no_memory;
} listener;

static void on_message(void *ctx, const char *channel, const void *data, size_t bytes,
                       int64_t received_us)
{
    listener *self = ctx;
    (void)received_us;
    self->heard_s = exk_now_s();
    if (!exk_run_log_feed(self->log, channel, data, bytes)) {
        self->no_memory = true;
    }
}

static void show_progress(const exk_run_log *log, bool last)
{
    const exk_sample *sample = log->n_samples > 0 ? &log->samples[log->n_samples - 1] : NULL;
    if (sample == NULL) {
        exk_progress_show("exk-holes: waiting for a run");
    } else {
        exk_progress_show(
            "exk-holes: %" PRId64 " lost, hole %d of %zu, tick %" PRId64 " of %" PRId64,
            log->n_lost, (int)sample->hole + 1, log->n_holes, sample->k + 1, log->n_ticks);
    }
    if (last) {
        fputc('\n', stderr);
    }
}

static bool is_over(const listener *self, double begin_s, double seconds)
{
    const double now = exk_now_s();
    const bool silent = self->log->n_samples > 0 && now - self->heard_s > SILENCE_S;
    return exk_stop_signal() != 0 || self->no_memory || self->log->ended || silent ||
           (seconds > 0.0 && now - begin_s > seconds);
}

/* DONE was said: the last poses and the last status may still be on their way. */
static void drain(exk_bus *bus, const listener *self)
{
    while (!self->log->closed && exk_bus_wait(bus, WAIT_MS) > 0) {
    }
}

static void follow(exk_bus *bus, listener *self, double seconds, bool progress)
{
    const double begin_s = exk_now_s();
    double shown_s = 0.0;
    while (!is_over(self, begin_s, seconds)) {
        if (exk_bus_wait(bus, WAIT_MS) < 0) {
            break;
        }
        if (progress && exk_now_s() - shown_s > 1.0 / LINES_PER_S) {
            shown_s = exk_now_s();
            show_progress(self->log, false);
        }
    }
    if (self->log->ended) {
        drain(bus, self);
    }
    if (progress) {
        show_progress(self->log, true);
    }
}

/* What was heard can be judged, or why says why not. */
static int judge_heard(const listener *self, const char *url, char *why, size_t why_size)
{
    if (self->no_memory) {
        snprintf(why, why_size, "%s: out of memory after %zu samples", url,
                 self->log->n_samples);
        return 3;
    }
    if (self->log->n_samples == 0) {
        snprintf(
            why, why_size,
            "%s: no EXK_POSE message heard: start exk-loop on this URL, and check the route "
            "with exk-doctor",
            url);
        return 2;
    }
    return 0;
}

int hole_live_listen(exk_run_log *log, const char *url, double seconds, bool quiet, char *why,
                     size_t why_size)
{
    listener self = {.log = log};
    if (!exk_bus_url_good(url, why, why_size)) {
        return 2;
    }
    exk_bus *bus = exk_bus_open(url, true, why, why_size);
    if (bus == NULL) {
        return 3;
    }
    if (!exk_bus_listen(bus, EXK_CHANNEL_ALL, on_message, &self, why, why_size)) {
        exk_bus_close(bus);
        return 3;
    }
    if (!quiet) {
        fprintf(stderr, "exk-holes: listening on %s\n", url);
    }
    exk_stop_catch();
    follow(bus, &self, seconds, !quiet && exk_progress_wanted());
    exk_bus_close(bus);
    return judge_heard(&self, url, why, why_size);
}
