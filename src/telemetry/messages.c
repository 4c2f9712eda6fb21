#include "messages.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { JOB_PERIOD_US = 1000000 };

static const double median = 0.5;
static const double nearly_all = 0.99;

static int64_t newest_k(const exk_messages *m)
{
    return m->has_last ? m->last.sample.k : -1;
}

static int64_t newest_time_us(const exk_messages *m)
{
    return m->has_last ? m->last.sample.time_us : 0;
}

static exk_wire_stamp stamp(const exk_messages *m, int64_t seq)
{
    return (exk_wire_stamp){m->run_id, seq, newest_k(m), newest_time_us(m)};
}

static void send_job(exk_messages *m)
{
    m->job.stamp = stamp(m, m->n_jobs++);
    const int bytes = exk_wire_job_encode(&m->job, &m->scratch, m->job_buffer, m->job_bytes);
    exk_outlet_send(&m->out, EXK_CHANNEL_JOB, m->job_buffer, bytes, newest_time_us(m));
}

static void figures(const exk_histogram *hist, int64_t out_ns[3])
{
    if (hist == NULL) {
        return;
    }
    out_ns[0] = exk_histogram_quantile_ns(hist, median);
    out_ns[1] = exk_histogram_quantile_ns(hist, nearly_all);
    out_ns[2] = atomic_load_explicit(&hist->max_ns, memory_order_relaxed);
}

static void fill_status(exk_messages *m, bool last)
{
    exk_wire_status *s = &m->status;
    s->stamp = stamp(m, m->n_status++);
    s->utime_us = m->fast ? 0 : exk_wall_us();
    s->last = last;
    s->n_poses = m->n_numbered;
    s->n_steps = m->n_taken + s->n_dropped;
    if (m->has_last) {
        s->state = (exk_state)m->last.state;
        s->fault = m->last.fault;
        s->n_overruns = m->last.n_overruns;
        s->n_bad = m->last.n_bad;
        s->bus = m->last.bus;
        s->loop = m->last.loop;
        s->reason[0] = '\0';
        if (s->fault != EXK_OK) {
            exk_fault_text(&m->last.loop.fault, s->reason, sizeof s->reason);
        }
    }
    figures(m->lateness, s->lateness_ns);
    figures(m->step_time, s->step_ns);
}

static void send_filled_status(exk_messages *m)
{
    unsigned char buffer[EXK_WIRE_STATUS_MAX];
    const int bytes = exk_wire_status_encode(&m->status, buffer, sizeof buffer);
    exk_outlet_send(&m->out, EXK_CHANNEL_STATUS, buffer, bytes, newest_time_us(m));
}

static void send_status(exk_messages *m, bool last)
{
    fill_status(m, last);
    send_filled_status(m);
}

/* Every transition has its status; the last one is that of the record itself. */
static void send_notes(exk_messages *m)
{
    const exk_record *record = &m->last;
    for (int i = 0; i < record->n_notes && i < EXK_STATE_NOTES; i++) {
        fill_status(m, false);
        m->status.state = record->note[i].to;
        m->status.loop.cause = record->note[i].cause;
        m->status.loop.n_transitions -= record->n_notes - 1 - i;
        send_filled_status(m);
    }
}

static void send_hole(exk_messages *m, int32_t hole, bool on_true)
{
    const exk_hole_result *result = &m->results[hole];
    const int64_t time_us = llround((double)result->k * m->dt_s * 1e6);
    const exk_wire_hole message = {
        .stamp = {m->run_id, m->n_holes++, result->k, time_us},
        .hole = hole,
        .target = m->job.holes[hole],
        .result = *result,
        .tolerance_m = m->job.tolerance_m,
        .on_true = on_true,
    };
    unsigned char buffer[EXK_WIRE_HOLE_MAX];
    const int bytes = exk_wire_hole_encode(&message, buffer, sizeof buffer);
    m->status.n_drilled++;
    m->status.n_inside += result->inside ? 1 : 0;
    exk_outlet_send(&m->out, EXK_CHANNEL_HOLE, buffer, bytes, newest_time_us(m));
}

/* Only what is sent is judged, so that a reader of the log finds the same figures. */
static void judge(exk_messages *m, const exk_sample *s)
{
    const exk_judged_point point = {.k = s->k,
                                    .dwell = s->phase == EXK_PHASE_DWELL,
                                    .hole = s->hole,
                                    .ref = s->ref,
                                    .tool = s->has_true ? s->real : s->est};
    const int32_t hole = exk_judge_push(&m->judge, &point);
    if (hole >= 0) {
        send_hole(m, hole, s->has_true);
    }
}

static void send_pose(exk_messages *m, const exk_record *record, int64_t seq)
{
    const exk_wire_pose pose = {m->run_id, seq, record->sample, record->lateness_ns,
                                record->step_ns};
    unsigned char buffer[EXK_WIRE_POSE_MAX];
    const int bytes = exk_wire_pose_encode(&pose, buffer, sizeof buffer);
    exk_outlet_send(&m->out, EXK_CHANNEL_POSE, buffer, bytes, record->sample.time_us);
    m->n_poses++;
    m->n_numbered = seq + 1;
    judge(m, &record->sample);
}

/* The number of a pose that the ring refused meanwhile stays unused: a gap, as it should be. */
static void send_previous(exk_messages *m, int64_t k, int64_t seq)
{
    if (m->has_last && !m->last_sent && m->last.sample.k == k) {
        send_pose(m, &m->last, seq);
        m->last_sent = true;
    }
}

void exk_messages_take(exk_messages *m, const exk_slot *slot)
{
    const bool changed = !m->has_last || m->last.state != slot->record.state;
    if (slot->previous_k >= 0) {
        send_previous(m, slot->previous_k, slot->previous_seq);
    }
    m->last = slot->record;
    m->has_last = true;
    m->last_sent = slot->seq >= 0;
    m->n_taken++;
    if (m->last_sent) {
        send_pose(m, &m->last, slot->seq);
    }
    send_notes(m);
    if (changed && slot->record.n_notes == 0) {
        send_status(m, false);
    }
}

static void note_ring(exk_messages *m, const exk_ring_figures *ring)
{
    m->status.n_dropped = ring->n_dropped;
    m->status.ring_deepest = ring->deepest;
}

void exk_messages_set_rights(exk_messages *m, const char *text)
{
    snprintf(m->status.rights, sizeof m->status.rights, "%s", text);
}

void exk_messages_tick(exk_messages *m, int64_t now_us, const exk_ring_figures *ring)
{
    note_ring(m, ring);
    if (now_us >= m->next_job_us) {
        m->next_job_us = now_us + JOB_PERIOD_US;
        send_job(m);
        exk_outlet_flush(&m->out);
    }
    if (now_us >= m->next_status_us) {
        m->next_status_us = now_us + m->status_period_us;
        send_status(m, false);
    }
}

void exk_messages_begin(exk_messages *m)
{
    send_job(m);
    send_status(m, false);
    exk_outlet_flush(&m->out);
}

static bool ran_to_its_end(const exk_messages *m)
{
    return m->has_last && m->last.sample.k == m->job.n_ticks - 1;
}

void exk_messages_end(exk_messages *m, int64_t last_k, int64_t n_numbered,
                      const exk_ring_figures *ring)
{
    send_previous(m, last_k, n_numbered - 1);
    const int32_t hole = ran_to_its_end(m) ? exk_judge_end(&m->judge) : -1;
    if (hole >= 0) {
        send_hole(m, hole, m->last.sample.has_true);
    }
    m->n_numbered = n_numbered;
    note_ring(m, ring);
    send_status(m, true);
    exk_outlet_close(&m->out);
}
