/** Reads and checks a profile from its file, for tools that run no rig.
 *
 *  Errors  an exit code: 0, 2 (a fault in it: every one is printed as "path:line: message"),
 *          3 (cannot be read; said on stderr).
 */
#ifndef EXK_TOOLS_PROFILE_FILE_H
#define EXK_TOOLS_PROFILE_FILE_H

#include "exk/profile.h"

int exk_profile_file_read(const char *path, exk_profile *profile);

#endif
