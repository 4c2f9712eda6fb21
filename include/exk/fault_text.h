/** A fault in words: what, which, value, limit, where, what to do.
 *
 *  "commanded leg speed of leg 2: 0.612 m/s, limit 0.5 m/s; tick 1234, drill of hole 7; lower the ..."
 *  Memory  the caller lends the text; it is cut where it does not fit.
 */
#ifndef EXK_FAULT_TEXT_H
#define EXK_FAULT_TEXT_H

#include <stddef.h>

#include "exk/loop.h"

enum { EXK_FAULT_TEXT_MAX = 256 };

void exk_fault_text(const exk_fault_report *report, char *out, size_t size);

#endif
