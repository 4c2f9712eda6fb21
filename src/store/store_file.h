/** Whole files, read and replaced as one: the system-call side of the store. */
#ifndef EXK_STORE_FILE_H
#define EXK_STORE_FILE_H

#include <stdbool.h>
#include <stddef.h>

#include "exk/store.h"
#include "store_os.h"

/** A whole file in memory. */
typedef struct {
    const unsigned char *bytes;
    size_t n;
} store_bytes;

/** Reads a file into memory the caller frees; NULL with a reason. */
unsigned char *store_file_read(const store_os *os, const char *path, size_t *n_bytes, char *why,
                               size_t why_size);

/** True when something is at path. */
bool store_file_exists(const store_os *os, const char *path);

/** Name of the previous generation: PATH.prev; false when that is too long. */
bool store_file_previous(const char *path, char *out, size_t size);

/** Replaces path so that a crash at any point leaves the old file or the new one:
 *  PATH.new written and synced; with keep, PATH also linked as PATH.prev (renamed, where the file
 *  system has no links); PATH.new renamed to PATH; the folder synced. */
exk_store_err store_file_replace(const store_os *os, const char *path, store_bytes fresh,
                                 bool keep, char *why, size_t why_size);

#endif
