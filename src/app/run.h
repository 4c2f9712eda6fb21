/** One run of the controller: pacing, publishing, stopping, telling what came out. */
#ifndef EXK_LOOP_RUN_H
#define EXK_LOOP_RUN_H

#include "exk/rig.h"
#include "exk/store.h"
#include "options.h"

/** Returns the exit code. store may be NULL. */
int loop_run(const loop_options *options, exk_rig *rig, const exk_store *store);

#endif
