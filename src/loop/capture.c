#include "exk/capture.h"

exk_err exk_capture_init(exk_capture *c, exk_sample *slots, size_t n_slots)
{
    if (slots == NULL || n_slots == 0) {
        return EXK_ERR_ARG;
    }
    *c = (exk_capture){.slots = slots, .n_slots = n_slots};
    return EXK_OK;
}

void exk_capture_reset(exk_capture *c)
{
    c->next = 0;
    c->n_taken = 0;
    c->frozen = false;
}

void exk_capture_push(exk_capture *c, const exk_sample *sample)
{
    if (c->frozen) {
        return;
    }
    c->slots[c->next] = *sample;
    c->next = c->next + 1 < c->n_slots ? c->next + 1 : 0;
    c->n_taken += c->n_taken < c->n_slots ? 1 : 0;
}

void exk_capture_freeze(exk_capture *c)
{
    c->frozen = true;
}

size_t exk_capture_count(const exk_capture *c)
{
    return c->n_taken;
}

const exk_sample *exk_capture_at(const exk_capture *c, size_t i)
{
    if (i >= c->n_taken) {
        return NULL;
    }
    const size_t oldest = c->n_taken < c->n_slots ? 0 : c->next;
    const size_t to_end = c->n_slots - oldest;
    return i < to_end ? &c->slots[oldest + i] : &c->slots[i - to_end];
}
