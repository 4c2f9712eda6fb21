#define _GNU_SOURCE
#include "exk/realtime.h"

#include <errno.h>
#include <sched.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>

bool exk_rights_fifo(int priority)
{
    const struct sched_param param = {.sched_priority = priority};
    return priority > 0 && sched_setscheduler(0, SCHED_FIFO, &param) == 0;
}

static bool ask_cpu(int cpu)
{
    cpu_set_t set;
    CPU_ZERO(&set);
    if (cpu < 0 || cpu >= CPU_SETSIZE) {
        return false;
    }
    CPU_SET((size_t)cpu, &set);
    return sched_setaffinity(0, sizeof set, &set) == 0;
}

/* Touch the stack once so that no page of it is mapped later, inside a step. */
static void prefault_stack(void)
{
    volatile unsigned char page[64 * 1024];
    for (size_t i = 0; i < sizeof page; i += 1024) {
        page[i] = 0;
    }
}

void exk_rights_ask(int priority, int cpu, exk_rights *out)
{
    char fifo[48];
    char pinned[32];
    *out = (exk_rights){.slack = prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL) == 0};
    out->locked = mlockall(MCL_CURRENT) == 0;
    prefault_stack();
    out->pinned = ask_cpu(cpu);
    out->fifo = exk_rights_fifo(priority);
    if (out->fifo) {
        snprintf(fifo, sizeof fifo, "FIFO %d", priority);
    } else {
        snprintf(fifo, sizeof fifo, priority > 0 ? "FIFO refused" : "FIFO not asked for");
    }
    if (out->pinned) {
        snprintf(pinned, sizeof pinned, "CPU %d", cpu);
    } else {
        snprintf(pinned, sizeof pinned, cpu >= 0 ? "CPU %d refused" : "any CPU", cpu);
    }
    snprintf(out->text, sizeof out->text, "%s, %s, %s", fifo,
             out->locked ? "memory locked" : "memory lock refused", pinned);
}

void exk_rights_drop(void)
{
    const struct sched_param ordinary = {.sched_priority = 0};
    cpu_set_t all;
    memset(&all, 0xff, sizeof all);
    sched_setscheduler(0, SCHED_OTHER, &ordinary);
    sched_setaffinity(0, sizeof all, &all);
}
