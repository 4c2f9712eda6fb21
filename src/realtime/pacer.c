#define _POSIX_C_SOURCE 200809L
#include "exk/realtime.h"

#include <errno.h>
#include <time.h>

static const int64_t ns_per_s = 1000000000;
static const long still_looks = 1000000; /* ms at the least, whatever the clock costs */

static int64_t monotonic_now(void *ctx)
{
    (void)ctx;
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * ns_per_s + now.tv_nsec;
}

static void monotonic_sleep(void *ctx, int64_t t_ns)
{
    (void)ctx;
    const struct timespec until = {.tv_sec = (time_t)(t_ns / ns_per_s),
                                   .tv_nsec = (long)(t_ns % ns_per_s)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL) == EINTR) {
    }
}

exk_clock exk_clock_monotonic(void)
{
    return (exk_clock){.now_ns = monotonic_now, .sleep_until_ns = monotonic_sleep};
}

void exk_pacer_start(exk_pacer *pacer, exk_clock clock, int64_t period_ns, int64_t spin_ns)
{
    *pacer = (exk_pacer){.clock = clock, .period_ns = period_ns, .spin_ns = spin_ns, .k = -1};
    pacer->t0_ns = clock.now_ns(clock.ctx) + period_ns;
}

/* The tick to run next: the following one, or the first whose time is still to come when the whole
 * period of the following one has gone by. */
static int64_t choose(const exk_pacer *pacer, int64_t now_ns)
{
    const int64_t next = pacer->k + 1;
    const int64_t since_ns = now_ns - pacer->t0_ns;
    if (since_ns < (next + 1) * pacer->period_ns) {
        return next;
    }
    return since_ns / pacer->period_ns + 1;
}

static int64_t sleep_until(const exk_pacer *pacer, int64_t t_ns, int64_t now_ns)
{
    const exk_clock *clock = &pacer->clock;
    for (int i = 0; i < EXK_PACER_TRIES && now_ns < t_ns; i++) {
        clock->sleep_until_ns(clock->ctx, t_ns);
        now_ns = clock->now_ns(clock->ctx);
    }
    return now_ns;
}

/* Looks at the clock until the time has come, or until it has not moved for many looks. */
static int64_t spin_until(const exk_pacer *pacer, int64_t t_ns, int64_t now_ns)
{
    const exk_clock *clock = &pacer->clock;
    int64_t last_ns = now_ns;
    for (long same = 0; now_ns < t_ns && same < still_looks; same++) {
        now_ns = clock->now_ns(clock->ctx);
        same = now_ns > last_ns ? 0 : same;
        last_ns = now_ns;
    }
    return now_ns;
}

static int64_t wait_until(const exk_pacer *pacer, int64_t due_ns, int64_t now_ns)
{
    const int64_t woken_ns = sleep_until(pacer, due_ns - pacer->spin_ns, now_ns);
    const bool there = woken_ns >= due_ns - pacer->spin_ns;
    return there && pacer->spin_ns > 0 ? spin_until(pacer, due_ns, woken_ns) : woken_ns;
}

/* The first tick that is reached within its own period: one that was overslept is missed too. Where each
 * is overslept, as by a period below what the host's timers can do, the search ends. */
int64_t exk_pacer_next(exk_pacer *pacer)
{
    const int64_t before = pacer->k;
    int64_t now_ns = pacer->clock.now_ns(pacer->clock.ctx);
    int n_tries = 0;
    do {
        pacer->k = choose(pacer, now_ns);
        const int64_t due_ns = pacer->t0_ns + pacer->k * pacer->period_ns;
        now_ns = wait_until(pacer, due_ns, now_ns);
        pacer->lateness_ns = now_ns - due_ns;
        n_tries++;
    } while (pacer->lateness_ns >= pacer->period_ns && n_tries < EXK_PACER_TRIES);
    const int64_t missed = pacer->k - (before + 1);
    pacer->n_missed += missed;
    pacer->n_missed_row = missed > 0 ? pacer->n_missed_row + missed : 0;
    pacer->unmet = pacer->lateness_ns < 0 || pacer->lateness_ns >= pacer->period_ns;
    return pacer->k;
}
