/** A block of trials as bytes: what a worker hands in, whatever carries it (thread, rank, file).
 *
 *  Bytes    little-endian: magic "EXKBLK\0\0", u32 version, u32 measures, u64 hash of the task, u64 first
 *           trial, u64 trials, u64 record bytes; then a measure: u64 n, f64 mean, f64 M2, f64 min,
 *           f64 max, u64 positive, u64 bad, u32 filled bins, and (u32 bin, u32 count) for each;
 *           u32 CRC-32 of all before.
 *  Errors   check and fold refuse what is cut, damaged, of another task or version; why says which.
 *  Memory   encode returns one block of the heap, the caller's to free.
 */
#ifndef STUDY_BLOCK_H
#define STUDY_BLOCK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "tally.h"

enum { STUDY_BLOCK_TRIALS = 50 }; /* whole groups of the study's 10 simulations */

typedef struct {
    uint64_t hash;
    uint64_t first;
    uint64_t n_trials;
    size_t n_bytes; /* of the whole record */
} study_block_head;

uint8_t *study_block_encode(const study_tally *tallies, size_t n_measures,
                            const study_block_head *head, size_t *n_bytes);

/** Is there a whole, undamaged record at the start of bytes? head is filled when so. */
bool study_block_check(const uint8_t *bytes, size_t size, study_block_head *head, char *why,
                       size_t why_size);

/** Merges a checked record into totals; part is one set of tallies to work in. False when the
 *  record does not fit the measures: totals are then untouched. */
bool study_block_fold(const uint8_t *bytes, size_t size, study_tally *totals, study_tally *part,
                      size_t n_measures);

#endif
