#define _GNU_SOURCE
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "exk/realtime.h"
#include "jitter.h"

enum { PRIORITY = 80, NOBODY = 65534, EXIT_IO = 3, COMMAND_MAX = 256 };

static void count(jitter_histogram *hist, int64_t lateness_ns)
{
    const int64_t us = lateness_ns < 0 ? 0 : lateness_ns / 1000;
    hist->n++;
    if (us < JITTER_BINS) {
        hist->bin[us]++;
    } else {
        hist->n_over++;
    }
    hist->max_us = fmax(hist->max_us, 1e-3 * (double)lateness_ns);
}

/* The pacer of exk-loop with nothing to do between two ticks. It does not hand out the tick that it
 * overslept: that one counts as late by all the periods that went by, which is the most it can have been. */
static void pace(const jitter_case *what, jitter_histogram *out)
{
    exk_rights rights;
    exk_pacer pacer;
    const int64_t n_ticks = (int64_t)(what->seconds * what->rate_Hz);
    exk_rights_ask(what->privileged ? PRIORITY : 0, what->cpu, &rights);
    exk_pacer_start(&pacer, exk_clock_monotonic(), llround(1e9 / what->rate_Hz), 0);
    while (pacer.k < n_ticks) {
        const int64_t missed_before = pacer.n_missed;
        exk_pacer_next(&pacer);
        if (pacer.n_missed > missed_before) {
            count(out, (pacer.n_missed - missed_before) * pacer.period_ns);
        }
        count(out, pacer.lateness_ns);
    }
}

static bool drop_to_nobody(void)
{
    return geteuid() != 0 || (setgid(NOBODY) == 0 && setuid(NOBODY) == 0);
}

/* In a process of its own, so that neither rights nor memory are left over from another stretch. */
int jitter_ours(const jitter_case *what, jitter_histogram *out)
{
    jitter_histogram *shared = mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE,
                                    MAP_SHARED | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
    int status = 0;
    if (shared == MAP_FAILED) {
        return EXIT_IO;
    }
    const pid_t child = fork();
    if (child == 0) {
        if (!what->privileged && !drop_to_nobody()) {
            _exit(EXIT_IO);
        }
        pace(what, shared);
        _exit(0);
    }
    const bool good = child > 0 && waitpid(child, &status, 0) == child && status == 0;
    *out = *shared;
    munmap(shared, sizeof *shared);
    return good ? 0 : EXIT_IO;
}

static void read_line(const char *line, jitter_histogram *out)
{
    unsigned long us = 0;
    unsigned long n = 0;
    double max_us = 0.0;
    if (sscanf(line, "# Max Latencies: %lf", &max_us) == 1) {
        out->max_us = max_us;
    } else if (sscanf(line, "# Histogram Overflows: %lu", &n) == 1) {
        out->n_over = n;
        out->n += n;
    } else if (line[0] != '#' && sscanf(line, "%lu %lu", &us, &n) == 2 && us < JITTER_BINS) {
        out->bin[us] += n;
        out->n += n;
    }
}

/* It refuses an ordinary user, so without rights it is still root but SCHED_OTHER and not locked. */
int jitter_theirs(const jitter_case *what, jitter_histogram *out)
{
    char command[COMMAND_MAX];
    char line[COMMAND_MAX];
    memset(out, 0, sizeof *out);
    snprintf(command, sizeof command,
             "cyclictest -q -t 1 -a %d -i %.0f -D %.0f -h %d %s 2>/dev/null", what->cpu,
             1e6 / what->rate_Hz, ceil(what->seconds), JITTER_BINS,
             what->privileged ? "-m -p 80" : "--policy=other");
    FILE *pipe = popen(command, "r");
    if (pipe == NULL) {
        return EXIT_IO;
    }
    while (fgets(line, sizeof line, pipe) != NULL) {
        read_line(line, out);
    }
    const bool good = pclose(pipe) == 0 && out->n > 0;
    if (!good) {
        fprintf(stderr, "exk-jitter: cyclictest gave nothing: is rt-tests installed, and this "
                        "user root?\n");
    }
    return good ? 0 : EXIT_IO;
}
