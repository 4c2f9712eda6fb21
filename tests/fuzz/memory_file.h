/** Bytes as a file that has a path, without a disk. */
#ifndef EXK_TEST_MEMORY_FILE_H
#define EXK_TEST_MEMORY_FILE_H

#include <stddef.h>
#include <stdint.h>

/** Makes the bytes the content of one file that is kept for the whole process; its path. */
const char *memory_file(const uint8_t *data, size_t size);

#endif
