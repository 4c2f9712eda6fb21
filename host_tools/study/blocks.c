#define _POSIX_C_SOURCE 200809L
#include "blocks.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "whole_file.h"

enum { PATH_SIZE = 4096, WHY_SIZE = 256 };

int study_blocks_open(study_blocks *blocks, const study_task *task, uint64_t n_trials)
{
    const size_t n = (size_t)((n_trials + STUDY_BLOCK_TRIALS - 1) / STUDY_BLOCK_TRIALS);
    *blocks = (study_blocks){.task = task, .n_trials = n_trials, .n_blocks = n};
    blocks->records = calloc(n, sizeof *blocks->records);
    if (blocks->records == NULL) {
        fprintf(stderr, "exk-study: out of memory\n");
        return STUDY_IO;
    }
    return STUDY_GOOD;
}

void study_blocks_close(study_blocks *blocks)
{
    for (size_t i = 0; i < blocks->n_blocks; i++) {
        free(blocks->records[i].bytes);
    }
    free(blocks->records);
    *blocks = (study_blocks){.n_blocks = 0};
}

study_block_head study_block_at(const study_blocks *blocks, size_t i)
{
    const uint64_t first = (uint64_t)i * STUDY_BLOCK_TRIALS;
    const uint64_t left = blocks->n_trials - first;
    return (study_block_head){.hash = blocks->task->hash,
                              .first = first,
                              .n_trials =
                                  left < STUDY_BLOCK_TRIALS ? left : STUDY_BLOCK_TRIALS};
}

size_t study_blocks_done(const study_blocks *blocks)
{
    size_t n = 0;
    for (size_t i = 0; i < blocks->n_blocks; i++) {
        n += blocks->records[i].bytes != NULL;
    }
    return n;
}

/* Slot of a record of this task, or n_blocks after saying why it has none. */
static size_t slot_of(const study_blocks *blocks, const study_block_head *head, char *why,
                      size_t why_size)
{
    const size_t i = (size_t)(head->first / STUDY_BLOCK_TRIALS);
    if (head->hash != blocks->task->hash) {
        snprintf(why, why_size,
                 "of another study: other profiles, measures or version of exk-study");
        return blocks->n_blocks;
    }
    if (head->first % STUDY_BLOCK_TRIALS != 0 || i >= blocks->n_blocks ||
        study_block_at(blocks, i).n_trials != head->n_trials) {
        snprintf(why, why_size,
                 "trials %" PRIu64 " to %" PRIu64 " are no block of a study of %" PRIu64
                 " trials",
                 head->first, head->first + head->n_trials, blocks->n_trials);
        return blocks->n_blocks;
    }
    if (blocks->records[i].bytes != NULL) {
        snprintf(why, why_size, "trials from %" PRIu64 " on are there already", head->first);
        return blocks->n_blocks;
    }
    return i;
}

bool study_blocks_take(study_blocks *blocks, uint8_t *bytes, size_t n_bytes, char *why,
                       size_t why_size)
{
    study_block_head head;
    size_t slot = blocks->n_blocks;
    if (study_block_check(bytes, n_bytes, &head, why, why_size)) {
        if (head.n_bytes == n_bytes) {
            slot = slot_of(blocks, &head, why, why_size);
        } else {
            snprintf(why, why_size, "more bytes follow than its block has");
        }
    }
    if (slot == blocks->n_blocks) {
        free(bytes);
        return false;
    }
    blocks->records[slot] = (study_record){bytes, n_bytes};
    return true;
}

static void path_of(const char *folder, size_t i, char path[PATH_SIZE])
{
    snprintf(path, PATH_SIZE, "%s/block-%06zu.bin", folder, i);
}

static int make_folder(const char *folder)
{
    struct stat st;
    if (mkdir(folder, 0777) != 0 &&
        !(errno == EEXIST && stat(folder, &st) == 0 && S_ISDIR(st.st_mode))) {
        fprintf(stderr, "exk-study: %s: cannot be made or is not a folder: %s\n", folder,
                strerror(errno));
        return STUDY_IO;
    }
    return STUDY_GOOD;
}

static void load_one(study_blocks *blocks, size_t i, const char *folder)
{
    char path[PATH_SIZE];
    char why[WHY_SIZE] = "";
    size_t n = 0;
    path_of(folder, i, path);
    if (access(path, F_OK) != 0) {
        return;
    }
    uint8_t *bytes = study_read_whole(path, &n, why, sizeof why);
    if (bytes == NULL || !study_blocks_take(blocks, bytes, n, why, sizeof why)) {
        fprintf(stderr, "exk-study: %s: refused, it is run again: %s\n", path, why);
    }
}

int study_blocks_load(study_blocks *blocks, const char *folder)
{
    const int code = make_folder(folder);
    for (size_t i = 0; code == STUDY_GOOD && i < blocks->n_blocks; i++) {
        load_one(blocks, i, folder);
    }
    return code;
}

int study_blocks_save(const study_blocks *blocks, size_t i, const char *folder)
{
    char path[PATH_SIZE];
    char why[PATH_SIZE + WHY_SIZE];
    const int code = make_folder(folder);
    if (code != STUDY_GOOD) {
        return code;
    }
    path_of(folder, i, path);
    const study_record *record = &blocks->records[i];
    if (!study_write_whole(path, record->bytes, record->n_bytes, why, sizeof why)) {
        fprintf(stderr, "exk-study: %s\n", why);
        return STUDY_IO;
    }
    return STUDY_GOOD;
}

int study_blocks_fold(const study_blocks *blocks, study_sums *totals)
{
    study_sums part;
    int code = study_sums_open(&part, blocks->task->measures, totals->n);
    for (size_t i = 0; i < blocks->n_blocks && code == STUDY_GOOD; i++) {
        const study_record *record = &blocks->records[i];
        if (record->bytes == NULL ||
            !study_block_fold(record->bytes, record->n_bytes, totals->tallies, part.tallies,
                              totals->n)) {
            fprintf(stderr, "exk-study: block %zu does not fit the measures of %s\n", i,
                    blocks->task->name);
            code = STUDY_INPUT;
        }
    }
    study_sums_close(&part);
    return code;
}
