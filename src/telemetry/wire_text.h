/** Looking over a message before LCM's decoder sees it.
 *
 *  The generated decoders allocate whatever a count or a string length claims, so a damaged message
 *  could ask for gigabytes. These helpers walk the parts of variable length first, inside the bytes
 *  that are there. Numbers on the wire are big-endian.
 */
#ifndef EXK_WIRE_TEXT_H
#define EXK_WIRE_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Steps over one string at *at; false when it is not whole and terminated within bytes. */
bool exk_wire_skip_text(const void *data, size_t bytes, size_t *at);

/** The 32-bit integer at byte at; the caller has checked that it is there. */
int32_t exk_wire_int_at(const void *data, size_t at);

/** Copies at most size - 1 characters and ends with NUL. */
void exk_wire_copy_text(char *to, size_t size, const char *from);

#endif
