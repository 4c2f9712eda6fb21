/* Preloaded into exk-loop: counts heap calls of the main thread from its first timed wait on, that is,
 * while the loop runs; the count is printed when the publisher is joined (the loop has ended). */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

static _Atomic int in_loop;
static _Atomic long n_heap;
static _Atomic long n_waits;

static int counted(void)
{
    return in_loop && getpid() == (pid_t)syscall(SYS_gettid);
}

extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t n, size_t size);
extern void *__libc_realloc(void *at, size_t size);
extern void __libc_free(void *at);

void *malloc(size_t size)
{
    n_heap += counted();
    return __libc_malloc(size);
}

void *calloc(size_t n, size_t size)
{
    n_heap += counted();
    return __libc_calloc(n, size);
}

void *realloc(void *at, size_t size)
{
    n_heap += counted();
    return __libc_realloc(at, size);
}

void free(void *at)
{
    n_heap += counted();
    __libc_free(at);
}

int clock_nanosleep(clockid_t clock, int flags, const struct timespec *until,
                    struct timespec *left)
{
    if (getpid() == (pid_t)syscall(SYS_gettid)) {
        in_loop = 1;
        n_waits++;
    }
    return (int)syscall(SYS_clock_nanosleep, clock, flags, until, left) == 0 ? 0 : 4;
}

int pthread_join(pthread_t thread, void **result)
{
    static int (*real)(pthread_t, void **);
    if (counted()) {
        in_loop = 0;
        fprintf(stderr, "heap calls in the loop: %ld in %ld waits\n", n_heap, n_waits);
    }
    if (real == NULL) {
        *(void **)&real = dlsym(RTLD_NEXT, "pthread_join");
    }
    return real(thread, result);
}
