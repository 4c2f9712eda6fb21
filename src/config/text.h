/** A text written piece by piece into a lent buffer, like snprintf: what does not fit is counted.
 *
 *  Memory  the caller lends the buffer; with size > 0 it always ends in a NUL.
 */
#ifndef EXK_CONFIG_TEXT_H
#define EXK_CONFIG_TEXT_H

#include <stddef.h>

#if defined(__GNUC__)
#define EXK_PRINTF(format_index, first_argument)                                               \
    __attribute__((format(printf, format_index, first_argument)))
#else
#define EXK_PRINTF(format_index, first_argument)
#endif

typedef struct {
    char *out;
    size_t size;
    size_t length; /* of the whole text, without the NUL */
} exk_text;

exk_text exk_text_start(char *out, size_t size);

/** Numbers go through exk_number_write: no %f, %g here, so that no locale can show. */
void exk_text_add(exk_text *text, const char *format, ...) EXK_PRINTF(2, 3);

/** What a user wrote, quoted and safe to print: control characters become '?', long ones end in
 *  "...". */
void exk_text_add_quoted(exk_text *text, const char *found);

#endif
