#include "text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

exk_text exk_text_start(char *out, size_t size)
{
    if (size > 0) {
        out[0] = '\0';
    }
    return (exk_text){out, size, 0};
}

void exk_text_add(exk_text *text, const char *format, ...)
{
    const size_t room = text->length < text->size ? text->size - text->length : 0;
    va_list arguments;
    va_start(arguments, format);
    const int n =
        vsnprintf(room > 0 ? text->out + text->length : NULL, room, format, arguments);
    va_end(arguments);
    text->length += n > 0 ? (size_t)n : 0;
}

void exk_text_add_quoted(exk_text *text, const char *found)
{
    enum { SHOWN = 40 };
    char shown[SHOWN + 1];
    size_t n = 0;
    for (; n < SHOWN && found[n] != '\0'; n++) {
        const unsigned char c = (unsigned char)found[n];
        shown[n] = c < 0x20 || c == 0x7f ? '?' : found[n];
    }
    shown[n] = '\0';
    exk_text_add(text, "\"%s%s\"", shown, found[n] == '\0' ? "" : "...");
}
