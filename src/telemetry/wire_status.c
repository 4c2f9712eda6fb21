#include "exk/wire.h"

#include <string.h>

#include "exk_status_t.h"
#include "wire_text.h"

_Static_assert(EXK_STATUS_T_INIT == (int)EXK_STATE_INIT, "states on the wire");
_Static_assert(EXK_STATUS_T_IDLE == (int)EXK_STATE_IDLE, "states on the wire");
_Static_assert(EXK_STATUS_T_RUN == (int)EXK_STATE_RUN, "states on the wire");
_Static_assert(EXK_STATUS_T_HOLD == (int)EXK_STATE_HOLD, "states on the wire");
_Static_assert(EXK_STATUS_T_FAULT == (int)EXK_STATE_FAULT, "states on the wire");
_Static_assert(EXK_STATUS_T_DONE == (int)EXK_STATE_DONE, "states on the wire");

static void pack_stamp(exk_status_t *m, const exk_wire_status *s)
{
    m->run_id = s->stamp.run_id;
    m->seq = s->stamp.seq;
    m->k = s->stamp.k;
    m->time_us = s->stamp.time_us;
    m->utime_us = s->utime_us;
    m->state = (int8_t)s->state;
    m->last = s->last;
    m->fault = s->fault;
}

static void pack_counts(exk_status_t *m, const exk_wire_status *s)
{
    m->n_steps = s->n_steps;
    m->n_overruns = s->n_overruns;
    m->n_bad_samples = s->n_bad;
    m->n_poses = s->n_poses;
    m->n_dropped = s->n_dropped;
    m->ring_deepest = s->ring_deepest;
    m->n_drilled = s->n_drilled;
    m->n_inside = s->n_inside;
    m->lateness_p50_ns = s->lateness_ns[0];
    m->lateness_p99_ns = s->lateness_ns[1];
    m->lateness_max_ns = s->lateness_ns[2];
    m->step_p50_ns = s->step_ns[0];
    m->step_p99_ns = s->step_ns[1];
    m->step_max_ns = s->step_ns[2];
}

_Static_assert(sizeof(((exk_status_t *)0)->n_samples) ==
                   sizeof(((exk_loop_report *)0)->n_rejected),
               "kinds of samples on the wire");
_Static_assert(EXK_STATUS_T_SOURCE == (int)EXK_CAUSE_SOURCE &&
                   EXK_STATUS_T_SPIKE_SAMPLE == (int)EXK_SAMPLE_SPIKE &&
                   EXK_STATUS_T_OUT == (int)EXK_MOTION_OUT &&
                   EXK_STATUS_T_Q_CLOCK == (int)EXK_QUANTITY_CLOCK,
               "causes, samples, motions and quantities on the wire");

static void pack_loop(exk_status_t *m, const exk_loop_report *loop)
{
    m->cause = (int8_t)loop->cause;
    m->motion = (int8_t)loop->motion;
    m->k_cause = loop->k_cause;
    m->n_transitions = loop->n_transitions;
    m->n_events_refused = loop->n_refused;
    m->n_held = loop->n_held;
    m->fault_quantity = (int8_t)loop->fault.what.quantity;
    m->fault_index = (int8_t)loop->fault.what.index;
    m->fault_value = loop->fault.what.value;
    m->fault_limit = loop->fault.what.limit;
    m->fault_k = loop->fault.k;
    m->fault_hole_id = loop->fault.hole_id;
    memcpy(m->n_samples, loop->n_rejected, sizeof m->n_samples);
}

_Static_assert(sizeof(((exk_status_t *)0)->n_refused) ==
                   sizeof(((exk_command_counts *)0)->n_refused),
               "kinds of refusal on the wire");

static void pack_bus(exk_status_t *m, const exk_bus_counts *bus)
{
    m->n_answers_lost = bus->link.n_lost;
    m->n_answers_late = bus->link.n_late;
    m->n_answers_repeated = bus->link.n_repeated;
    m->n_answers_reordered = bus->link.n_reordered;
    m->n_answers_foreign = bus->link.n_foreign;
    m->n_commands = bus->command.n_taken;
    m->last_command_seq = bus->command.last_seq;
    memcpy(m->n_refused, bus->command.n_refused, sizeof m->n_refused);
    m->n_bus_dropped = bus->n_dropped;
}

/* The generated struct wants char pointers that it may write; it gets copies. */
int exk_wire_status_encode(const exk_wire_status *status, void *buffer, size_t size)
{
    char reason[EXK_FAULT_TEXT_MAX];
    char rights[EXK_WIRE_TEXT_MAX];
    exk_wire_copy_text(reason, sizeof reason, status->reason);
    exk_wire_copy_text(rights, sizeof rights, status->rights);
    exk_status_t m = {.reason = reason, .rights = rights};
    pack_stamp(&m, status);
    pack_counts(&m, status);
    pack_bus(&m, &status->bus);
    pack_loop(&m, &status->loop);
    return exk_status_t_encode(buffer, 0, (int)size, &m);
}

static size_t fixed_bytes(void)
{
    char empty[] = "";
    const exk_status_t m = {.reason = empty, .rights = empty};
    return (size_t)exk_status_t_encoded_size(&m) - 2 * (4 + 1);
}

static bool looks_whole(const void *data, size_t bytes)
{
    size_t at = fixed_bytes();
    return exk_wire_skip_text(data, bytes, &at) && exk_wire_skip_text(data, bytes, &at) &&
           at == bytes;
}

static void unpack_stamp(exk_wire_status *s, const exk_status_t *m)
{
    s->stamp = (exk_wire_stamp){m->run_id, m->seq, m->k, m->time_us};
    s->utime_us = m->utime_us;
    s->state = (exk_state)m->state;
    s->last = m->last;
    s->fault = m->fault;
    exk_wire_copy_text(s->reason, sizeof s->reason, m->reason);
    exk_wire_copy_text(s->rights, sizeof s->rights, m->rights);
}

static void unpack_counts(exk_wire_status *s, const exk_status_t *m)
{
    s->n_steps = m->n_steps;
    s->n_overruns = m->n_overruns;
    s->n_bad = m->n_bad_samples;
    s->n_poses = m->n_poses;
    s->n_dropped = m->n_dropped;
    s->ring_deepest = m->ring_deepest;
    s->n_drilled = m->n_drilled;
    s->n_inside = m->n_inside;
    s->lateness_ns[0] = m->lateness_p50_ns;
    s->lateness_ns[1] = m->lateness_p99_ns;
    s->lateness_ns[2] = m->lateness_max_ns;
    s->step_ns[0] = m->step_p50_ns;
    s->step_ns[1] = m->step_p99_ns;
    s->step_ns[2] = m->step_max_ns;
}

static void unpack_bus(exk_bus_counts *bus, const exk_status_t *m)
{
    bus->link.n_lost = m->n_answers_lost;
    bus->link.n_late = m->n_answers_late;
    bus->link.n_repeated = m->n_answers_repeated;
    bus->link.n_reordered = m->n_answers_reordered;
    bus->link.n_foreign = m->n_answers_foreign;
    bus->command.n_taken = m->n_commands;
    bus->command.last_seq = m->last_command_seq;
    memcpy(bus->command.n_refused, m->n_refused, sizeof m->n_refused);
    bus->n_dropped = m->n_bus_dropped;
}

static bool in_range(int8_t value, int count)
{
    return value >= 0 && value < count;
}

static bool unpack_loop(exk_loop_report *loop, const exk_status_t *m)
{
    loop->cause = (exk_cause)m->cause;
    loop->motion = (exk_motion_mode)m->motion;
    loop->k_cause = m->k_cause;
    loop->n_transitions = m->n_transitions;
    loop->n_refused = m->n_events_refused;
    loop->n_held = m->n_held;
    loop->fault.what.quantity = (exk_quantity)m->fault_quantity;
    loop->fault.what.index = m->fault_index;
    loop->fault.what.value = m->fault_value;
    loop->fault.what.limit = m->fault_limit;
    loop->fault.k = m->fault_k;
    loop->fault.hole_id = m->fault_hole_id;
    memcpy(loop->n_rejected, m->n_samples, sizeof m->n_samples);
    return in_range(m->cause, EXK_CAUSE_COUNT) && in_range(m->motion, EXK_MOTION_COUNT) &&
           in_range(m->fault_quantity, EXK_QUANTITY_COUNT);
}

bool exk_wire_status_decode(const void *data, size_t bytes, exk_wire_status *out)
{
    exk_status_t m = {0};
    if (bytes > INT32_MAX || !looks_whole(data, bytes) ||
        exk_status_t_decode(data, 0, (int)bytes, &m) != (int)bytes) {
        return false;
    }
    exk_wire_status s;
    memset(&s, 0, sizeof s);
    unpack_stamp(&s, &m);
    unpack_counts(&s, &m);
    unpack_bus(&s.bus, &m);
    const bool known = in_range(m.state, EXK_STATE_COUNT) && unpack_loop(&s.loop, &m);
    if (known) {
        memcpy(out, &s, sizeof s); /* with the zeros between its fields */
    }
    exk_status_t_decode_cleanup(&m);
    return known;
}
