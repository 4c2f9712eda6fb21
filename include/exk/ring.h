/** Lock-free ring from one producer (the control thread) to one consumer (the publisher).
 *
 *  Order    first in, first out. push never waits: a full ring drops the record and counts it.
 *  Atomics  head and tail are C11 atomics with acquire/release, on cache lines of their own; each
 *           side keeps a copy of the other's counter and looks again only when it seems to matter,
 *           so that a push touches one shared line. Counters run on; they are never wrapped.
 *  Errors   init: EXK_ERR_ARG (slots not a power of two of at least 2, slot size 0, NULL).
 *  Memory   the caller lends n_slots * slot_bytes bytes; no allocation, no system call. Slots that
 *           start on cache lines (64 bytes) push fastest.
 */
#ifndef EXK_RING_H
#define EXK_RING_H

#include <stdalign.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/err.h"

typedef struct {
    unsigned char *slots;
    size_t n_slots;
    size_t slot_bytes;
    alignas(64) _Atomic uint64_t head; /* written by the producer */
    uint64_t tail_seen;                /* producer's copy of tail */
    _Atomic uint64_t dropped;          /* records refused by a full ring */
    alignas(64) _Atomic uint64_t tail; /* written by the consumer */
    uint64_t head_seen;                /* consumer's copy of head */
    uint64_t deepest;                  /* consumer: largest fill seen */
} exk_ring;

exk_err exk_ring_init(exk_ring *ring, void *slots, size_t n_slots, size_t slot_bytes);

/** Producer: copies slot_bytes from record; false, and counted, when the ring is full. */
bool exk_ring_push(exk_ring *ring, const void *record);

/** Producer: true when the next push will not be refused; --fast waits on it. */
bool exk_ring_has_room(exk_ring *ring);

/** Consumer: copies the oldest record out; false when the ring is empty. */
bool exk_ring_pop(exk_ring *ring, void *record);

/** Any thread: records refused so far. */
uint64_t exk_ring_dropped(const exk_ring *ring);

/** Push and pop without the copy: write into begin's slot, then commit; read from front's slot, then
 *  release. begin: NULL, and counted, when the ring is full; front: NULL when it is empty. */
void *exk_ring_begin(exk_ring *ring);
void exk_ring_commit(exk_ring *ring);
const void *exk_ring_front(exk_ring *ring);
void exk_ring_release(exk_ring *ring);

#endif
