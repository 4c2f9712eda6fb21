/** The blocks of one study as records in memory, and their files.
 *
 *  Slots    block i holds trials i * STUDY_BLOCK_TRIALS up to the next block or the end.
 *  Files    FOLDER/block-NNNNNN.bin, one record each; a part file is records one after another.
 *  Memory   the set owns its records; study_blocks_close frees them.
 */
#ifndef STUDY_BLOCKS_H
#define STUDY_BLOCKS_H

#include <stdbool.h>

#include "block.h"
#include "task.h"

typedef struct {
    uint8_t *bytes; /* NULL: not there yet */
    size_t n_bytes;
} study_record;

typedef struct {
    const study_task *task;
    uint64_t n_trials;
    size_t n_blocks;
    study_record *records;
} study_blocks;

int study_blocks_open(study_blocks *blocks, const study_task *task, uint64_t n_trials);
void study_blocks_close(study_blocks *blocks);

/** First trial and count of block i. */
study_block_head study_block_at(const study_blocks *blocks, size_t i);
size_t study_blocks_done(const study_blocks *blocks);

/** Takes a record over (or frees it). False when it is not whole, of this task and of a free slot. */
bool study_blocks_take(study_blocks *blocks, uint8_t *bytes, size_t n_bytes, char *why,
                       size_t why_size);

/** Reads what FOLDER holds; says on stderr by name what it refuses. Makes the folder. */
int study_blocks_load(study_blocks *blocks, const char *folder);
int study_blocks_save(const study_blocks *blocks, size_t i, const char *folder);

/** Every record into totals, in block order. */
int study_blocks_fold(const study_blocks *blocks, study_sums *totals);

#endif
