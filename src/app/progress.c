#define _POSIX_C_SOURCE 200809L
#include "progress.h"

#include <inttypes.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include "exk/realtime.h"

enum { LINE_MAX_CHARS = 79 };

/* What fits one line of the terminal: a longer one would wrap and leave its head behind. */
static int line_width(void)
{
    struct winsize size;
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    return known && size.ws_col <= LINE_MAX_CHARS ? size.ws_col - 1 : LINE_MAX_CHARS;
}

static void show(const loop_progress *progress)
{
    const int64_t k = atomic_load_explicit(&progress->k, memory_order_relaxed);
    const int64_t missed = atomic_load_explicit(&progress->n_missed, memory_order_relaxed);
    const int32_t hole = atomic_load_explicit(&progress->hole, memory_order_relaxed);
    char line[LINE_MAX_CHARS + 1];
    snprintf(line, sizeof line,
             "%3d %%  hole %" PRId32 " of %" PRId32 "  step %" PRId64 "  missed %" PRId64,
             (int)(100 * (k + 1) / progress->n_ticks), hole + 1, progress->n_holes, k + 1,
             missed);
    const int width = line_width();
    fprintf(stderr, "\r%-*.*s", width, width, line);
    fflush(stderr);
}

static void *watch(void *arg)
{
    loop_progress *progress = arg;
    const struct timespec pause = {.tv_nsec = 100000000};
    exk_rights_drop();
    for (int i = 0; !atomic_load(&progress->stop); i++) {
        if (i % 3 == 2) {
            show(progress);
        }
        nanosleep(&pause, NULL);
    }
    return NULL;
}

void loop_progress_start(loop_progress *progress, bool wanted)
{
    progress->shown = wanted && isatty(STDERR_FILENO) &&
                      pthread_create(&progress->thread, NULL, watch, progress) == 0;
}

void loop_progress_stop(loop_progress *progress)
{
    if (progress->shown) {
        atomic_store(&progress->stop, true);
        pthread_join(progress->thread, NULL);
        fprintf(stderr, "\r%*s\r", line_width(), "");
    }
}
