#include "pace.h"

#include <inttypes.h>

#include "exk/progress_line.h"
#include "now.h"

static const double every_s = 0.25;

void study_pace_begin(study_pace *pace, const char *name, uint64_t n_before, uint64_t n_all,
                      uint64_t scale, bool quiet)
{
    *pace = (study_pace){.name = name,
                         .n_before = n_before,
                         .n_all = n_all,
                         .scale = scale,
                         .begin_s = exk_now_s(),
                         .shown = !quiet && exk_progress_wanted()};
}

static void show(const study_pace *pace, double now)
{
    const double here = (double)(pace->n_here * pace->scale);
    const double rate = here / (now - pace->begin_s);
    const double all = (double)pace->n_all;
    const double left = all - (double)pace->n_before - here;
    const double done = left > 0.0 ? all - left : all;
    exk_progress_show("%s: %3.0f %%, %.0f s left, %.0f of %" PRIu64 " trials, %.0f a second",
                      pace->name, 100.0 * done / all, left > 0.0 ? left / rate : 0.0, done,
                      pace->n_all, rate);
}

void study_pace_step(study_pace *pace)
{
    pace->n_here++;
    if (!pace->shown) {
        return;
    }
    const double now = exk_now_s();
    if (now - pace->shown_s >= every_s) {
        pace->shown_s = now;
        show(pace, now);
    }
}

void study_pace_end(study_pace *pace)
{
    if (pace->shown && pace->shown_s > 0.0) {
        exk_progress_clear();
    }
}
