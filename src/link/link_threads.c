#define _POSIX_C_SOURCE 200809L
#include <sys/prctl.h>
#include <time.h>

#include "exk/realtime.h"
#include "link_state.h"

enum { READER_WAIT_MS = 50 };
static const int64_t look_us = 250000; /* how often the system is asked for its drops */
static const double polls_per_tick = 20.0;
static const double poll_min_s = 10e-6;
static const double poll_max_s = 200e-6;

static void *read_answers(void *ctx)
{
    exk_link *link = ctx;
    int64_t next_us = 0;
    while (!atomic_load_explicit(&link->stopping, memory_order_acquire)) {
        if (exk_wall_us() >= next_us) {
            next_us = exk_wall_us() + look_us;
            atomic_store_explicit(&link->n_dropped, exk_bus_dropped(link->cfg.url),
                                  memory_order_relaxed);
        }
        if (exk_bus_wait(link->in, READER_WAIT_MS) < 0) {
            break; /* silence from here on: the guard of the loop counts it */
        }
    }
    return NULL;
}

static struct timespec poll_pause(const exk_link *link)
{
    double pause_s = link->cfg.dt_s / polls_per_tick;
    pause_s = pause_s < poll_min_s ? poll_min_s : pause_s > poll_max_s ? poll_max_s : pause_s;
    return (struct timespec){.tv_nsec = (long)(pause_s * 1e9)};
}

/* Polls: waking it would cost the control thread a system call. */
static void *write_drives(void *ctx)
{
    exk_link *link = ctx;
    const struct timespec pause = poll_pause(link);
    link_drive drive;
    prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
    while (!atomic_load_explicit(&link->stopping, memory_order_acquire)) {
        while (exk_ring_pop(&link->drives, &drive)) {
            link_transmit(link, EXK_DRIVE_STEP, &drive);
        }
        nanosleep(&pause, NULL);
    }
    return NULL;
}

int link_start_threads(exk_link *link)
{
    const int priority = link->cfg.priority - 1;
    int error = exk_helper_start_at(priority, &link->reader, read_answers, link);
    link->has_reader = error == 0;
    if (error == 0) {
        error = exk_helper_start_at(priority, &link->writer, write_drives, link);
        link->has_writer = error == 0;
    }
    return error;
}

void link_stop_threads(exk_link *link)
{
    atomic_store_explicit(&link->stopping, true, memory_order_release);
    if (link->has_reader) {
        pthread_join(link->reader, NULL);
    }
    if (link->has_writer) {
        pthread_join(link->writer, NULL);
    }
}
