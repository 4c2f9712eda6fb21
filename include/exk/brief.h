/** One step of the loop without the record of it: for whole runs in a process of their own, where only
 *  error, correction and true tip are asked for (studies, training).
 *
 *  Same     the same rooms in the same order as exk_loop_step, so the same bits: command q = r + c + u,
 *           limits, source, guard, following error, feedback, forward. What is left out has no effect
 *           on them: the sample, the legs unless the model or a limit asks for them, the estimated tip
 *           where it is the true one.
 *  Place    reference and inverse are functions of the plan alone; they are made once (waypoints) and
 *           lent to each step.
 *  Plain    only for a loop that follows its plan tick by tick from tick 0, starts by itself and has no
 *           capture, and for a source that does not read the legs of its drive (the twin).
 *  Errors   waypoints: the code of the inverse. brief: EXK_ERR_ARG where the loop is not plain;
 *           EXK_ERR_LIMIT, EXK_ERR_SENSOR or the code of source or forward as soon as anything is not
 *           in order. The run is then to be done again with exk_loop_step, which says what and where.
 *  Memory   the caller lends n_ticks waypoints.
 */
#ifndef EXK_BRIEF_H
#define EXK_BRIEF_H

#include "exk/loop.h"

typedef struct {
    exk_ref ref;
    exk_joints r;
} exk_waypoint;

typedef struct {
    exk_tool tool; /* true where the source knows it, else estimated */
    double e_rad[EXK_N_AXES];
    double c_rad[EXK_N_AXES]; /* c[k] */
} exk_brief;

/** Fills one waypoint a tick of the plan. */
exk_err exk_waypoints(const exk_plan *plan, const exk_kin *kin, exk_waypoint *out);

/** Tick k with its waypoint. */
exk_err exk_loop_brief(exk_loop *loop, int64_t k, const exk_waypoint *at, exk_brief *out);

#endif
