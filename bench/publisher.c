/** bench-publisher: what telemetry costs the control thread, and how much the publisher can take.
 *
 *  push     exk_publisher_push, paced at 1 and 10 kHz beside a publisher at work on bus and file.
 *  through  records a second in a fast run, where push waits for room: to a file, to the bus, to
 *           both. The bus is one of its own (UDP port as argument, default 20077), nobody listens.
 */
#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "exk/telemetry.h"

enum { N_THROUGH = 300000, N_PACED_1K = 3000, N_PACED_10K = 20000, PACED_MAX = 20000 };
static const int64_t ns_per_s = 1000000000;
static char url[64];
static char path[64];

static int64_t now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * ns_per_s + t.tv_nsec;
}

static exk_publisher *start(bool fast, bool bus, bool file)
{
    static const exk_hole hole = {
        .id = 1, .target_m = {0.0, 0.0, 1.0}, .axis = {0.0, 0.0, 1.0}};
    static exk_profile profile;
    char why[512];
    profile = (exk_profile){.name = "bench"};
    profile.timing.dt_s = 1e-3;
    profile.job.tolerance_m = 3e-5;
    profile.telemetry.every = 1;
    profile.telemetry.ring_slots = 4096;
    profile.telemetry.status_Hz = 10.0;
    const exk_run_info info = {.profile = &profile,
                               .run_id = 1,
                               .holes = &hole,
                               .n_holes = 1,
                               .n_ticks = INT64_MAX,
                               .fast = fast,
                               .url = bus ? url : NULL,
                               .record_path = file ? path : NULL};
    exk_publisher *pub = exk_publisher_start(&info, why, sizeof why);
    if (pub == NULL) {
        fprintf(stderr, "bench-publisher: %s\n", why);
        exit(3);
    }
    return pub;
}

static exk_record record_at(int64_t k)
{
    return (exk_record){.sample = {.k = k, .time_us = 1000 * k, .sensor_ok = true},
                        .state = EXK_STATE_RUN};
}

static void through(const char *what, bool bus, bool file)
{
    exk_publish_summary summary;
    exk_publisher *pub = start(true, bus, file);
    const int64_t begin_ns = now_ns();
    for (int64_t k = 0; k < N_THROUGH; k++) {
        const exk_record record = record_at(k);
        exk_publisher_push(pub, &record);
    }
    exk_publisher_stop(pub, &summary);
    const double seconds = 1e-9 * (double)(now_ns() - begin_ns);
    printf("through, %-14s %10.0f records/s  (%d in %.2f s)\n", what, N_THROUGH / seconds,
           N_THROUGH, seconds);
    unlink(path);
}

static int compare(const void *a, const void *b)
{
    const int64_t x = *(const int64_t *)a;
    const int64_t y = *(const int64_t *)b;
    return (x > y) - (x < y);
}

static void paced(int rate_Hz, int n)
{
    static int64_t took_ns[PACED_MAX];
    exk_publish_summary summary;
    exk_pacer pacer;
    exk_publisher *pub = start(false, true, true);
    exk_pacer_start(&pacer, exk_clock_monotonic(), ns_per_s / rate_Hz, 0);
    for (int i = 0; i < n; i++) {
        const exk_record record = record_at(exk_pacer_next(&pacer));
        const int64_t begin_ns = now_ns();
        exk_publisher_push(pub, &record);
        took_ns[i] = now_ns() - begin_ns;
    }
    exk_publisher_stop(pub, &summary);
    qsort(took_ns, (size_t)n, sizeof took_ns[0], compare);
    printf("push at %5d Hz  median %" PRId64 " ns, 99 %% %" PRId64 " ns, largest %" PRId64
           " ns (two clock reads included); %" PRId64 " dropped of %d\n",
           rate_Hz, took_ns[n / 2], took_ns[n - 1 - n / 100], took_ns[n - 1], summary.n_dropped,
           n);
    unlink(path);
}

int main(int argc, char **argv)
{
    snprintf(url, sizeof url, "udpm://239.255.76.67:%d?ttl=0",
             argc > 1 ? (int)strtol(argv[1], NULL, 10) : 20077);
    snprintf(path, sizeof path, "bench-publisher-%ld.lcm", (long)getpid());
    paced(1000, N_PACED_1K);
    paced(10000, N_PACED_10K);
    through("file", false, true);
    through("bus", true, false);
    through("bus and file", true, true);
    return 0;
}
