/** "1 message", "2 messages": the s that a count of things takes in a report. */
#ifndef EXK_PLURAL_H
#define EXK_PLURAL_H

#include <stdint.h>

static inline const char *exk_plural_s(int64_t n)
{
    return n == 1 ? "" : "s";
}

#endif
