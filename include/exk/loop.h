/** One fixed step of the controller: plan, inverse, command, exchange, correct, forward.
 *
 *  r[k] = IK(p_ref[k]);  q[k] = r[k] + c[k] + u[k];  (m, theta) = source(q);  e[k] = r[k] - m[k];
 *  c[k+1] = feedback(e[k]);  p_est = FK(m);  p_true = FK(theta)     (architecture.md section 2)
 *  The machine model takes legs from (q, h of r) and the wrist from r, never from q.
 *  Guard   a sample that is not finite, not fresh, or beyond angle_max_rad is rejected and counted;
 *          m and the correction of the last good sample are held; n_bad_max in a row are a fault.
 *  Clock   none: the caller says which tick k it is; ticks may be skipped, never repeated.
 *  Errors  init: EXK_ERR_ARG (a pointer missing, angle_max or n_bad_max not > 0, gains refused),
 *          EXK_ERR_SIZE (a stored correction of no length). step: the code of the inverse, the legs
 *          or the source, or EXK_ERR_SENSOR; the state is then EXK_STATE_FAULT and every later step
 *          returns the last good sample at its own tick with the same code, until reset.
 *  Memory  the caller owns every struct and lends kin, plan and u; kept until the loop is dropped.
 */
#ifndef EXK_LOOP_H
#define EXK_LOOP_H

#include "exk/feedback.h"
#include "exk/kinematics.h"
#include "exk/plan.h"
#include "exk/source.h"
#include "exk/state.h"

typedef struct {
    const exk_kin *kin;
    const exk_plan *plan;
    exk_source source;
    exk_feedback_config feedback;
    const double *u_rad[EXK_N_AXES]; /* stored correction, NULL without a store */
    size_t n_u;
    double angle_max_rad; /* sensor range */
    int n_bad_max;        /* bad samples in a row that are a fault, >= 1 */
} exk_loop_config;

/** Everything one step knows; telemetry, a CSV writer and a test see the same value. */
typedef struct {
    int64_t k;
    int64_t time_us; /* k * dt, rounded */
    exk_phase phase;
    int32_t hole;    /* index in drilling order */
    int32_t hole_id; /* id in the job */
    bool judged;
    bool sensor_ok;
    bool has_true;
    exk_tool ref;
    exk_tool est;  /* FK(m) */
    exk_tool real; /* FK(theta); valid when has_true */
    double r_rad[EXK_N_AXES];
    double m_rad[EXK_N_AXES];
    double theta_rad[EXK_N_AXES];
    double q_rad[EXK_N_AXES];
    double c_rad[EXK_N_AXES];
    double u_rad[EXK_N_AXES];
    double h_m;
    double legs_m[EXK_N_LEGS];
    double wrist_rad[EXK_N_WRIST];
} exk_sample;

typedef struct {
    exk_loop_config cfg;
    exk_feedback feedback;
    double c_rad[EXK_N_AXES]; /* c[k], decided one step earlier */
    double m_rad[EXK_N_AXES]; /* last good measurement */
    bool has_m;
    int n_bad_row;
    int64_t n_bad; /* rejected samples in all */
    exk_state state;
    exk_err fault;   /* why the state is EXK_STATE_FAULT */
    exk_sample last; /* the last good step: held under a fault */
    exk_sample open; /* between command and measure: what is known of this tick */
    exk_joints open_r;
} exk_loop;

exk_err exk_loop_init(exk_loop *loop, const exk_loop_config *cfg);
void exk_loop_reset(exk_loop *loop);
exk_err exk_loop_step(exk_loop *loop, int64_t k, exk_sample *out);

/** The two halves of a step, for a source that answers by the next tick (a machine on the bus): command
 *  writes what to drive at tick k, measure takes the answer to it and closes the tick. Step is both with
 *  the exchange between. command: the fault's code and drive untouched when there is nothing to send. */
exk_err exk_loop_command(exk_loop *loop, int64_t k, exk_drive *drive);
exk_err exk_loop_measure(exk_loop *loop, const exk_reading *reading, exk_sample *out);

/** Puts the loop into EXK_STATE_FAULT from outside (missed deadlines); the first fault stays. */
void exk_loop_fail(exk_loop *loop, exk_err why);

#endif
