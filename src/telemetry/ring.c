#include "exk/ring.h"

#include <string.h>

exk_err exk_ring_init(exk_ring *ring, void *slots, size_t n_slots, size_t slot_bytes)
{
    if (slots == NULL || n_slots < 2 || (n_slots & (n_slots - 1)) != 0 || slot_bytes == 0) {
        return EXK_ERR_ARG;
    }
    ring->slots = slots;
    ring->n_slots = n_slots;
    ring->slot_bytes = slot_bytes;
    atomic_init(&ring->head, 0);
    atomic_init(&ring->tail, 0);
    atomic_init(&ring->dropped, 0);
    ring->tail_seen = 0;
    ring->head_seen = 0;
    ring->deepest = 0;
    return EXK_OK;
}

static unsigned char *slot_at(const exk_ring *ring, uint64_t count)
{
    return ring->slots + (size_t)(count & (ring->n_slots - 1)) * ring->slot_bytes;
}

/* The producer owns head: relaxed reads of it are its own writes. */
bool exk_ring_has_room(exk_ring *ring)
{
    const uint64_t head = atomic_load_explicit(&ring->head, memory_order_relaxed);
    if (head - ring->tail_seen < ring->n_slots) {
        return true;
    }
    ring->tail_seen = atomic_load_explicit(&ring->tail, memory_order_acquire);
    return head - ring->tail_seen < ring->n_slots;
}

void *exk_ring_begin(exk_ring *ring)
{
    if (!exk_ring_has_room(ring)) {
        const uint64_t n = atomic_load_explicit(&ring->dropped, memory_order_relaxed);
        atomic_store_explicit(&ring->dropped, n + 1, memory_order_relaxed);
        return NULL;
    }
    return slot_at(ring, atomic_load_explicit(&ring->head, memory_order_relaxed));
}

void exk_ring_commit(exk_ring *ring)
{
    const uint64_t head = atomic_load_explicit(&ring->head, memory_order_relaxed);
    atomic_store_explicit(&ring->head, head + 1, memory_order_release);
}

bool exk_ring_push(exk_ring *ring, const void *record)
{
    void *slot = exk_ring_begin(ring);
    if (slot == NULL) {
        return false;
    }
    memcpy(slot, record, ring->slot_bytes);
    exk_ring_commit(ring);
    return true;
}

const void *exk_ring_front(exk_ring *ring)
{
    const uint64_t tail = atomic_load_explicit(&ring->tail, memory_order_relaxed);
    if (tail == ring->head_seen) {
        ring->head_seen = atomic_load_explicit(&ring->head, memory_order_acquire);
        const uint64_t fill = ring->head_seen - tail;
        if (fill == 0) {
            return NULL;
        }
        ring->deepest = fill > ring->deepest ? fill : ring->deepest;
    }
    return slot_at(ring, tail);
}

void exk_ring_release(exk_ring *ring)
{
    const uint64_t tail = atomic_load_explicit(&ring->tail, memory_order_relaxed);
    atomic_store_explicit(&ring->tail, tail + 1, memory_order_release);
}

bool exk_ring_pop(exk_ring *ring, void *record)
{
    const void *slot = exk_ring_front(ring);
    if (slot == NULL) {
        return false;
    }
    memcpy(record, slot, ring->slot_bytes);
    exk_ring_release(ring);
    return true;
}

uint64_t exk_ring_dropped(const exk_ring *ring)
{
    return atomic_load_explicit(&ring->dropped, memory_order_relaxed);
}
