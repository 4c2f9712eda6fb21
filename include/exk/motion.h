/** Where on its plan the loop is: following it, slowing to rest, going on, or backing out of the part.
 *
 *  FOLLOW   plan tick j = k - n_held: tick by tick, bit for bit the plan.
 *  SLOW     speed falls by 1/n a tick, n odd: after i ticks j = j0 + i - i(i+1)/(2n); it ends on the
 *           whole tick j0 + (n-1)/2. n covers feed/accel of the phase (1: at once). Integers, so no
 *           rounding is left when the plan goes on.
 *  REST     at tick j.
 *  SPEED    the same upwards: j = j0 + i(i+1)/(2n), ends on the whole tick j0 + (n+1)/2.
 *  RETRACT  after wait ticks at rest: straight back to the clearance (exk_plan_retract).
 *  OUT      at the clearance, or frozen where it was. Going on ends a way out that was broken off, then
 *           begins the hole anew.
 *  Skipped  ticks count as gone: every position is a function of k.
 *  Memory   the caller owns the struct and lends the plan to each call. Cannot fail: a way back that
 *           cannot be planned is none.
 */
#ifndef EXK_MOTION_H
#define EXK_MOTION_H

#include <stdbool.h>
#include <stdint.h>

#include "exk/plan.h"

typedef enum {
    EXK_MOTION_FOLLOW,
    EXK_MOTION_SLOW,
    EXK_MOTION_REST,
    EXK_MOTION_SPEED,
    EXK_MOTION_RETRACT,
    EXK_MOTION_OUT,
    EXK_MOTION_COUNT
} exk_motion_mode;

typedef struct {
    exk_motion_mode mode;
    int64_t k0;    /* last tick of the mode before */
    int64_t j0;    /* plan tick there */
    int64_t n;     /* ramp */
    int64_t k;     /* last tick placed */
    int64_t j;     /* its plan tick */
    double part;   /* of the way from j to j + 1 */
    bool retracts; /* out of tick j by way, else at tick j */
    int64_t step;  /* of way, when that was broken off; else its n_ticks */
    exk_segment way;
} exk_motion;

/** What the state asks of the motion. */
typedef struct {
    bool go;       /* follow the plan; else come to rest */
    bool out;      /* from rest back out of the part */
    double wait_s; /* at rest before that */
} exk_motion_wish;

/** Before tick 0 of the plan, following it. */
void exk_motion_init(exk_motion *motion);

/** The reference of tick k. */
void exk_motion_place(exk_motion *motion, const exk_plan *plan, int64_t k,
                      const exk_motion_wish *wish, exk_ref *out);

/** Stays where it is, whatever is wished, until it may go on. */
void exk_motion_freeze(exk_motion *motion);

/** Freezes at once where it is at rest and has no way out to go. */
void exk_motion_settle(exk_motion *motion, const exk_plan *plan);

/** Frozen, or out of the part: nothing will move until it may go on. */
bool exk_motion_is_over(const exk_motion *motion);

/** Ticks that the plan is behind, tick k: 0 in a run that was never held. */
static inline int64_t exk_motion_held(const exk_motion *motion)
{
    return motion->k - motion->j;
}

const char *exk_motion_name(exk_motion_mode mode); /* never NULL */

#endif
