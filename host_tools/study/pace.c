#define _POSIX_C_SOURCE 200809L
#include "pace.h"

#include <inttypes.h>
#include <stdio.h>
#include <time.h>

#include "terminal.h"

static const double every_s = 0.25;

static double now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void study_pace_begin(study_pace *pace, const char *name, uint64_t n_before, uint64_t n_all,
                      uint64_t scale, bool quiet)
{
    *pace = (study_pace){.name = name,
                         .n_before = n_before,
                         .n_all = n_all,
                         .scale = scale,
                         .begin_s = now_s(),
                         .shown = !quiet && exk_is_terminal(stderr)};
}

static void show(const study_pace *pace, double now)
{
    const double here = (double)(pace->n_here * pace->scale);
    const double rate = here / (now - pace->begin_s);
    const double all = (double)pace->n_all;
    const double left = all - (double)pace->n_before - here;
    const double done = left > 0.0 ? all - left : all;
    fprintf(stderr, "\r%s: %3.0f %%, %.0f of %" PRIu64 " trials, %.0f a second, %.0f s left ",
            pace->name, 100.0 * done / all, done, pace->n_all, rate,
            left > 0.0 ? left / rate : 0.0);
    fflush(stderr);
}

void study_pace_step(study_pace *pace)
{
    pace->n_here++;
    if (!pace->shown) {
        return;
    }
    const double now = now_s();
    if (now - pace->shown_s >= every_s) {
        pace->shown_s = now;
        show(pace, now);
    }
}

void study_pace_end(study_pace *pace)
{
    if (pace->shown && pace->shown_s > 0.0) {
        fprintf(stderr, "\r%79s\r", "");
    }
}
