#define _POSIX_C_SOURCE 200809L
#include "exk/progress_line.h"

#include <stdarg.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { LINE_MAX_CHARS = 79 };

/* The last column stays free: some terminals wrap when it is written. */
static int line_width(void)
{
    struct winsize size;
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    return known && size.ws_col <= LINE_MAX_CHARS ? size.ws_col - 1 : LINE_MAX_CHARS;
}

bool exk_progress_wanted(void)
{
    return isatty(STDERR_FILENO) == 1;
}

void exk_progress_show(const char *format, ...)
{
    char line[LINE_MAX_CHARS + 1];
    const int width = line_width();
    va_list values;
    va_start(values, format);
    vsnprintf(line, sizeof line, format, values);
    va_end(values);
    fprintf(stderr, "\r%-*.*s", width, width, line);
    fflush(stderr);
}

void exk_progress_clear(void)
{
    fprintf(stderr, "\r%*s\r", line_width(), "");
    fflush(stderr);
}
