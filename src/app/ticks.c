#include "ticks.h"

#include <math.h>

#include "exk/stop_signal.h"

static const double publish_after_fault_s =
    0.5; /* the command at rest goes on being published */

static int64_t now_ns(void)
{
    const exk_clock clock = exk_clock_monotonic();
    return clock.now_ns(clock.ctx);
}

static void note_progress(loop_ticks *t, int64_t k)
{
    atomic_store_explicit(&t->progress.k, k, memory_order_relaxed);
    atomic_store_explicit(&t->progress.n_missed, t->pacer.n_missed, memory_order_relaxed);
    atomic_store_explicit(&t->progress.hole, t->record.sample.hole, memory_order_relaxed);
}

static void note_fault(loop_ticks *t, int64_t k)
{
    const exk_loop *loop = &t->rig->loop;
    const bool faulty = loop->sm.state == EXK_STATE_FAULT;
    const bool at_rest = faulty && exk_loop_is_over(loop);
    t->k_fault = !faulty ? -1 : t->k_fault < 0 ? k : t->k_fault;
    t->k_rest = !at_rest ? -1 : t->k_rest < 0 ? k : t->k_rest;
}

/* With commands allowed a fault waits for clear; without, it is published a while and ends the run. */
static bool is_over(const loop_ticks *t, int64_t k)
{
    const double rested_s = (double)(k - t->k_rest) * t->rig->plan.cfg.dt_s;
    const bool rested = t->k_rest >= 0 && rested_s >= publish_after_fault_s;
    return exk_stop_signal() != 0 || t->rig->loop.sm.state == EXK_STATE_DONE ||
           (rested && t->inbox == NULL);
}

static void note_bus(loop_ticks *t)
{
    if (t->link != NULL && !t->fast) {
        exk_link_counts_so_far(t->link, &t->record.bus.link);
        t->record.bus.n_dropped = exk_link_dropped(t->link);
    }
    if (t->inbox != NULL) {
        exk_inbox_counts(t->inbox, &t->record.bus.command);
        t->record.bus.n_dropped =
            exk_inbox_dropped(t->inbox); /* of all sockets of the process */
    }
}

static void hand_ring_over(loop_ticks *t)
{
    exk_capture *capture = t->rig->loop.cfg.capture;
    const bool faulty = t->rig->loop.sm.state == EXK_STATE_FAULT;
    const int ring = atomic_load_explicit(&t->ring, memory_order_acquire);
    if (capture == NULL) {
        return;
    }
    if (faulty && capture->frozen && ring == LOOP_RING_FILLS) {
        t->fault_record = t->record;
        atomic_store_explicit(&t->ring, LOOP_RING_LENT, memory_order_release);
    } else if (!faulty && ring == LOOP_RING_WRITTEN) {
        exk_capture_reset(capture);
        atomic_store_explicit(&t->ring, LOOP_RING_FILLS, memory_order_release);
    }
}

/* The record of tick k, whose sample is there. False: this was the last one. */
static bool close_tick(loop_ticks *t, int64_t k)
{
    exk_loop *loop = &t->rig->loop;
    note_fault(t, k);
    const bool over = is_over(t, k);
    if (over) {
        exk_loop_request(loop, EXK_CAUSE_QUIT, k); /* refused where it is over already */
    }
    exk_record_loop(&t->record, loop);
    note_bus(t);
    hand_ring_over(t);
    exk_publisher_push(t->publisher, &t->record);
    note_progress(t, k);
    return !over;
}

static void run_fast(loop_ticks *t)
{
    int64_t k = 0;
    do {
        exk_loop_step(&t->rig->loop, k, &t->record.sample);
    } while (close_tick(t, k++));
}

static void obey(loop_ticks *t, exk_command command, int64_t k)
{
    static const exk_cause causes[EXK_COMMAND_COUNT] = {
        [EXK_COMMAND_ALIVE] = EXK_CAUSE_NONE,  [EXK_COMMAND_START] = EXK_CAUSE_START,
        [EXK_COMMAND_STOP] = EXK_CAUSE_STOP,   [EXK_COMMAND_ABORT] = EXK_CAUSE_ABORT,
        [EXK_COMMAND_CLEAR] = EXK_CAUSE_CLEAR,
    };
    if (command != EXK_COMMAND_ALIVE) {
        exk_loop_request(&t->rig->loop, causes[command], k);
    }
}

/* Only commands that passed the gate come here, so nothing else feeds the watchdog. */
static void take_commands(loop_ticks *t, int64_t k)
{
    const double timeout_s = t->rig->profile.command.timeout_s;
    exk_loop *loop = &t->rig->loop;
    exk_command command;
    if (t->inbox == NULL) {
        return;
    }
    while (exk_inbox_take(t->inbox, &command)) {
        t->k_command = k;
        obey(t, command, k);
    }
    const double silent_s = (double)(k - t->k_command) * t->rig->plan.cfg.dt_s;
    if (timeout_s > 0.0 && silent_s > timeout_s && loop->sm.state == EXK_STATE_RUN) {
        exk_loop_request(loop, EXK_CAUSE_TIMEOUT, k);
    }
}

static void check_deadlines(loop_ticks *t, int64_t k)
{
    const exk_pacer *pacer = &t->pacer;
    const double missed_max = t->rig->profile.timing.n_missed_max;
    const double missed = (double)pacer->n_missed_row;
    if (missed >= missed_max || pacer->unmet) {
        const exk_sample *last = &t->rig->loop.last;
        const exk_violation clock = {EXK_QUANTITY_CLOCK, -1, EXK_PACER_TRIES, EXK_PACER_TRIES};
        const exk_violation row = {EXK_QUANTITY_DEADLINES, -1, missed, missed_max};
        const exk_violation what = missed >= missed_max ? row : clock;
        const exk_fault_report report = {.cause = EXK_CAUSE_OVERRUN,
                                         .err = EXK_ERR_OVERRUN,
                                         .what = what,
                                         .k = k,
                                         .phase = last->phase,
                                         .hole_id = last->hole_id};
        exk_loop_fail(&t->rig->loop, &report);
    }
}

/* Ticks that were missed at the end of the plan do not lead past it. */
static int64_t next_tick(loop_ticks *t)
{
    const exk_loop *loop = &t->rig->loop;
    const int64_t k = exk_pacer_next(&t->pacer);
    const int64_t last = exk_loop_last_tick(loop);
    const int64_t least = loop->motion.k + 1;
    return k <= last ? k : last > least ? last : least;
}

static void begin_tick(loop_ticks *t, int64_t k)
{
    t->record.lateness_ns = t->pacer.lateness_ns;
    t->record.n_overruns = t->pacer.n_missed;
    exk_histogram_add(&t->lateness, t->pacer.lateness_ns);
    check_deadlines(t, k);
    take_commands(t, k);
}

static void end_tick(loop_ticks *t, int64_t begin_ns)
{
    t->record.step_ns = now_ns() - begin_ns;
    exk_histogram_add(&t->step_time, t->record.step_ns);
}

static void run_paced(loop_ticks *t)
{
    bool more = true;
    while (more) {
        const int64_t k = next_tick(t);
        const int64_t begin_ns = now_ns();
        begin_tick(t, k);
        exk_loop_step(&t->rig->loop, k, &t->record.sample);
        more = close_tick(t, k);
        end_tick(t, begin_ns);
    }
}

static void send_tick(loop_ticks *t, int64_t k)
{
    exk_drive drive;
    exk_loop_command(&t->rig->loop, k, &drive);
    if (exk_loop_moves(&t->rig->loop)) {
        exk_link_send(t->link, k, &drive);
    }
}

static bool answer_tick(loop_ticks *t, int64_t k)
{
    exk_reading reading;
    exk_link_collect(t->link, k, &reading);
    exk_loop_measure(&t->rig->loop, &reading, &t->record.sample);
    return close_tick(t, k);
}

static void run_linked(loop_ticks *t)
{
    int64_t k_open = -1;
    bool more = true;
    while (more) {
        const int64_t k = next_tick(t);
        const int64_t begin_ns = now_ns();
        more = k_open < 0 || answer_tick(t, k_open);
        begin_tick(t, k);
        if (more) {
            send_tick(t, k);
            k_open = k;
        }
        end_tick(t, begin_ns);
    }
}

void loop_ticks_run(loop_ticks *t)
{
    const exk_timing_config *timing = &t->rig->profile.timing;
    t->k_fault = -1;
    t->k_rest = -1;
    if (t->fast) {
        run_fast(t);
        return;
    }
    if (t->clock.now_ns == NULL) {
        t->clock = exk_clock_monotonic();
    }
    exk_pacer_start(&t->pacer, t->clock, llround(1e9 / timing->rate_Hz),
                    llround(timing->spin_s * 1e9));
    if (t->link != NULL) {
        run_linked(t);
    } else {
        run_paced(t);
    }
}
