#include "exk/wire.h"

#include <string.h>

#include "exk_pose_t.h"

_Static_assert(EXK_POSE_T_TRAVEL == (int)EXK_PHASE_TRAVEL, "phases on the wire");
_Static_assert(EXK_POSE_T_APPROACH == (int)EXK_PHASE_APPROACH, "phases on the wire");
_Static_assert(EXK_POSE_T_DWELL == (int)EXK_PHASE_DWELL, "phases on the wire");
_Static_assert(EXK_POSE_T_DRILL == (int)EXK_PHASE_DRILL, "phases on the wire");
_Static_assert(EXK_POSE_T_RETRACT == (int)EXK_PHASE_RETRACT, "phases on the wire");

/* Copies between arrays of the same type and length; another shape does not compile. */
#define COPY(to, from)                                                                         \
    do {                                                                                       \
        _Static_assert(sizeof(to) == sizeof(from), "same shape");                              \
        memcpy((to), (from), sizeof(to));                                                      \
    } while (0)

static void pack_flags(exk_pose_t *m, const exk_sample *s)
{
    m->k = s->k;
    m->time_us = s->time_us;
    m->phase = (int8_t)s->phase;
    m->judged = s->judged;
    m->sensor_ok = s->sensor_ok;
    m->has_true = s->has_true;
    m->hole = s->hole;
    m->hole_id = s->hole_id;
}

static void pack_values(exk_pose_t *m, const exk_sample *s)
{
    COPY(m->ref_tip_m, s->ref.tip_m);
    COPY(m->ref_axis, s->ref.axis);
    COPY(m->est_tip_m, s->est.tip_m);
    COPY(m->est_axis, s->est.axis);
    COPY(m->true_tip_m, s->real.tip_m);
    COPY(m->true_axis, s->real.axis);
    COPY(m->r_rad, s->r_rad);
    COPY(m->m_rad, s->m_rad);
    COPY(m->theta_rad, s->theta_rad);
    COPY(m->q_rad, s->q_rad);
    COPY(m->c_rad, s->c_rad);
    COPY(m->u_rad, s->u_rad);
    m->h_m = s->h_m;
    COPY(m->legs_m, s->legs_m);
    COPY(m->wrist_rad, s->wrist_rad);
}

int exk_wire_pose_encode(const exk_wire_pose *pose, void *buffer, size_t size)
{
    exk_pose_t m;
    m.run_id = pose->run_id;
    m.seq = pose->seq;
    pack_flags(&m, &pose->sample);
    pack_values(&m, &pose->sample);
    m.lateness_ns = pose->lateness_ns;
    m.step_ns = pose->step_ns;
    return exk_pose_t_encode(buffer, 0, (int)size, &m);
}

static void unpack_flags(exk_sample *s, const exk_pose_t *m)
{
    s->k = m->k;
    s->time_us = m->time_us;
    s->phase = (exk_phase)m->phase;
    s->judged = m->judged;
    s->sensor_ok = m->sensor_ok;
    s->has_true = m->has_true;
    s->hole = m->hole;
    s->hole_id = m->hole_id;
}

static void unpack_values(exk_sample *s, const exk_pose_t *m)
{
    COPY(s->ref.tip_m, m->ref_tip_m);
    COPY(s->ref.axis, m->ref_axis);
    COPY(s->est.tip_m, m->est_tip_m);
    COPY(s->est.axis, m->est_axis);
    COPY(s->real.tip_m, m->true_tip_m);
    COPY(s->real.axis, m->true_axis);
    COPY(s->r_rad, m->r_rad);
    COPY(s->m_rad, m->m_rad);
    COPY(s->theta_rad, m->theta_rad);
    COPY(s->q_rad, m->q_rad);
    COPY(s->c_rad, m->c_rad);
    COPY(s->u_rad, m->u_rad);
    s->h_m = m->h_m;
    COPY(s->legs_m, m->legs_m);
    COPY(s->wrist_rad, m->wrist_rad);
}

/* The type has no part of variable length, so one length is right and all others are wrong. */
bool exk_wire_pose_decode(const void *data, size_t bytes, exk_wire_pose *out)
{
    exk_pose_t m;
    if (bytes > EXK_WIRE_POSE_MAX || exk_pose_t_decode(data, 0, (int)bytes, &m) != (int)bytes) {
        return false;
    }
    if (m.phase < 0 || m.phase >= (int)EXK_PHASE_COUNT) {
        return false;
    }
    memset(out, 0, sizeof *out);
    out->run_id = m.run_id;
    out->seq = m.seq;
    unpack_flags(&out->sample, &m);
    unpack_values(&out->sample, &m);
    out->lateness_ns = m.lateness_ns;
    out->step_ns = m.step_ns;
    return true;
}
