#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "exk/telemetry.h"
#include "messages.h"

enum { CACHE_LINE = 64, SMALLEST_RING = 16 };
static const long poll_ns = 500000;      /* publisher: looks into an empty ring this often */
static const long room_poll_ns = 100000; /* fast: looks for room in a full ring this often */

struct exk_publisher {
    exk_ring ring;
    void *slots;
    exk_messages messages;
    pthread_t thread;
    bool fast;
    int64_t t0_us;
    _Atomic bool stopping;
    _Atomic bool has_rights; /* rights is written; the publisher may read it */
    char rights[128];

    /* the control thread's own; the publisher reads them once stopping is set */
    int64_t every;
    int64_t next_seq;
    int64_t last_block; /* k / every of the newest pose sent */
    int64_t last_k;
    bool last_sent;
    bool last_dwell;
};

static void nap(long ns)
{
    const struct timespec pause = {.tv_sec = 0, .tv_nsec = ns};
    nanosleep(&pause, NULL);
}

static int64_t monotonic_us(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000 + now.tv_nsec / 1000;
}

/* How full the ring got depends on the hour; the bytes of a fast run must not. */
static exk_ring_figures figures(const exk_publisher *pub)
{
    return (exk_ring_figures){.n_dropped = (int64_t)exk_ring_dropped(&pub->ring),
                              .deepest = pub->fast ? 0 : (int64_t)pub->ring.deepest};
}

static void tick(exk_publisher *pub, int64_t now_us)
{
    if (atomic_load_explicit(&pub->has_rights, memory_order_acquire)) {
        exk_messages_set_rights(&pub->messages, pub->rights);
    }
    const exk_ring_figures ring = figures(pub);
    exk_messages_tick(&pub->messages, now_us, &ring);
}

/* At most one ring full a turn, so that status messages are not held up by a fast producer. */
static bool drain(exk_publisher *pub)
{
    size_t n = 0;
    const exk_slot *slot = exk_ring_front(&pub->ring);
    while (slot != NULL) {
        if (pub->fast) {
            tick(pub, slot->record.sample.time_us);
        }
        exk_messages_take(&pub->messages, slot);
        exk_ring_release(&pub->ring);
        slot = ++n < pub->ring.n_slots ? exk_ring_front(&pub->ring) : NULL;
    }
    return n > 0;
}

/* What was pushed before stopping was set is there to be drained after it was seen. */
static void *publish(void *ctx)
{
    exk_publisher *pub = ctx;
    bool stopping = false;
    bool busy = false;
    exk_messages_begin(&pub->messages);
    while (!stopping || busy) {
        stopping = atomic_load_explicit(&pub->stopping, memory_order_acquire);
        busy = drain(pub);
        if (!pub->fast) {
            tick(pub, monotonic_us() - pub->t0_us);
        }
        if (!stopping && !busy) {
            nap(poll_ns);
        }
    }
    const exk_ring_figures ring = figures(pub);
    exk_messages_end(&pub->messages, pub->last_k, pub->next_seq, &ring);
    return NULL;
}

static bool make_ring(exk_publisher *pub, const exk_run_info *info)
{
    const int wanted = info->profile->telemetry.ring_slots;
    const size_t n = wanted > 0 ? (size_t)wanted : SMALLEST_RING;
    const size_t bytes = (sizeof(exk_slot) + CACHE_LINE - 1) / CACHE_LINE * CACHE_LINE;
    pub->slots = aligned_alloc(CACHE_LINE, n * bytes);
    if (pub->slots == NULL) {
        return false;
    }
    memset(pub->slots, 0, n * bytes); /* touched now, so that no push meets a page fault */
    return exk_ring_init(&pub->ring, pub->slots, n, bytes) == EXK_OK;
}

static exk_publisher *give_up(exk_publisher *pub)
{
    free(pub->slots);
    free(pub);
    return NULL;
}

static void set_numbering(exk_publisher *pub, const exk_run_info *info)
{
    pub->every = info->profile->telemetry.every > 1 ? info->profile->telemetry.every : 1;
    pub->last_block = -1;
    pub->last_k = -1;
    pub->last_sent = true;
}

exk_publisher *exk_publisher_start(const exk_run_info *info, char *why, size_t why_size)
{
    const size_t bytes = (sizeof(exk_publisher) + CACHE_LINE - 1) / CACHE_LINE * CACHE_LINE;
    exk_publisher *pub = aligned_alloc(CACHE_LINE, bytes);
    if (pub == NULL) {
        snprintf(why, why_size, "no memory for the publisher");
        return NULL;
    }
    memset(pub, 0, bytes);
    pub->fast = info->fast;
    pub->t0_us = monotonic_us();
    set_numbering(pub, info);
    if (!make_ring(pub, info)) {
        snprintf(why, why_size, "no ring of %d slots: take a power of two of at least 2",
                 info->profile->telemetry.ring_slots);
        return give_up(pub);
    }
    if (!exk_messages_init(&pub->messages, info, why, why_size)) {
        return give_up(pub);
    }
    const int error = exk_helper_start(&pub->thread, publish, pub);
    if (error != 0) {
        snprintf(why, why_size, "the publisher thread cannot be started: %s", strerror(error));
        exk_outlet_close(&pub->messages.out);
        exk_messages_free(&pub->messages);
        return give_up(pub);
    }
    return pub;
}

void exk_publisher_set_rights(exk_publisher *pub, const char *text)
{
    snprintf(pub->rights, sizeof pub->rights, "%s", text);
    atomic_store_explicit(&pub->has_rights, true, memory_order_release);
}

/* Numbers the poses: the first of each block of every ticks, each judged one, and the last of a
 * dwell whose judged tick was missed. */
static void number(exk_publisher *pub, const exk_sample *s, exk_slot *slot)
{
    const bool dwell = s->phase == EXK_PHASE_DWELL;
    const int64_t block = s->k / pub->every;
    slot->previous_k = -1;
    slot->previous_seq = -1;
    slot->seq = -1;
    if (pub->last_dwell && !dwell && !pub->last_sent) {
        slot->previous_k = pub->last_k;
        slot->previous_seq = pub->next_seq++;
    }
    if (s->judged || block != pub->last_block) {
        slot->seq = pub->next_seq++;
    }
    pub->last_block = block;
    pub->last_k = s->k;
    pub->last_sent = slot->seq >= 0;
    pub->last_dwell = dwell;
}

void exk_publisher_push(exk_publisher *pub, const exk_record *record)
{
    while (pub->fast && !exk_ring_has_room(&pub->ring)) {
        nap(room_poll_ns);
    }
    exk_slot unused;
    exk_slot *slot = exk_ring_begin(&pub->ring);
    number(pub, &record->sample, slot != NULL ? slot : &unused);
    if (slot != NULL) {
        slot->record = *record;
        exk_ring_commit(&pub->ring);
    }
}

static void summarise(const exk_publisher *pub, exk_publish_summary *out)
{
    const exk_messages *m = &pub->messages;
    out->n_poses = m->n_poses;
    out->n_dropped = (int64_t)exk_ring_dropped(&pub->ring);
    out->bus_ok = m->out.bus_ok;
    out->file_ok = m->out.file_ok;
    exk_judge_summary(&m->judge, &out->accuracy);
    memcpy(out->why, m->out.why, sizeof out->why);
}

void exk_publisher_stop(exk_publisher *pub, exk_publish_summary *out)
{
    if (!pub->last_sent) {
        pub->next_seq++; /* the last sample of a run is always sent */
    }
    atomic_store_explicit(&pub->stopping, true, memory_order_release);
    pthread_join(pub->thread, NULL);
    summarise(pub, out);
    exk_messages_free(&pub->messages);
    give_up(pub);
}
