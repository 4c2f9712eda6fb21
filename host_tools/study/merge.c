#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "blocks.h"
#include "whole_file.h"
#include "work.h"

enum { WHY_SIZE = 512 };

static const uint64_t trials_max = (uint64_t)1 << 32;

typedef struct {
    uint8_t *bytes;
    size_t n;
} part;

/* Calls visit for each record of a part; stops at the first that is not whole. */
static int each_record(const part *p, const char *path,
                       int (*visit)(void *ctx, const char *path, const uint8_t *bytes,
                                    const study_block_head *head),
                       void *ctx)
{
    size_t at = 0;
    int code = STUDY_GOOD;
    while (code == STUDY_GOOD && at < p->n) {
        study_block_head head;
        char why[WHY_SIZE];
        if (!study_block_check(p->bytes + at, p->n - at, &head, why, sizeof why)) {
            fprintf(stderr, "exk-study: %s: refused: %s; run this part again\n", path, why);
            return STUDY_INPUT;
        }
        code = visit(ctx, path, p->bytes + at, &head);
        at += head.n_bytes;
    }
    return code;
}

/* The trials of the study are those up to the end of its last block. */
static int find_end(void *ctx, const char *path, const uint8_t *bytes,
                    const study_block_head *head)
{
    uint64_t *n_trials = ctx;
    (void)bytes;
    if (head->first >= trials_max || head->n_trials > STUDY_BLOCK_TRIALS) {
        fprintf(stderr, "exk-study: %s: refused: no block of ours\n", path);
        return STUDY_INPUT;
    }
    if (head->first + head->n_trials > *n_trials) {
        *n_trials = head->first + head->n_trials;
    }
    return STUDY_GOOD;
}

static int take_record(void *ctx, const char *path, const uint8_t *bytes,
                       const study_block_head *head)
{
    char why[WHY_SIZE] = "out of memory";
    uint8_t *copy = malloc(head->n_bytes);
    if (copy != NULL) {
        memcpy(copy, bytes, head->n_bytes);
    }
    if (copy == NULL || !study_blocks_take(ctx, copy, head->n_bytes, why, sizeof why)) {
        fprintf(stderr, "exk-study: %s: refused: %s\n", path, why);
        return STUDY_INPUT;
    }
    return STUDY_GOOD;
}

static int fold_parts(const study_task *task, part *parts, char *const *paths, size_t n,
                      study_sums *totals, uint64_t n_trials)
{
    study_blocks blocks;
    int code = study_blocks_open(&blocks, task, n_trials);
    for (size_t i = 0; i < n && code == STUDY_GOOD; i++) {
        code = each_record(&parts[i], paths[i], take_record, &blocks);
    }
    for (size_t i = 0; i < blocks.n_blocks && code == STUDY_GOOD; i++) {
        if (blocks.records[i].bytes == NULL) {
            const uint64_t first = (uint64_t)i * STUDY_BLOCK_TRIALS;
            fprintf(stderr,
                    "exk-study: no part holds the trials from %" PRIu64
                    " on: run exk-study block --from %" PRIu64 " for them\n",
                    first, first);
            code = STUDY_INPUT;
        }
    }
    if (code == STUDY_GOOD) {
        code = study_blocks_fold(&blocks, totals);
    }
    study_blocks_close(&blocks);
    return code;
}

static int read_parts(part *parts, char *const *paths, size_t n, uint64_t *n_trials)
{
    int code = STUDY_GOOD;
    for (size_t i = 0; i < n && code == STUDY_GOOD; i++) {
        char why[WHY_SIZE];
        parts[i].bytes = study_read_whole(paths[i], &parts[i].n, why, sizeof why);
        if (parts[i].bytes == NULL) {
            fprintf(stderr, "exk-study: %s\n", why);
            return STUDY_IO;
        }
        if (parts[i].n == 0) {
            fprintf(stderr, "exk-study: %s: refused: it is empty\n", paths[i]);
            return STUDY_INPUT;
        }
        code = each_record(&parts[i], paths[i], find_end, n_trials);
    }
    return code;
}

int study_merge_parts(const study_task *task, char *const *paths, size_t n_paths,
                      study_sums *totals, uint64_t *n_trials)
{
    part *parts = calloc(n_paths, sizeof *parts);
    int code = parts == NULL ? STUDY_IO : STUDY_GOOD;
    *n_trials = 0;
    if (code == STUDY_GOOD) {
        code = read_parts(parts, paths, n_paths, n_trials);
    }
    if (code == STUDY_GOOD) {
        code = fold_parts(task, parts, paths, n_paths, totals, *n_trials);
    }
    for (size_t i = 0; i < n_paths && parts != NULL; i++) {
        free(parts[i].bytes);
    }
    free(parts);
    return code;
}
