/** ILC store: the learned correction of one job in a file that is whole or not there.
 *
 *  Bytes    little-endian: magic "EXKILC\0\0", u32 version, u32 header bytes, u64 job hash, f64 dt_s,
 *           u32 iteration, u32 axes, u64 samples, f64 u[axes][samples], u32 CRC-32 of all before.
 *  Save     NAME.new, write, fsync; a good NAME becomes NAME.prev as well; rename, fsync of the folder:
 *           a crash or a power cut at any point leaves the old one or the new one. Savers in one folder
 *           take turns (a lock on it); one that waits for 10 s gives up.
 *  Load     NAME, or NAME.prev when NAME is missing or not good: is_previous is set then, and why says
 *           what is wrong with NAME. Refused when neither is good.
 *  Errors   exk_store_err, with a message that names file, what, found and allowed.
 *  Memory   load allocates u (one block); exk_store_free releases it. Outside the core.
 */
#ifndef EXK_STORE_H
#define EXK_STORE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/axes.h"

typedef struct {
    uint64_t job_hash;
    double dt_s;
    uint32_t iteration; /* p of u_p: the run this correction is for; 1 is untrained */
    size_t n_samples;
    double *u_rad[EXK_N_AXES];
    bool is_previous; /* loaded from NAME.prev: warn with why */
} exk_store;

typedef enum {
    EXK_STORE_OK,
    EXK_STORE_IO,       /* could not be opened, read, written or synced */
    EXK_STORE_NOT_OURS, /* magic or version */
    EXK_STORE_CORRUPT,  /* length or CRC */
    EXK_STORE_OTHER_JOB /* job hash, dt or length */
} exk_store_err;

exk_store_err exk_store_alloc(exk_store *store, size_t n_samples); /* u all zero, iteration 1 */
void exk_store_free(exk_store *store);
exk_store_err exk_store_save(const char *path, const exk_store *store, char *why,
                             size_t why_size);
exk_store_err exk_store_load(const char *path, exk_store *store, char *why, size_t why_size);

/** Refuses a store of another job, dt or length; why says which, found and expected. */
exk_store_err exk_store_match(const exk_store *store, uint64_t job_hash, double dt_s,
                              size_t n_samples, char *why, size_t why_size);

/** 64-bit BLAKE2b of a text: the job hash. */
uint64_t exk_store_hash(const char *text, size_t length);

#endif
