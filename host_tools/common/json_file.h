/** JSON results: indented by two, keys in the order they were set, numbers to 12 digits.
 *
 *  Numbers  exk_json_real gives null for NaN and infinity, which JSON cannot hold.
 *  Errors   an exit code as in out_file.h.
 */
#ifndef EXK_TOOLS_JSON_FILE_H
#define EXK_TOOLS_JSON_FILE_H

#include <jansson.h>
#include <stddef.h>

json_t *exk_json_real(double value);

/** Writes root to path ("-": standard output). first_key: the first key of root, by which an
 *  earlier result is told from another file. root stays the caller's. */
int exk_json_write(const json_t *root, const char *path, const char *first_key, char *why,
                   size_t why_size);

#endif
