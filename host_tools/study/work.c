#define _POSIX_C_SOURCE 200809L
#include "work.h"

#include <inttypes.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "blocks.h"
#include "mpi_ranks.h"
#include "pace.h"
#include "whole_file.h"

enum { WHY_SIZE = 512, THREADS_MAX = 1024 };

static volatile sig_atomic_t stop_asked; /* the one thing a signal handler may set */

/* What the threads of this process share; the lock guards all but task and work. */
typedef struct {
    const study_task *task;
    const study_work *work;
    study_blocks *blocks;
    pthread_mutex_t lock;
    size_t next; /* block to look at next */
    size_t end;
    size_t stride; /* of this rank */
    int code;
    study_pace pace;
} crew;

static void ask_stop(int signal_number)
{
    (void)signal_number;
    stop_asked = 1;
}

static void catch_signals(void)
{
    struct sigaction action = {.sa_handler = ask_stop};
    sigemptyset(&action.sa_mask);
    action.sa_flags = (int)SA_RESETHAND; /* a second Ctrl-C ends at once */
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

/* The next block that nobody has, or false. */
static bool claim(crew *c, size_t *block)
{
    bool found = false;
    pthread_mutex_lock(&c->lock);
    while (!found && c->next < c->end && c->code == STUDY_GOOD && !stop_asked) {
        *block = c->next;
        c->next += c->stride;
        found = c->blocks->records[*block].bytes == NULL;
    }
    pthread_mutex_unlock(&c->lock);
    return found;
}

static void count_trial(crew *c)
{
    pthread_mutex_lock(&c->lock);
    study_pace_step(&c->pace);
    pthread_mutex_unlock(&c->lock);
}

static void fail(crew *c, int code)
{
    pthread_mutex_lock(&c->lock);
    if (c->code == STUDY_GOOD) {
        c->code = code;
    }
    pthread_mutex_unlock(&c->lock);
}

/* False when it was stopped or failed half way; nothing is kept of it then. */
static bool run_trials(crew *c, const study_block_head *head, void *worker, study_sums *sums)
{
    for (size_t i = 0; i < sums->n; i++) {
        study_tally_clear(&sums->tallies[i]);
    }
    for (uint64_t i = 0; i < head->n_trials; i++) {
        if (stop_asked) {
            return false;
        }
        const int code = c->task->run(worker, (uint32_t)(head->first + i), sums->tallies);
        if (code != STUDY_GOOD) {
            fail(c, code);
            return false;
        }
        count_trial(c);
    }
    return true;
}

static int hand_in(crew *c, size_t block, const study_sums *sums)
{
    const study_block_head head = study_block_at(c->blocks, block);
    char why[WHY_SIZE] = "out of memory";
    size_t n = 0;
    uint8_t *bytes = study_block_encode(sums->tallies, sums->n, &head, &n);
    pthread_mutex_lock(&c->lock);
    const bool good = bytes != NULL && study_blocks_take(c->blocks, bytes, n, why, sizeof why);
    pthread_mutex_unlock(&c->lock);
    if (!good) {
        fprintf(stderr, "exk-study: block %zu: %s\n", block, why);
        return STUDY_IO;
    }
    return c->work->folder == NULL ? STUDY_GOOD
                                   : study_blocks_save(c->blocks, block, c->work->folder);
}

static void work_on(crew *c, void *worker, study_sums *sums)
{
    size_t block = 0;
    while (claim(c, &block)) {
        const study_block_head head = study_block_at(c->blocks, block);
        if (run_trials(c, &head, worker, sums)) {
            const int code = hand_in(c, block, sums);
            if (code != STUDY_GOOD) {
                fail(c, code);
            }
        }
    }
}

static void *thread_main(void *shared)
{
    crew *c = shared;
    void *worker = NULL;
    study_sums sums;
    int code = study_sums_open(&sums, c->task->measures, c->task->n_measures);
    if (code == STUDY_GOOD) {
        code = c->task->open(c->task->setup, &worker);
    }
    if (code == STUDY_GOOD) {
        work_on(c, worker, &sums);
        c->task->close(worker);
    } else {
        fail(c, code);
    }
    study_sums_close(&sums);
    return NULL;
}

/* The calling thread is one of them. */
static void run_threads(crew *c, int n_threads)
{
    pthread_t threads[THREADS_MAX];
    int n_started = 0;
    const int n_more = (n_threads < THREADS_MAX ? n_threads : THREADS_MAX) - 1;
    while (n_started < n_more &&
           pthread_create(&threads[n_started], NULL, thread_main, c) == 0) {
        n_started++;
    }
    thread_main(c);
    for (int i = 0; i < n_started; i++) {
        pthread_join(threads[i], NULL);
    }
}

static uint64_t trials_done(const study_blocks *blocks)
{
    uint64_t n = 0;
    for (size_t i = 0; i < blocks->n_blocks; i++) {
        n += blocks->records[i].bytes == NULL ? 0 : study_block_at(blocks, i).n_trials;
    }
    return n;
}

/* Blocks first, first + stride, ... below end that are not there yet. */
static int run_blocks(study_blocks *blocks, const study_work *work, size_t first, size_t end,
                      size_t stride)
{
    crew c = {.task = blocks->task,
              .work = work,
              .blocks = blocks,
              .next = first,
              .end = end,
              .stride = stride,
              .code = STUDY_GOOD};
    pthread_mutex_init(&c.lock, NULL);
    study_pace_begin(&c.pace, blocks->task->name, trials_done(blocks), blocks->n_trials, stride,
                     work->quiet || first > 0);
    run_threads(&c, work->n_threads);
    study_pace_end(&c.pace);
    pthread_mutex_destroy(&c.lock);
    return c.code;
}

static int keep_blocks(const study_blocks *blocks, const char *folder)
{
    int code = STUDY_GOOD;
    for (size_t i = 0; i < blocks->n_blocks && code == STUDY_GOOD; i++) {
        if (blocks->records[i].bytes != NULL) {
            code = study_blocks_save(blocks, i, folder);
        }
    }
    return code;
}

/* Stopped by a signal: what is done is in the folder, or goes into keep. */
static int say_stopped(const study_blocks *blocks, const study_work *work)
{
    const char *folder = work->folder != NULL ? work->folder : work->keep;
    fprintf(stderr, "exk-study: stopped with %" PRIu64 " of %" PRIu64 " trials done",
            trials_done(blocks), blocks->n_trials);
    if (folder == NULL || study_blocks_done(blocks) == 0 ||
        (work->folder == NULL && keep_blocks(blocks, folder) != STUDY_GOOD)) {
        fprintf(stderr, "; nothing is kept\n");
    } else {
        fprintf(stderr, ", kept in %s; to go on: %s --resume %s\n", folder,
                work->how_next == NULL ? "the same command with" : work->how_next, folder);
    }
    return STUDY_MISS;
}

static int run_rank(study_blocks *blocks, const study_work *work)
{
    int code = work->folder == NULL ? STUDY_GOOD : study_blocks_load(blocks, work->folder);
    if (work->alone) {
        return code != STUDY_GOOD ? code : run_blocks(blocks, work, 0, blocks->n_blocks, 1);
    }
    if (code == STUDY_GOOD) {
        code = run_blocks(blocks, work, (size_t)study_mpi_rank(), blocks->n_blocks,
                          (size_t)study_mpi_size());
    }
    return study_mpi_gather(blocks, code);
}

int study_run(const study_task *task, const study_work *work, study_sums *totals)
{
    study_blocks blocks;
    catch_signals();
    int code = study_blocks_open(&blocks, task, work->n_trials);
    if (code == STUDY_GOOD) {
        code = run_rank(&blocks, work);
    }
    if (code == STUDY_GOOD && study_blocks_done(&blocks) < blocks.n_blocks) {
        code = say_stopped(&blocks, work);
    }
    if (code == STUDY_GOOD) {
        code = study_blocks_fold(&blocks, totals);
    }
    study_blocks_close(&blocks);
    return code;
}

static int write_part(const study_blocks *blocks, size_t first, size_t end, const char *path)
{
    char why[WHY_SIZE];
    size_t n = 0;
    for (size_t i = first; i < end; i++) {
        n += blocks->records[i].n_bytes;
    }
    uint8_t *bytes = malloc(n + 1);
    uint8_t *at = bytes;
    for (size_t i = first; i < end && bytes != NULL; i++) {
        memcpy(at, blocks->records[i].bytes, blocks->records[i].n_bytes);
        at += blocks->records[i].n_bytes;
    }
    const bool good = bytes != NULL && study_write_whole(path, bytes, n, why, sizeof why);
    if (!good) {
        fprintf(stderr, "exk-study: %s\n", bytes == NULL ? "out of memory" : why);
    }
    free(bytes);
    return good ? STUDY_GOOD : STUDY_IO;
}

int study_run_part(const study_task *task, const study_work *work, uint64_t from, uint64_t to,
                   const char *path)
{
    study_blocks blocks;
    study_work here = *work;
    const size_t first = (size_t)(from / STUDY_BLOCK_TRIALS);
    here.n_trials = to;
    catch_signals();
    int code = study_blocks_open(&blocks, task, to);
    if (code == STUDY_GOOD && work->folder != NULL) {
        code = study_blocks_load(&blocks, work->folder);
    }
    if (code == STUDY_GOOD) {
        code = run_blocks(&blocks, &here, first, blocks.n_blocks, 1);
    }
    if (code == STUDY_GOOD && stop_asked) {
        fprintf(stderr, "exk-study: stopped; %s is not written\n", path);
        code = STUDY_MISS;
    }
    if (code == STUDY_GOOD) {
        code = write_part(&blocks, first, blocks.n_blocks, path);
    }
    study_blocks_close(&blocks);
    return code;
}
