/** Text files that people write: read whole, their faults printed the way compilers do.
 *
 *  Errors  exit codes of the programs: 0, 2 (not a text, or a fault in it), 3 (cannot be read). All
 *          is said on stderr: "path:line: message".
 *  Memory  a text read is the caller's to free. Outside the core.
 */
#ifndef EXK_INPUT_H
#define EXK_INPUT_H

#include <stddef.h>

#include "exk/profile.h"

enum { EXK_FAULTS_MAX = 64, EXK_INPUT_BAD = 2, EXK_INPUT_UNREADABLE = 3 };

/** The whole text of a file, at most 16 MiB, without a zero byte. */
int exk_input_read(const char *path, char **text);

/** out = file, or the folder of beside + file when file is relative. */
void exk_input_beside(const char *beside, const char *file, char *out, size_t size);

/** Each fault on a line of its own, then how many were left out. */
void exk_input_print(const char *path, const exk_fault *faults, size_t n_faults);

/** Parses a text as a profile named after path; faults are printed. */
int exk_input_parse(const char *path, const char *text, exk_profile *profile);

/** Reads and parses a profile file. */
int exk_input_profile(const char *path, exk_profile *profile);

#endif
