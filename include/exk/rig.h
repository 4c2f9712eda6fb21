/** Rig: everything one run needs, built from a profile (kinematics, plan, twin, loop).
 *
 *  Used by exk-loop, exk-ilc and exk-study alike, so that there is one way from a profile to a run.
 *  Errors   faults collected as in profile.h, each hole outside the workspace named by its id.
 *  Memory   exk_rig_open allocates holes, segments; exk_rig_close releases. Outside the core. A
 *           rig must not be moved after open: the loop points into it.
 */
#ifndef EXK_RIG_H
#define EXK_RIG_H

#include "exk/capture.h"
#include "exk/inject.h"
#include "exk/loop.h"
#include "exk/profile.h"
#include "exk/replay.h"
#include "exk/twin.h"

typedef struct {
    exk_profile profile;
    uint64_t job_hash;
    exk_hole *holes;
    size_t n_holes;
    exk_segment *segments;
    exk_kin kin;
    exk_plan plan;
    exk_twin twin;
    exk_inject inject;   /* the profile's faults, put into what twin or log answer */
    exk_replay replay;   /* when the profile reads its angles from a log */
    exk_joint_from from; /* where the angles come from: the profile's word, or the caller's */
    exk_source bus;      /* set by the caller before start where they come from the bus */
    exk_capture capture; /* no slots until exk_rig_capture */
    exk_sample *captured;
    exk_loop loop;
} exk_rig;

/** Reads the profile file (and its CSV), builds and checks everything: every tick of the plan goes
 *  through the inverse. Faults are printed to stderr as "file:line: message"; returns an exit code: 0,
 *  2 (bad input) or 3 (cannot read). */
int exk_rig_open(exk_rig *rig, const char *profile_path);

/** The same from a text in memory (a log's EXK_JOB) with its holes. */
int exk_rig_open_text(exk_rig *rig, const char *name, const char *text, const exk_hole *holes,
                      size_t n_holes);
void exk_rig_close(exk_rig *rig);

/** Keeps the last duration_s of samples at full rate, for the moment something goes wrong; from the next
 *  start on. False: out of memory. */
bool exk_rig_capture(exk_rig *rig, double duration_s);

/** Sets up twin and loop for one run of a series; u may be NULL. */
exk_err exk_rig_start(exk_rig *rig, exk_realisation which,
                      const double *const u_rad[EXK_N_AXES], size_t n_u);

/** The machine of the profile alone, for a process that is the machine: sets up the twin for one run and
 *  returns it as a source, with the profile's faults in it. Where the angles come from the bus, rig_start
 *  puts none in: they are the other process's. */
exk_err exk_rig_start_machine(exk_rig *rig, exk_realisation which, exk_source *out);

/** run_id of a fast run. */
int64_t exk_rig_run_id(const exk_rig *rig, exk_realisation which);

#endif
