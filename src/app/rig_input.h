/** Files and fault lists of a rig: the part that reads and prints. */
#ifndef EXK_RIG_INPUT_H
#define EXK_RIG_INPUT_H

#include <stddef.h>

#include "exk/profile.h"

enum { RIG_FAULTS_MAX = 64 };

/** A whole text file in memory the caller frees; NULL after a message on stderr. */
char *rig_read_text(const char *path);

/** out = file, or the folder of beside + file when file is relative. */
void rig_path_beside(const char *beside, const char *file, char *out, size_t size);

/** "path:line: message" for each fault, then how many were left out. */
void rig_print_faults(const char *path, const exk_fault *faults, size_t n_faults);

#endif
