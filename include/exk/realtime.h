/** Real time on a POSIX host: the tick grid, rights, and deadline figures.
 *
 *  Grid     tick k is due at t0 + k*period_ns on CLOCK_MONOTONIC, integers only: never drifts.
 *  Wait     clock_nanosleep to the absolute time, then an optional spin of the last part.
 *  Missed   a tick whose whole period has passed is skipped, also when that was overslept: next tick = the
 *           first not yet past. So at most one tick is run in a period: no burst to catch up.
 *  Unmet    where EXK_PACER_TRIES sleeps came back and the clock was short of the tick each time, or past
 *           the whole period of each tick tried, or where it does not move while it is looked at: the tick
 *           is handed out, marked so, and is not to be acted on.
 *  Clock    injected (exk_clock), so that the policy is tested without wall time.
 *  Figures  fixed bins, four a factor of two from 64 ns up, relaxed atomics: one writer, any reader.
 *  Memory   plain structs, no allocation.
 */
#ifndef EXK_REALTIME_H
#define EXK_REALTIME_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { EXK_PACER_TRIES = 20 };

typedef struct {
    int64_t (*now_ns)(void *ctx);
    void (*sleep_until_ns)(void *ctx, int64_t t_ns);
    void *ctx;
} exk_clock;

exk_clock exk_clock_monotonic(void);

/** Wall clock, microseconds since 1970 UTC: for stamps that leave this host, never for the grid. */
int64_t exk_wall_us(void);

typedef struct {
    exk_clock clock;
    int64_t t0_ns;
    int64_t period_ns;
    int64_t spin_ns;
    int64_t k;            /* tick last waited for, -1 before the first */
    int64_t n_missed;     /* ticks skipped in all */
    int64_t n_missed_row; /* ticks skipped since one was met without a skip before it */
    int64_t lateness_ns;  /* of the last tick */
    bool unmet;           /* the clock did not get there, or never in time */
} exk_pacer;

void exk_pacer_start(exk_pacer *pacer, exk_clock clock, int64_t period_ns, int64_t spin_ns);

/** Waits for the next tick and returns its k. */
int64_t exk_pacer_next(exk_pacer *pacer);

enum { EXK_HIST_BINS = 128 };

typedef struct {
    _Atomic uint64_t bin[EXK_HIST_BINS];
    _Atomic uint64_t n;
    _Atomic int64_t max_ns;
} exk_histogram;

void exk_histogram_add(exk_histogram *hist, int64_t value_ns);
int64_t exk_histogram_quantile_ns(const exk_histogram *hist,
                                  double p); /* upper edge of the bin */

typedef struct {
    bool fifo;
    bool locked;
    bool pinned;
    bool slack;
    char text[128]; /* "FIFO 80, memory locked, CPU 1" or what was refused and why */
} exk_rights;

/** Asks for SCHED_FIFO, locked memory, an affinity and 1 ns of timer slack for the calling thread;
 *  goes on without. Locks what is mapped now: later allocations stay possible under a small
 *  limit, so ask when everything is set up. */
void exk_rights_ask(int priority, int cpu, exk_rights *out);

/** Makes the calling thread an ordinary one on any CPU: for a helper thread started after the asking. */
void exk_rights_drop(void);

/** SCHED_FIFO for the calling thread and those it starts from now on; false: it stays ordinary. */
bool exk_rights_fifo(int priority);

/** A thread beside the control thread: an ordinary one whatever its maker is, with a stack of 1 MiB;
 *  signals stay with its maker. 0, or an errno. */
int exk_helper_start(pthread_t *thread, void *(*work)(void *ctx), void *ctx);

/** The same at a SCHED_FIFO priority, for what a step waits for; ordinary where it is refused or 0. */
int exk_helper_start_at(int priority, pthread_t *thread, void *(*work)(void *ctx), void *ctx);

#endif
