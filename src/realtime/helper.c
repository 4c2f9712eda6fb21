#define _POSIX_C_SOURCE 200809L
#include <sched.h>
#include <signal.h>

#include "exk/realtime.h"

enum { STACK_BYTES = 1024 * 1024 };

static int start(int policy, int priority, pthread_t *thread, void *(*work)(void *ctx),
                 void *ctx)
{
    pthread_attr_t attr;
    sigset_t all;
    sigset_t before;
    const struct sched_param param = {.sched_priority = priority};
    pthread_attr_init(&attr);
    pthread_attr_setinheritsched(&attr, PTHREAD_EXPLICIT_SCHED);
    pthread_attr_setschedpolicy(&attr, policy);
    pthread_attr_setschedparam(&attr, &param);
    pthread_attr_setstacksize(&attr, STACK_BYTES);
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    const int error = pthread_create(thread, &attr, work, ctx);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    pthread_attr_destroy(&attr);
    return error;
}

int exk_helper_start(pthread_t *thread, void *(*work)(void *ctx), void *ctx)
{
    return start(SCHED_OTHER, 0, thread, work, ctx);
}

int exk_helper_start_at(int priority, pthread_t *thread, void *(*work)(void *ctx), void *ctx)
{
    const bool started = priority > 0 && start(SCHED_FIFO, priority, thread, work, ctx) == 0;
    return started ? 0 : exk_helper_start(thread, work, ctx);
}
