/** Lock-free ring from one producer (the control thread) to one consumer (the publisher).
 *
 *  Order    first in, first out. push never waits: a full ring drops the record and counts it.
 *  Atomics  head and tail are C11 atomics with acquire/release, on cache lines of their own.
 *  Errors   init: EXK_ERR_ARG (slots not a power of two of at least 2, slot size 0).
 *  Memory   the caller lends n_slots * slot_bytes bytes; no allocation, no system call.
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
bool exk_ring_push(exk_ring *ring, const void *record);
bool exk_ring_has_room(exk_ring *ring); /* producer side; --fast waits on it */
bool exk_ring_pop(exk_ring *ring, void *record);
uint64_t exk_ring_dropped(const exk_ring *ring);

#endif
