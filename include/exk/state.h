/** State machine of a controller: one table of (state, cause, next state), and nothing else.
 *
 *  States  INIT  not set up              IDLE  set up, at rest, waiting for start
 *          RUN   following the plan      HOLD  slowed to rest on the path, position controlled
 *          FAULT ended by a fault: slows, retracts where that is safe, rests until clear
 *          DONE  ended; nothing leads out of it
 *  Rule    what the table does not list is refused, changes nothing and is counted. Faults lead to
 *          FAULT from every state that may move; in FAULT and DONE the first reason stays.
 *  Notes   every transition taken is noted with its cause, up to EXK_STATE_NOTES between two calls of
 *          exk_state_forget_notes; n_taken counts on, so that a lost note shows.
 *  Errors  take: false for a cause that is refused. Names: never NULL.
 *  Memory  the caller owns the struct; no pointer kept. Pure: no clock, no input but its arguments.
 */
#ifndef EXK_STATE_H
#define EXK_STATE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum {
    EXK_STATE_INIT,
    EXK_STATE_IDLE,
    EXK_STATE_RUN,
    EXK_STATE_HOLD,
    EXK_STATE_FAULT,
    EXK_STATE_DONE,
    EXK_STATE_COUNT
} exk_state;

/** What may happen; on the wire as the cause of a transition, so new ones go to the end. */
typedef enum {
    EXK_CAUSE_NONE,    /* nothing happened yet; always refused */
    EXK_CAUSE_READY,   /* set-up is complete */
    EXK_CAUSE_START,   /* command: begin, or go on after a hold */
    EXK_CAUSE_STOP,    /* command: slow down and hold */
    EXK_CAUSE_ABORT,   /* command: stop at once, stay */
    EXK_CAUSE_CLEAR,   /* command: the fault is understood */
    EXK_CAUSE_QUIT,    /* the program was asked to end */
    EXK_CAUSE_END,     /* the last tick of the plan */
    EXK_CAUSE_TIMEOUT, /* no valid command stream within the time-out */
    EXK_CAUSE_SENSOR,  /* too many rejected samples in a row */
    EXK_CAUSE_LIMIT,   /* a command or an error left its limit, or no pose exists */
    EXK_CAUSE_OVERRUN, /* too many deadlines missed in a row, or the clock stands */
    EXK_CAUSE_SOURCE,  /* the joint source ended or failed */
    EXK_CAUSE_COUNT
} exk_cause;

typedef struct {
    exk_state from;
    exk_cause cause;
    exk_state to;
} exk_transition;

enum { EXK_STATE_NOTES = 4 };

typedef struct {
    exk_state state;
    exk_cause cause;   /* of the last transition */
    int64_t k;         /* tick of the last transition */
    int64_t n_taken;   /* transitions */
    int64_t n_refused; /* events that the state does not take */
    exk_transition note[EXK_STATE_NOTES];
    int n_notes;
} exk_state_machine;

/** INIT, nothing counted. */
void exk_state_init(exk_state_machine *sm);

/** Takes an event at tick k: true and the next state, or false and counted. */
bool exk_state_take(exk_state_machine *sm, exk_cause cause, int64_t k);

void exk_state_forget_notes(exk_state_machine *sm);

/** The table, for pictures and proofs. */
size_t exk_state_transitions(const exk_transition **table);

const char *exk_state_name(exk_state state); /* "run"; "unknown" for other values */
const char *
exk_cause_name(exk_cause cause); /* "missed deadlines"; "unknown" for other values */

#endif
