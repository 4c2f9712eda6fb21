#include "faults.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const char cut[] = "...";

void exk_faults_add(exk_faults *list, int line, const char *format, ...)
{
    const size_t stored = list->n < list->capacity ? list->n : list->capacity;
    size_t place = stored;
    while (place > 0 && list->faults[place - 1].line > line) {
        place--;
    }
    list->n++;
    if (place == list->capacity) {
        return;
    }
    const size_t last = stored < list->capacity ? stored : list->capacity - 1;
    for (size_t i = last; i > place; i--) {
        list->faults[i] = list->faults[i - 1];
    }
    exk_fault *fault = &list->faults[place];
    fault->line = line;
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(fault->message, sizeof(fault->message), format, arguments);
    va_end(arguments);
    if (length >= (int)sizeof(fault->message)) {
        memcpy(fault->message + sizeof(fault->message) - sizeof(cut), cut, sizeof(cut));
    }
}
