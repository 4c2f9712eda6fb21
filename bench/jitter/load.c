#define _GNU_SOURCE
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "jitter.h"

enum { HOGS_MAX = 64, BLOCK = 1 << 20, BLOCKS = 64, EXIT_IO = 3 };

static pid_t children[HOGS_MAX + 1];
static int n_children;

static void burn(void)
{
    volatile double x = 1.0;
    for (;;) {
        x = x * 1.0000001 + 1e-9;
    }
}

static void write_disk(void)
{
    static char block[BLOCK];
    char path[] = "exk-jitter-load-XXXXXX";
    const int fd = mkstemp(path);
    unlink(path);
    memset(block, 'x', sizeof block);
    for (int i = 0;; i++) {
        if (fd < 0 || pwrite(fd, block, sizeof block, (off_t)(i % BLOCKS) * BLOCK) < 0 ||
            fdatasync(fd) != 0) {
            _exit(EXIT_IO);
        }
    }
}

static bool start(void (*work)(void))
{
    const pid_t child = fork();
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        work();
    }
    if (child > 0) {
        children[n_children++] = child;
    }
    return child > 0;
}

int jitter_load_start(void)
{
    const long n_cpus = sysconf(_SC_NPROCESSORS_ONLN);
    bool good = start(write_disk);
    for (long i = 0; i < n_cpus && i < HOGS_MAX; i++) {
        good = start(burn) && good;
    }
    return good ? 0 : EXIT_IO;
}

void jitter_load_stop(void)
{
    while (n_children > 0) {
        n_children--;
        kill(children[n_children], SIGKILL);
        waitpid(children[n_children], NULL, 0);
    }
}
