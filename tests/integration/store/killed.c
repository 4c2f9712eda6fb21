/* killed N FOLDER: a child saves generation after generation; it is killed with SIGKILL at a random time, N
 * times. After each kill a store is there, whole, and not older than the last save that had returned. */
#define _DEFAULT_SOURCE
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "exk/store.h"

enum { SAMPLES = 4096 };

static void fill(exk_store *store, uint32_t generation)
{
    store->iteration = generation;
    for (int i = 0; i < EXK_N_AXES; i++) {
        for (size_t k = 0; k < store->n_samples; k++) {
            store->u_rad[i][k] = (double)generation;
        }
    }
}

static _Noreturn void save_for_ever(const char *path, uint32_t from, volatile uint32_t *done)
{
    exk_store store;
    char why[512];
    if (exk_store_alloc(&store, SAMPLES) != EXK_STORE_OK) {
        _exit(3);
    }
    store.dt_s = 0.001;
    for (uint32_t generation = from;; generation++) {
        fill(&store, generation);
        if (exk_store_save(path, &store, why, sizeof why) != EXK_STORE_OK) {
            fprintf(stderr, "killed: %s\n", why);
            _exit(1);
        }
        *done = generation;
    }
}

/* The generation on the disk; 0 with a reason when there is none or it is a mix. */
static uint32_t look(const char *path, bool *previous)
{
    exk_store store;
    char why[1024];
    if (exk_store_load(path, &store, why, sizeof why) != EXK_STORE_OK) {
        fprintf(stderr, "killed: %s\n", why);
        return 0;
    }
    bool same = store.n_samples == SAMPLES;
    for (int i = 0; i < EXK_N_AXES && same; i++) {
        for (size_t k = 0; k < SAMPLES && same; k++) {
            same = store.u_rad[i][k] == (double)store.iteration;
        }
    }
    const uint32_t found = same ? store.iteration : 0;
    *previous = store.is_previous;
    exk_store_free(&store);
    return found;
}

static bool kill_once(const char *path, uint32_t from, volatile uint32_t *done)
{
    const pid_t child = fork();
    if (child == 0) {
        save_for_ever(path, from, done);
    }
    const struct timespec pause = {.tv_nsec = rand() % 6000000};
    nanosleep(&pause, NULL);
    int status = 0;
    kill(child, SIGKILL);
    return waitpid(child, &status, 0) == child && WIFSIGNALED(status);
}

int main(int argc, char **argv)
{
    char path[512];
    const long n = argc == 3 ? strtol(argv[1], NULL, 10) : 0;
    long n_previous = 0;
    if (n <= 0) {
        fprintf(stderr, "killed: N and FOLDER are wanted\n");
        return 2;
    }
    volatile uint32_t *done =
        mmap(NULL, sizeof *done, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    snprintf(path, sizeof path, "%s/a.ilc", argv[2]);
    srand((unsigned)time(NULL));
    for (long i = 0; i < n; i++) {
        bool previous = false;
        if (!kill_once(path, *done + 1, done)) {
            return 1;
        }
        const uint32_t found = *done == 0 ? 1 : look(path, &previous);
        if (found == 0 || found < *done || found > *done + 1) {
            fprintf(stderr,
                    "killed: after kill %ld generation %" PRIu32 " is there, %" PRIu32
                    " was saved\n",
                    i + 1, found, *done);
            return 1;
        }
        n_previous += previous ? 1 : 0;
    }
    printf("%ld kills, %" PRIu32 " saves, 0 torn, 0 lost, %ld times the previous one\n", n,
           *done, n_previous);
    return *done > 0 ? 0 : 1;
}
