#define _POSIX_C_SOURCE 200809L
#include <stdlib.h>
#include <time.h>

#include "bench.h"

static volatile double sink; /* keeps the compiler from dropping the work */

static double now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;
    return (x > y) - (x < y);
}

double bench_median(double *values, size_t n)
{
    qsort(values, n, sizeof *values, compare);
    return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

static double time_round(const bench_case *c)
{
    double repeat_ns[BENCH_REPEATS];
    sink = c->run(); /* warm */
    for (int i = 0; i < BENCH_REPEATS; i++) {
        const double begin_ns = now_ns();
        sink = c->run();
        repeat_ns[i] = (now_ns() - begin_ns) / (double)c->n_calls;
    }
    return bench_median(repeat_ns, BENCH_REPEATS);
}

void bench_time(bench_case *cases, size_t n_cases)
{
    for (int round = 0; round < BENCH_ROUNDS; round++) {
        for (size_t i = 0; i < n_cases; i++) {
            cases[i].round_ns[round] = time_round(&cases[i]);
        }
    }
}
