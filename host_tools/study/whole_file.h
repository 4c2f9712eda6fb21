/** Small binary files read whole, and written whole or not at all.
 *
 *  Write    to a temporary name beside it, fsync, rename: a crash leaves the old one or the new one.
 *  Errors   NULL or false; why says file and reason.  Memory  read: one heap block, the caller's.
 */
#ifndef STUDY_WHOLE_FILE_H
#define STUDY_WHOLE_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** One byte more than n is allocated, for a text's end. */
uint8_t *study_read_whole(const char *path, size_t *n, char *why, size_t why_size);
bool study_write_whole(const char *path, const uint8_t *bytes, size_t n, char *why,
                       size_t why_size);

#endif
