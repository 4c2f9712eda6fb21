#include "exk/telemetry.h"

void exk_record_loop(exk_record *record, exk_loop *loop)
{
    record->n_bad = loop->n_bad;
    record->state = (int32_t)loop->sm.state;
    record->fault = (int32_t)loop->fault;
    exk_loop_tell(loop, &record->loop);
    record->n_notes = exk_loop_take_notes(loop, record->note);
}
