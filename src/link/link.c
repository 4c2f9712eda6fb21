#define _DEFAULT_SOURCE
#include <inttypes.h>
#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>

#include "exk/realtime.h"
#include "link_state.h"

enum { HELLO_EVERY_MS = 20, CACHE_LINE = 64 };
static const int64_t ask_again_ns = 50000000;
static const int64_t ns_per_s = 1000000000;

static int64_t now_ns(void)
{
    const exk_clock clock = exk_clock_monotonic();
    return clock.now_ns(clock.ctx);
}

/* Fast runs of one profile have one run_id; what is left of an earlier one must not be taken for ours. */
static int64_t new_session(void)
{
    int64_t session = 0;
    if (getrandom(&session, sizeof session, GRND_NONBLOCK) != (ssize_t)sizeof session) {
        session = exk_wall_us() ^ now_ns() << 20;
    }
    return session;
}

bool link_transmit(exk_link *link, exk_drive_kind kind, const link_drive *drive)
{
    const double time_us = (double)drive->k * link->cfg.dt_s * 1e6;
    const exk_wire_drive message = {
        .stamp = {link->cfg.run_id, drive->seq, drive->k, drive->k > 0 ? llround(time_us) : 0},
        .session_id = link->session_id,
        .which = link->cfg.which,
        .kind = kind,
        .drive = drive->drive,
    };
    unsigned char buffer[EXK_WIRE_DRIVE_MAX];
    const int bytes = exk_wire_drive_encode(&message, buffer, sizeof buffer);
    return bytes > 0 && exk_bus_send(link->out, EXK_CHANNEL_DRIVE, buffer, (size_t)bytes);
}

void link_number(exk_link *link, link_drive *drive)
{
    drive->seq = link->next_seq++;
    atomic_store_explicit(&link->last_k, drive->k, memory_order_relaxed);
    atomic_store_explicit(&link->last_seq, drive->seq, memory_order_release);
}

/* A machine answers each drive once, so that seq cannot run ahead of what was sent. */
static bool is_answer(const exk_link *link, const exk_wire_sensor *m)
{
    const int64_t last_seq = atomic_load_explicit(&link->last_seq, memory_order_acquire);
    const int64_t last_k = atomic_load_explicit(&link->last_k, memory_order_relaxed);
    return m->stamp.run_id == link->cfg.run_id && m->session_id == link->session_id &&
           m->drive_seq >= 0 && m->drive_seq <= last_seq && m->stamp.seq <= m->drive_seq &&
           m->stamp.k <= last_k && (!link->has_machine || m->machine_id == link->machine_id);
}

static void publish_counts(exk_link *link)
{
    atomic_store_explicit(&link->n_lost, link->arrivals.n_lost, memory_order_relaxed);
    atomic_store_explicit(&link->n_repeated, link->arrivals.n_repeated, memory_order_relaxed);
    atomic_store_explicit(&link->n_reordered, link->arrivals.n_reordered, memory_order_relaxed);
}

static void take_answer(exk_link *link, const exk_wire_sensor *m)
{
    const link_answer answer = {.k = m->stamp.k, .reading = m->reading};
    exk_ring_push(&link->answers, &answer); /* full: missing, as if it had been lost */
}

void link_receive(void *ctx, const char *channel, const void *data, size_t bytes,
                  int64_t received_us)
{
    exk_link *link = ctx;
    exk_wire_sensor m;
    (void)channel;
    (void)received_us;
    if (!exk_wire_sensor_decode(data, bytes, &m) || !is_answer(link, &m)) {
        atomic_fetch_add_explicit(&link->n_foreign, 1, memory_order_relaxed);
        return;
    }
    const exk_arrival arrival = exk_arrivals_take(&link->arrivals, m.stamp.seq);
    publish_counts(link);
    if (m.stamp.k < 0) {
        link->machine_id = m.machine_id;
        link->has_machine = true;
    } else if (arrival != EXK_ARRIVAL_REPEATED) {
        take_answer(link, &m);
    }
}

static bool greet(exk_link *link, char *why, size_t why_size)
{
    const int64_t until_ns = now_ns() + (int64_t)(link->cfg.answer_s * (double)ns_per_s);
    while (!link->has_machine) {
        link_drive hello = {.k = -1};
        link_number(link, &hello);
        link_transmit(link, EXK_DRIVE_HELLO, &hello);
        if (exk_bus_wait(link->in, HELLO_EVERY_MS) < 0 || now_ns() > until_ns) {
            snprintf(why, why_size,
                     "no machine answers on %s within %g s: start one first, for example "
                     "exk-twin PROFILE, or take --source twin",
                     link->cfg.url, link->cfg.answer_s);
            return false;
        }
    }
    return true;
}

/* LCM starts a thread of its own here, which gets the rights of its maker: an answer passes through it. */
static bool listen_to_machine(exk_link *link, char *why, size_t why_size)
{
    struct sched_param own = {0};
    const int policy = sched_getscheduler(0);
    const bool asked = !link->cfg.fast && policy >= 0 && sched_getparam(0, &own) == 0 &&
                       exk_rights_fifo(link->cfg.priority - 1);
    const bool good =
        exk_bus_listen(link->in, EXK_CHANNEL_SENSOR, link_receive, link, why, why_size);
    if (asked) {
        sched_setscheduler(0, policy, &own);
    }
    return good;
}

static bool open_buses(exk_link *link, char *why, size_t why_size)
{
    link->in = exk_bus_open(link->cfg.url, true, why, why_size);
    if (link->in == NULL || !listen_to_machine(link, why, why_size)) {
        return false;
    }
    link->out = link->cfg.fast ? link->in : exk_bus_open(link->cfg.url, false, why, why_size);
    return link->out != NULL;
}

static bool start(exk_link *link, char *why, size_t why_size)
{
    exk_arrivals_init(&link->arrivals);
    exk_ring_init(&link->drives, link->drive_slots, LINK_SLOTS, sizeof link->drive_slots[0]);
    exk_ring_init(&link->answers, link->answer_slots, LINK_SLOTS, sizeof link->answer_slots[0]);
    if (!open_buses(link, why, why_size) || !greet(link, why, why_size)) {
        return false;
    }
    const int error = link->cfg.fast ? 0 : link_start_threads(link);
    if (error != 0) {
        snprintf(why, why_size, "the threads of the machine's link cannot be started: %s",
                 strerror(error));
    }
    return error == 0;
}

exk_link *exk_link_open(const exk_link_config *cfg, char *why, size_t why_size)
{
    const size_t bytes = (sizeof(exk_link) + CACHE_LINE - 1) / CACHE_LINE * CACHE_LINE;
    exk_link *link = aligned_alloc(CACHE_LINE, bytes);
    if (link == NULL) {
        snprintf(why, why_size, "no memory for the machine's link");
        return NULL;
    }
    memset(link, 0, bytes); /* touched now, so that no step meets a page fault */
    link->cfg = *cfg;
    link->session_id = new_session();
    if (!start(link, why, why_size)) {
        exk_link_close(link);
        return NULL;
    }
    return link;
}

void exk_link_close(exk_link *link)
{
    if (link == NULL) {
        return;
    }
    link_stop_threads(link);
    if (link->has_machine) {
        link_drive bye = {.k = -2};
        link_number(link, &bye);
        link_transmit(link, EXK_DRIVE_BYE, &bye);
    }
    if (link->out != link->in) {
        exk_bus_close(link->out);
    }
    exk_bus_close(link->in);
    free(link);
}

static bool answered(exk_link *link, int64_t k, exk_reading *out)
{
    link_answer answer;
    bool found = false;
    while (exk_ring_pop(&link->answers, &answer)) {
        if (answer.k == k) {
            *out = answer.reading;
            found = true;
        }
    }
    return found;
}

static exk_err exchange(void *ctx, int64_t k, const exk_drive *drive, exk_reading *out)
{
    exk_link *link = ctx;
    const int64_t begin_ns = now_ns();
    const int64_t until_ns = begin_ns + (int64_t)(link->cfg.answer_s * (double)ns_per_s);
    int64_t ask_ns = begin_ns;
    for (int64_t t_ns = begin_ns; t_ns < until_ns; t_ns = now_ns()) {
        if (t_ns >= ask_ns) {
            link_drive asked = {.k = k, .drive = *drive};
            link_number(link, &asked);
            link_transmit(link, EXK_DRIVE_STEP, &asked);
            ask_ns = t_ns + ask_again_ns;
        }
        if (exk_bus_wait(link->in, (int)(ask_again_ns / 1000000)) < 0) {
            return EXK_ERR_SILENT;
        }
        if (answered(link, k, out)) {
            return EXK_OK;
        }
    }
    return EXK_ERR_SILENT;
}

exk_source exk_link_source(exk_link *link)
{
    return (exk_source){.exchange = exchange, .ctx = link};
}

void exk_link_send(exk_link *link, int64_t k, const exk_drive *drive)
{
    link_drive slot = {.k = k, .drive = *drive};
    link_number(link, &slot);
    exk_ring_push(&link->drives, &slot); /* full: the machine sees a gap in seq */
}

/* What is too late for its own tick is handed on when nothing better came: the guard tells late,
 * repeated and missing apart by its age. */
void exk_link_collect(exk_link *link, int64_t k, exk_reading *out)
{
    link_answer answer;
    int64_t best = -1;
    *out = (exk_reading){.fresh = false};
    while (exk_ring_pop(&link->answers, &answer)) {
        link->n_late += answer.k != k ? 1 : 0;
        if (answer.k > best) {
            best = answer.k;
            *out = answer.reading;
            out->age += k - answer.k;
        }
    }
}

void exk_link_counts_so_far(const exk_link *link, exk_link_counts *out)
{
    out->n_lost = atomic_load_explicit(&link->n_lost, memory_order_relaxed);
    out->n_repeated = atomic_load_explicit(&link->n_repeated, memory_order_relaxed);
    out->n_reordered = atomic_load_explicit(&link->n_reordered, memory_order_relaxed);
    out->n_foreign = atomic_load_explicit(&link->n_foreign, memory_order_relaxed);
    out->n_late = link->n_late;
}

int64_t exk_link_dropped(const exk_link *link)
{
    return atomic_load_explicit(&link->n_dropped, memory_order_relaxed);
}
