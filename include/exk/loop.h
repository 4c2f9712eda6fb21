/** One fixed step of the controller: plan, inverse, command, exchange, correct, forward.
 *
 *  r[k] = IK(p_ref[k]);  q[k] = r[k] + c[k] + u[k];  (m, theta) = source(q);  e[k] = r[k] - m[k];
 *  c[k+1] = feedback(e[k]);  p_est = FK(m);  p_true = FK(theta)     (docs/step.md)
 *  The machine model takes legs from (q, h of r) and the wrist from r, never from q.
 *  States  state.h. The first step starts by itself unless waits is set; after clear only start does,
 *          and the correction goes on from the one in the command that stands. HOLD slows down along
 *          the path and goes on controlling position; start goes on from there, sample for sample.
 *  Guard   guard.h. A rejected sample is counted; m and the correction of the last good sample are
 *          held. After a gap the correction goes on from the held one: no kick from the derivative.
 *          n_bad_max in a row are a fault.
 *  Limits  limits.h, on every command before it leaves. One that breaks a limit is never sent.
 *  Faults  after rejected samples: the loop slows down with the correction held, rests wait_s, backs
 *          out of the part, rests. After anything else it stays on the last good command at once,
 *          because the command itself or its time is in doubt. The first fault stays until clear.
 *          Further steps return the code; what, value, limit, tick and hole are in report.
 *  Clock   none: the caller says which tick k it is; ticks may be skipped, never repeated.
 *  Errors  init: EXK_ERR_ARG (a pointer missing, angle_max or n_bad_max not > 0, gains, guard or
 *          limits refused), EXK_ERR_SIZE (a stored correction of no length). step: the code of the
 *          fault; EXK_ERR_ARG, and nothing done, for a tick not later than the last.
 *  Memory  the caller owns every struct and lends kin, plan, u and capture; kept until the loop is
 *          dropped.
 */
#ifndef EXK_LOOP_H
#define EXK_LOOP_H

#include "exk/capture.h"
#include "exk/feedback.h"
#include "exk/guard.h"
#include "exk/kinematics.h"
#include "exk/limits.h"
#include "exk/motion.h"
#include "exk/plan.h"
#include "exk/sample.h"
#include "exk/source.h"
#include "exk/state.h"

typedef struct {
    const exk_kin *kin;
    const exk_plan *plan;
    exk_source source;
    exk_feedback_config feedback;
    const double *u_rad[EXK_N_AXES]; /* stored correction, NULL without a store */
    size_t n_u;
    double angle_max_rad;     /* sensor range */
    int n_bad_max;            /* bad samples in a row that are a fault, >= 1 */
    exk_guard_config guard;   /* dt_s 0: the default; range and dt are set from above */
    exk_limits_config limits; /* dt_s 0: unlimited */
    double wait_s;            /* at rest before backing out of the part */
    bool waits;               /* IDLE until start is asked for */
    exk_capture *capture;     /* NULL: none; frozen by a fault until its owner resets it */
} exk_loop_config;

/** Why the loop is in EXK_STATE_FAULT. */
typedef struct {
    exk_cause cause;
    exk_err err;
    exk_violation what;
    exk_sample_kind sample; /* of the last rejected one, for EXK_CAUSE_SENSOR */
    int64_t k;
    exk_phase phase;
    int32_t hole_id; /* -1: none */
} exk_fault_report;

typedef struct {
    exk_loop_config cfg;
    exk_feedback feedback;
    exk_state_machine sm;
    exk_guard guard;
    exk_limits limits;
    exk_motion motion;
    double c_rad[EXK_N_AXES]; /* c[k], decided one step earlier */
    double m_rad[EXK_N_AXES]; /* last good measurement */
    bool has_m;
    int n_bad_row;
    int64_t n_bad;           /* rejected samples in all */
    exk_err fault;           /* why the state is EXK_STATE_FAULT */
    exk_fault_report report; /* the same in full */
    exk_sample last;         /* the last good step: held under a fault */
    exk_sample open;         /* between command and measure: what is known of this tick */
    exk_joints open_r;
    bool is_open;
} exk_loop;

exk_err exk_loop_init(exk_loop *loop, const exk_loop_config *cfg);
void exk_loop_reset(exk_loop *loop);
exk_err exk_loop_step(exk_loop *loop, int64_t k, exk_sample *out);

/** The two halves of a step, for a source that answers by the next tick (a machine on the bus): command
 *  writes what to drive at tick k, measure takes the answer to it and closes the tick. Step is both with
 *  the exchange between. command: the fault's code and drive untouched when there is nothing to send
 *  (EXK_OK and untouched while IDLE: ask exk_loop_moves). */
exk_err exk_loop_command(exk_loop *loop, int64_t k, exk_drive *drive);
exk_err exk_loop_measure(exk_loop *loop, const exk_reading *reading, exk_sample *out);

/** True between command and measure when there is a drive to send. */
bool exk_loop_moves(const exk_loop *loop);

/** Start, stop, abort, clear, quit or a command time-out, before the step of tick k. False, and counted,
 *  when the state does not take it; clear waits for the end of the way out of the part. */
bool exk_loop_request(exk_loop *loop, exk_cause cause, int64_t k);

/** A fault from outside (missed deadlines). The first fault stays; what moves under it, on its way out,
 *  stays where it is. */
void exk_loop_fail(exk_loop *loop, const exk_fault_report *report);

/** The tick on which the plan ends, as things are: later than n_ticks - 1 after a hold. */
int64_t exk_loop_last_tick(const exk_loop *loop);

/** True when nothing more will move: DONE, or a fault that has come to its rest. */
bool exk_loop_is_over(const exk_loop *loop);

#endif
