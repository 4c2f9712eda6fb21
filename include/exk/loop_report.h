/** What a loop says of itself: state, motion, what was rejected, why it failed.
 *
 *  Goes with every record to the publisher and from there into EXK_STATUS.  Memory  plain values.
 */
#ifndef EXK_LOOP_REPORT_H
#define EXK_LOOP_REPORT_H

#include "exk/loop.h"

typedef struct {
    exk_cause cause; /* of the last transition */
    exk_motion_mode motion;
    int64_t k_cause; /* its tick */
    int64_t n_transitions;
    int64_t n_refused;                    /* events that the state did not take */
    int64_t n_held;                       /* ticks that the plan is behind */
    int64_t n_rejected[EXK_SAMPLE_COUNT]; /* samples by kind; [EXK_SAMPLE_GOOD]: accepted */
    exk_fault_report fault;               /* k = -1: none */
} exk_loop_report;

void exk_loop_tell(const exk_loop *loop, exk_loop_report *out);

/** Transitions since the last call, at most EXK_STATE_NOTES; returns how many. */
int exk_loop_take_notes(exk_loop *loop, exk_transition note[EXK_STATE_NOTES]);

#endif
