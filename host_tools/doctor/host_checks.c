#define _DEFAULT_SOURCE
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include "checks.h"
#include "exk/profile.h"
#include "exk/realtime.h"

enum { N_TICKS = 400 };
static const int64_t tick_ns = 1000000;

static void check_rights(findings *all, const exk_rights *rights, int priority)
{
    finding *fifo = finding_add(all, "schedule");
    finding *memory = finding_add(all, "memory");
    struct rlimit limit = {0};
    getrlimit(RLIMIT_MEMLOCK, &limit);
    snprintf(fifo->found, sizeof fifo->found, "SCHED_FIFO %d is %s", priority,
             rights->fifo ? "granted"
                          : "refused: the loop shares the processor with everything");
    if (!rights->fifo) {
        finding_set(fifo, FINDING_WARN,
                    "run exk-loop as root, or put `@GROUP - rtprio 80` into "
                    "/etc/security/limits.d/exk.conf and log in again");
    }
    if (rights->locked) {
        snprintf(memory->found, sizeof memory->found, "memory can be locked");
        return;
    }
    snprintf(memory->found, sizeof memory->found, "memory cannot be locked (limit %lld KiB)",
             (long long)(limit.rlim_cur / 1024));
    finding_set(memory, FINDING_WARN,
                "run exk-loop as root, or put `@GROUP - memlock unlimited` into "
                "/etc/security/limits.d/exk.conf and log in again");
}

/* The loop's own grid, empty: what the host alone costs. */
static void check_clock(findings *all)
{
    static exk_histogram lateness;
    finding *f = finding_add(all, "clock");
    exk_pacer pacer;
    exk_pacer_start(&pacer, exk_clock_monotonic(), tick_ns, 0);
    for (int i = 0; i < N_TICKS; i++) {
        exk_pacer_next(&pacer);
        exk_histogram_add(&lateness, pacer.lateness_ns);
    }
    snprintf(
        f->found, sizeof f->found,
        "%d ticks of 1 ms: late by %.0f us (median), %.0f us (99 %%), %.0f us (largest), %lld "
        "missed",
        N_TICKS, 1e-3 * (double)exk_histogram_quantile_ns(&lateness, 0.5),
        1e-3 * (double)exk_histogram_quantile_ns(&lateness, 0.99),
        1e-3 * (double)exk_histogram_quantile_ns(&lateness, 1.0), (long long)pacer.n_missed);
    if (pacer.n_missed > 0) {
        finding_set(
            f, FINDING_WARN,
            "ticks are missed with nothing to do: see schedule; on a virtual machine the host "
            "decides");
    }
}

static bool in_folder(const char *folder, size_t n, const char *name)
{
    char path[EXK_PATH_MAX];
    const int length = snprintf(path, sizeof path, "%.*s/%s", (int)n, folder, name);
    return length > 0 && (size_t)length < sizeof path && access(path, R_OK) == 0;
}

/* Is name in one of the folders of a list with colons? */
static bool in_list(const char *list, const char *name)
{
    for (const char *at = list; at != NULL && *at != '\0';) {
        const size_t n = strcspn(at, ":");
        if (in_folder(at, n, name)) {
            return true;
        }
        at += at[n] == ':' ? n + 1 : n;
    }
    return false;
}

static bool has_program(const char *name)
{
    const char *path = getenv("PATH");
    return in_list(path != NULL ? path : "/usr/local/bin:/usr/bin:/bin", name);
}

static bool has_jar(const char *name)
{
    const char *more = getenv("EXK_JAR_PATH");
    return in_list(more, name) || in_list("/usr/share/java:/usr/local/share/java", name);
}

static void check_gnuplot(findings *all)
{
    finding *f = finding_add(all, "gnuplot");
    const bool here = has_program("gnuplot");
    snprintf(f->found, sizeof f->found, here ? "here: pictures can be drawn" : "not here");
    if (!here) {
        finding_set(f, FINDING_WARN, "for --plot: apt-get install gnuplot-nox");
    }
}

static void check_java(findings *all)
{
    finding *f = finding_add(all, "spy");
    const bool java = has_program("java");
    const bool lcm = has_jar("lcm.jar");
    const bool chart = has_jar("jchart2d.jar");
    if (java && lcm && chart) {
        snprintf(f->found, sizeof f->found, "java, lcm.jar and jchart2d.jar are here");
        return;
    }
    snprintf(f->found, sizeof f->found, "not here:%s%s%s", java ? "" : " java",
             lcm ? "" : " lcm.jar", chart ? "" : " jchart2d.jar");
    finding_set(f, FINDING_WARN,
                "for exk-spy: apt-get install default-jre liblcm-java libjchart2d-java");
}

void check_host(findings *all)
{
    const exk_profile profile = exk_profile_default();
    const int priority = profile.timing.priority > 0 ? profile.timing.priority : 1;
    exk_rights rights;
    exk_rights_ask(priority, -1, &rights);
    check_rights(all, &rights, priority);
    check_clock(all);
    exk_rights_drop();
    munlockall();
    check_gnuplot(all);
    check_java(all);
}
