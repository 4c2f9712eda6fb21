#include "exk/loop_report.h"

void exk_loop_tell(const exk_loop *loop, exk_loop_report *out)
{
    out->cause = loop->sm.cause;
    out->motion = loop->motion.mode;
    out->k_cause = loop->sm.k;
    out->n_transitions = loop->sm.n_taken;
    out->n_refused = loop->sm.n_refused;
    out->n_held = exk_motion_held(&loop->motion);
    for (int i = 0; i < EXK_SAMPLE_COUNT; i++) {
        out->n_rejected[i] = loop->guard.n[i];
    }
    out->fault = loop->report;
}

int exk_loop_take_notes(exk_loop *loop, exk_transition note[EXK_STATE_NOTES])
{
    const int n = loop->sm.n_notes;
    for (int i = 0; i < n; i++) {
        note[i] = loop->sm.note[i];
    }
    exk_state_forget_notes(&loop->sm);
    return n;
}
