/** Capture ring: the last n samples at full rate, kept for the moment something goes wrong.
 *
 *  Order   first in, first out; a full ring forgets the oldest. frozen: further samples are not taken, so
 *          that what led to a fault stays until reset.
 *  Errors  init: EXK_ERR_ARG (no slots, or NULL). at: NULL outside 0 .. count - 1.
 *  Memory  the caller lends n slots and keeps them alive; push copies one sample.
 */
#ifndef EXK_CAPTURE_H
#define EXK_CAPTURE_H

#include <stdbool.h>
#include <stddef.h>

#include "exk/err.h"
#include "exk/sample.h"

typedef struct {
    exk_sample *slots;
    size_t n_slots;
    size_t next;    /* slot of the next sample */
    size_t n_taken; /* at most n_slots */
    bool frozen;
} exk_capture;

exk_err exk_capture_init(exk_capture *capture, exk_sample *slots, size_t n_slots);
void exk_capture_reset(exk_capture *capture);
void exk_capture_push(exk_capture *capture, const exk_sample *sample);
void exk_capture_freeze(exk_capture *capture);
size_t exk_capture_count(const exk_capture *capture);

/** i = 0 is the oldest. */
const exk_sample *exk_capture_at(const exk_capture *capture, size_t i);

#endif
