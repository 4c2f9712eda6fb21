#define _POSIX_C_SOURCE 200809L
#include "progress.h"

#include <inttypes.h>
#include <time.h>

#include "exk/progress_line.h"
#include "exk/realtime.h"

static void show(const loop_progress *progress)
{
    const int64_t k = atomic_load_explicit(&progress->k, memory_order_relaxed);
    const int64_t missed = atomic_load_explicit(&progress->n_missed, memory_order_relaxed);
    const int32_t hole = atomic_load_explicit(&progress->hole, memory_order_relaxed);
    exk_progress_show(
        "%3d %%  hole %" PRId32 " of %" PRId32 "  step %" PRId64 "  missed %" PRId64,
        (int)(100 * (k + 1) / progress->n_ticks), hole + 1, progress->n_holes, k + 1, missed);
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
    progress->shown = wanted && exk_progress_wanted() &&
                      pthread_create(&progress->thread, NULL, watch, progress) == 0;
}

void loop_progress_stop(loop_progress *progress)
{
    if (progress->shown) {
        atomic_store(&progress->stop, true);
        pthread_join(progress->thread, NULL);
        exk_progress_clear();
    }
}
