#include "exk/state.h"

#define INIT EXK_STATE_INIT
#define IDLE EXK_STATE_IDLE
#define RUN EXK_STATE_RUN
#define HOLD EXK_STATE_HOLD
#define FAULT EXK_STATE_FAULT
#define DONE EXK_STATE_DONE

/* clang-format off: one transition a line */
static const exk_transition table[] = {
    {INIT, EXK_CAUSE_READY, IDLE},    {IDLE, EXK_CAUSE_START, RUN},
    {IDLE, EXK_CAUSE_ABORT, FAULT},   {IDLE, EXK_CAUSE_LIMIT, FAULT},
    {IDLE, EXK_CAUSE_OVERRUN, FAULT}, {IDLE, EXK_CAUSE_SOURCE, FAULT},
    {IDLE, EXK_CAUSE_QUIT, DONE},     {RUN, EXK_CAUSE_END, DONE},
    {RUN, EXK_CAUSE_STOP, HOLD},      {RUN, EXK_CAUSE_TIMEOUT, HOLD},
    {RUN, EXK_CAUSE_ABORT, FAULT},    {RUN, EXK_CAUSE_SENSOR, FAULT},
    {RUN, EXK_CAUSE_LIMIT, FAULT},    {RUN, EXK_CAUSE_OVERRUN, FAULT},
    {RUN, EXK_CAUSE_SOURCE, FAULT},   {RUN, EXK_CAUSE_QUIT, DONE},
    {HOLD, EXK_CAUSE_START, RUN},     {HOLD, EXK_CAUSE_ABORT, FAULT},
    {HOLD, EXK_CAUSE_SENSOR, FAULT},  {HOLD, EXK_CAUSE_LIMIT, FAULT},
    {HOLD, EXK_CAUSE_OVERRUN, FAULT}, {HOLD, EXK_CAUSE_SOURCE, FAULT},
    {HOLD, EXK_CAUSE_QUIT, DONE},     {FAULT, EXK_CAUSE_CLEAR, IDLE},
};
/* clang-format on */

static const char *const state_names[EXK_STATE_COUNT] = {
    [INIT] = "init", [IDLE] = "idle",   [RUN] = "run",
    [HOLD] = "hold", [FAULT] = "fault", [DONE] = "done",
};

static const char *const cause_names[EXK_CAUSE_COUNT] = {
    [EXK_CAUSE_NONE] = "none",
    [EXK_CAUSE_READY] = "ready",
    [EXK_CAUSE_START] = "start",
    [EXK_CAUSE_STOP] = "stop",
    [EXK_CAUSE_ABORT] = "abort",
    [EXK_CAUSE_CLEAR] = "clear",
    [EXK_CAUSE_QUIT] = "quit",
    [EXK_CAUSE_END] = "end of plan",
    [EXK_CAUSE_TIMEOUT] = "command time-out",
    [EXK_CAUSE_SENSOR] = "sensor fault",
    [EXK_CAUSE_LIMIT] = "beyond limit",
    [EXK_CAUSE_OVERRUN] = "missed deadlines",
    [EXK_CAUSE_SOURCE] = "source failed",
};

const char *exk_state_name(exk_state state)
{
    return (unsigned)state < EXK_STATE_COUNT ? state_names[state] : "unknown";
}

const char *exk_cause_name(exk_cause cause)
{
    return (unsigned)cause < EXK_CAUSE_COUNT ? cause_names[cause] : "unknown";
}

size_t exk_state_transitions(const exk_transition **out)
{
    *out = table;
    return sizeof table / sizeof table[0];
}

void exk_state_init(exk_state_machine *sm)
{
    *sm = (exk_state_machine){.state = INIT, .k = -1};
}

static const exk_transition *find(exk_state from, exk_cause cause)
{
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        if (table[i].from == from && table[i].cause == cause) {
            return &table[i];
        }
    }
    return NULL;
}

bool exk_state_take(exk_state_machine *sm, exk_cause cause, int64_t k)
{
    const exk_transition *taken = find(sm->state, cause);
    if (taken == NULL) {
        sm->n_refused++;
        return false;
    }
    sm->state = taken->to;
    sm->cause = cause;
    sm->k = k;
    sm->n_taken++;
    if (sm->n_notes < EXK_STATE_NOTES) {
        sm->note[sm->n_notes++] = *taken;
    }
    return true;
}

void exk_state_forget_notes(exk_state_machine *sm)
{
    sm->n_notes = 0;
}
