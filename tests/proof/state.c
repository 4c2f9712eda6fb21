/* State machine: any causes in any order, numbers that are no cause too; the state stays one of the six. */
#include "exk/state.h"
#include "any.h"

int main(void)
{
    exk_state_machine sm;
    exk_state_init(&sm);
    while (any_of(2) != 0) {
        sm.n_taken = 0; /* counts of 63 bits do not end within the life of a machine */
        sm.n_refused = 0;
        (void)exk_state_take(&sm, (exk_cause)(unsigned)exk_any_int, exk_any_tick);
        /*@ assert state: 0 <= sm.state < EXK_STATE_COUNT; */
        /*@ assert notes: 0 <= sm.n_notes <= EXK_STATE_NOTES; */
        (void)exk_state_name(sm.state);
        (void)exk_cause_name(sm.cause);
        if (any_of(2) != 0) {
            exk_state_forget_notes(&sm);
        }
    }
    return 0;
}
