#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exk/bus.h"
#include "exk/command.h"
#include "exk/realtime.h"
#include "exk/ring.h"

enum { SLOTS = 16, WAIT_MS = 50, CACHE_LINE = 64, URL_MAX = 1024 };
static const int64_t look_us = 250000; /* how often the system is asked for its drops */

struct exk_inbox {
    exk_ring ring;
    exk_command slots[SLOTS];
    exk_bus *bus;
    exk_gate gate; /* the reader's */
    _Atomic int64_t n_taken;
    _Atomic int64_t last_seq;
    _Atomic int64_t n_refused[EXK_REFUSED_COUNT];
    _Atomic int64_t n_dropped;
    char url[URL_MAX];
    pthread_t reader;
    bool has_reader;
    _Atomic bool stopping;
};

static void publish_counts(exk_inbox *inbox)
{
    const exk_command_counts *counts = &inbox->gate.counts;
    atomic_store_explicit(&inbox->n_taken, counts->n_taken, memory_order_relaxed);
    atomic_store_explicit(&inbox->last_seq, counts->last_seq, memory_order_relaxed);
    for (int i = 0; i < EXK_REFUSED_COUNT; i++) {
        atomic_store_explicit(&inbox->n_refused[i], counts->n_refused[i], memory_order_relaxed);
    }
}

/* The message's own time of arrival may be long ago when a flood has filled the queue: freshness is
 * asked of the clock now. */
static void receive(void *ctx, const char *channel, const void *data, size_t bytes,
                    int64_t received_us)
{
    exk_inbox *inbox = ctx;
    const exk_command_counts before = inbox->gate.counts;
    exk_command command;
    (void)channel;
    (void)received_us;
    if (exk_gate_pass(&inbox->gate, data, bytes, exk_wall_us(), &command) &&
        !exk_ring_push(&inbox->ring, &command)) {
        inbox->gate.counts = before;
        inbox->gate.counts.n_refused[EXK_REFUSED_FULL]++;
    }
    publish_counts(inbox);
}

static void *read_commands(void *ctx)
{
    exk_inbox *inbox = ctx;
    int64_t next_us = 0;
    while (!atomic_load_explicit(&inbox->stopping, memory_order_acquire)) {
        if (exk_wall_us() >= next_us) {
            next_us = exk_wall_us() + look_us;
            atomic_store_explicit(&inbox->n_dropped, exk_bus_dropped(inbox->url),
                                  memory_order_relaxed);
        }
        if (exk_bus_wait(inbox->bus, WAIT_MS) < 0) {
            break; /* no more commands: the watchdog of the run holds it */
        }
    }
    return NULL;
}

static bool start(exk_inbox *inbox, const char *url, char *why, size_t why_size)
{
    inbox->bus = exk_bus_open(url, true, why, why_size);
    if (inbox->bus == NULL ||
        !exk_bus_listen(inbox->bus, EXK_CHANNEL_COMMAND, receive, inbox, why, why_size)) {
        return false;
    }
    const int error = exk_helper_start(&inbox->reader, read_commands, inbox);
    inbox->has_reader = error == 0;
    if (error != 0) {
        snprintf(why, why_size, "the thread for commands cannot be started: %s",
                 strerror(error));
    }
    return error == 0;
}

exk_inbox *exk_inbox_open(const char *url, const exk_gate *gate, char *why, size_t why_size)
{
    const size_t bytes = (sizeof(exk_inbox) + CACHE_LINE - 1) / CACHE_LINE * CACHE_LINE;
    exk_inbox *inbox = aligned_alloc(CACHE_LINE, bytes);
    if (inbox == NULL) {
        snprintf(why, why_size, "no memory for commands");
        return NULL;
    }
    memset(inbox, 0, bytes);
    inbox->gate = *gate;
    snprintf(inbox->url, sizeof inbox->url, "%s", url);
    exk_ring_init(&inbox->ring, inbox->slots, SLOTS, sizeof inbox->slots[0]);
    if (!start(inbox, url, why, why_size)) {
        exk_inbox_close(inbox);
        return NULL;
    }
    return inbox;
}

void exk_inbox_close(exk_inbox *inbox)
{
    if (inbox == NULL) {
        return;
    }
    atomic_store_explicit(&inbox->stopping, true, memory_order_release);
    if (inbox->has_reader) {
        pthread_join(inbox->reader, NULL);
    }
    exk_bus_close(inbox->bus);
    exk_key_wipe(&inbox->gate.key);
    free(inbox);
}

bool exk_inbox_take(exk_inbox *inbox, exk_command *out)
{
    return exk_ring_pop(&inbox->ring, out);
}

void exk_inbox_counts(const exk_inbox *inbox, exk_command_counts *out)
{
    out->n_taken = atomic_load_explicit(&inbox->n_taken, memory_order_relaxed);
    out->last_seq = atomic_load_explicit(&inbox->last_seq, memory_order_relaxed);
    for (int i = 0; i < EXK_REFUSED_COUNT; i++) {
        out->n_refused[i] = atomic_load_explicit(&inbox->n_refused[i], memory_order_relaxed);
    }
}

int64_t exk_inbox_dropped(const exk_inbox *inbox)
{
    return atomic_load_explicit(&inbox->n_dropped, memory_order_relaxed);
}
