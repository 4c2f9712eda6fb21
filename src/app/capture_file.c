#define _POSIX_C_SOURCE 200809L
#include "capture_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "exk/capture_file.h"
#include "exk/progress_line.h"

const double loop_capture_s = 2.0;
enum { LOOK_NS = 50000000, ENDING_MAX = 32 };

/* run.lcm -> run.fault.lcm, run.fault2.lcm, ... */
static char *name_beside(const char *record, int n_before)
{
    static const char ending[] = ".lcm";
    char added[ENDING_MAX] = ".fault.lcm";
    const size_t length = strlen(record);
    const size_t tail = sizeof ending - 1;
    const bool ends = length > tail && strcmp(record + length - tail, ending) == 0;
    const size_t stem = ends ? length - tail : length;
    char *name = malloc(stem + sizeof added);
    if (n_before > 0) {
        snprintf(added, sizeof added, ".fault%d.lcm", n_before + 1);
    }
    if (name != NULL) {
        memcpy(name, record, stem);
        memcpy(name + stem, added, sizeof added);
    }
    return name;
}

static bool write_to(const char *path, const loop_ticks *t, const exk_run_info *info)
{
    char why[512];
    const exk_capture *capture = &t->rig->capture;
    const bool good =
        exk_capture_file_write(path, info, capture, &t->fault_record, why, sizeof why);
    if (t->progress.shown) {
        exk_progress_clear();
    }
    if (!good) {
        fprintf(stderr, "exk-loop: the samples before the fault are not kept: %s\n", why);
        return false;
    }
    fprintf(stderr, "exk-loop: the %zu samples before the fault, at full rate: %s\n",
            exk_capture_count(capture), path);
    return true;
}

static bool write_next(const loop_keeper *keeper)
{
    const exk_run_info *info = keeper->info;
    char *path = name_beside(info->record_path, keeper->n_files);
    const size_t length = exk_profile_print(info->profile, NULL, 0);
    char *text = malloc(length + 1);
    bool good = path != NULL && text != NULL;
    if (good) {
        exk_run_info copy = *info;
        exk_profile_print(info->profile, text, length + 1);
        copy.profile_text = text;
        good = write_to(path, keeper->ticks, &copy);
    }
    free(text);
    free(path);
    return good;
}

static void write_if_lent(loop_keeper *keeper)
{
    loop_ticks *t = keeper->ticks;
    if (atomic_load_explicit(&t->ring, memory_order_acquire) != LOOP_RING_LENT) {
        return;
    }
    if (exk_capture_count(&t->rig->capture) > 0) {
        keeper->failed = !write_next(keeper) || keeper->failed;
        keeper->n_files++;
    }
    atomic_store_explicit(&t->ring, LOOP_RING_WRITTEN, memory_order_release);
}

static void *watch(void *ctx)
{
    loop_keeper *keeper = ctx;
    const struct timespec pause = {.tv_nsec = LOOK_NS};
    exk_rights_drop();
    while (!atomic_load(&keeper->stop)) {
        write_if_lent(keeper);
        nanosleep(&pause, NULL);
    }
    return NULL;
}

void loop_keeper_start(loop_keeper *keeper, loop_ticks *ticks, const exk_run_info *info)
{
    *keeper = (loop_keeper){.ticks = ticks, .info = info};
    keeper->has_thread = info->record_path != NULL && ticks->inbox != NULL &&
                         exk_helper_start(&keeper->thread, watch, keeper) == 0;
}

bool loop_keeper_stop(loop_keeper *keeper)
{
    if (keeper->has_thread) {
        atomic_store(&keeper->stop, true);
        pthread_join(keeper->thread, NULL);
    }
    write_if_lent(keeper);
    return !keeper->failed;
}
