/** Whole files, read and replaced as one: the system-call side of the store. */
#ifndef EXK_STORE_FILE_H
#define EXK_STORE_FILE_H

#include <stddef.h>

#include "exk/store.h"

/** Reads a file into memory the caller frees; NULL with a reason. */
unsigned char *store_file_read(const char *path, size_t *n_bytes, char *why, size_t why_size);

/** Replaces path so that a crash at any point leaves the old file or the new one: PATH.new, write,
 *  fsync, rename, fsync of the folder. A file that is there and does not start with magic is not
 *  ours and stays. */
exk_store_err store_file_replace(const char *path, const unsigned char *bytes, size_t n_bytes,
                                 const unsigned char *magic, size_t n_magic, char *why,
                                 size_t why_size);

#endif
