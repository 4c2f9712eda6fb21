#define _POSIX_C_SOURCE 200809L
#include "run.h"

#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "exk/event_file.h"
#include "exk/realtime.h"
#include "exk/telemetry.h"
#include "progress.h"
#include "summary.h"

enum { EXIT_ENDED_EARLY = 1, EXIT_INPUT = 2, EXIT_IO = 3 };
static const double hold_after_fault_s = 0.5; /* go on publishing the held command this long */

static volatile sig_atomic_t stop_signal;

static void on_signal(int number)
{
    stop_signal = number;
}

static void catch_signals(void)
{
    struct sigaction action = {.sa_handler = on_signal};
    sigemptyset(&action.sa_mask);
    stop_signal = 0;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    signal(SIGPIPE, SIG_IGN);
}

typedef struct {
    exk_rig *rig;
    exk_publisher *publisher;
    exk_pacer pacer;
    exk_histogram lateness;
    exk_histogram step_time;
    loop_progress progress;
    exk_record record;
    int64_t k_fault; /* tick of the fault, -1: none */
    bool fast;
} run;

static int64_t now_ns(void)
{
    const exk_clock clock = exk_clock_monotonic();
    return clock.now_ns(clock.ctx);
}

static void note_progress(run *r, int64_t k)
{
    atomic_store_explicit(&r->progress.k, k, memory_order_relaxed);
    atomic_store_explicit(&r->progress.n_missed, r->pacer.n_missed, memory_order_relaxed);
    atomic_store_explicit(&r->progress.hole, r->record.sample.hole, memory_order_relaxed);
}

/* One step and its record. False: this was the last one. */
static bool step_and_push(run *r, int64_t k)
{
    exk_loop *loop = &r->rig->loop;
    const int64_t last = r->rig->plan.n_ticks - 1;
    exk_loop_step(loop, k, &r->record.sample);
    if (loop->sm.state == EXK_STATE_FAULT && r->k_fault < 0) {
        r->k_fault = k;
    }
    const double held_s = (double)(k - r->k_fault) * r->rig->plan.cfg.dt_s;
    const bool held = r->k_fault >= 0 && held_s >= hold_after_fault_s;
    const bool stopped = stop_signal != 0 || k >= last || held;
    r->record.n_bad = loop->n_bad;
    r->record.fault = (int32_t)loop->fault;
    r->record.state = (int32_t)loop->sm.state;
    if (stopped && loop->sm.state != EXK_STATE_FAULT) {
        r->record.state = EXK_STATE_DONE;
    }
    exk_publisher_push(r->publisher, &r->record);
    note_progress(r, k);
    return !stopped;
}

static void run_fast(run *r)
{
    int64_t k = 0;
    while (step_and_push(r, k)) {
        k++;
    }
}

static bool paced_step(run *r)
{
    const exk_rig *rig = r->rig;
    int64_t k = exk_pacer_next(&r->pacer);
    const int64_t begin_ns = now_ns();
    if (r->pacer.n_missed_row >= rig->profile.timing.n_missed_max) {
        const exk_fault_report report = {
            .cause = EXK_CAUSE_OVERRUN, .err = EXK_ERR_OVERRUN, .k = k};
        exk_loop_fail(&r->rig->loop, &report);
    }
    k = k < rig->plan.n_ticks ? k : rig->plan.n_ticks - 1;
    r->record.lateness_ns = r->pacer.lateness_ns;
    r->record.n_overruns = r->pacer.n_missed;
    const bool more = step_and_push(r, k);
    r->record.step_ns = now_ns() - begin_ns;
    exk_histogram_add(&r->lateness, r->pacer.lateness_ns);
    exk_histogram_add(&r->step_time, r->record.step_ns);
    return more;
}

static void run_paced(run *r)
{
    const exk_timing_config *timing = &r->rig->profile.timing;
    exk_pacer_start(&r->pacer, exk_clock_monotonic(), llround(1e9 / timing->rate_Hz),
                    llround(timing->spin_s * 1e9));
    while (paced_step(r)) {
    }
}

static int64_t wall_us(void)
{
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    return (int64_t)now.tv_sec * 1000000 + now.tv_nsec / 1000;
}

static int64_t fresh_run_id(void)
{
    char text[64];
    const int n = snprintf(text, sizeof text, "%" PRId64 " %ld", now_ns(), (long)getpid());
    return (int64_t)(exk_store_hash(text, (size_t)n) >> 1);
}

static void describe(const loop_options *options, run *r, exk_realisation which,
                     exk_run_info *info)
{
    const exk_rig *rig = r->rig;
    const bool on_bus = !options->off_bus && (!options->fast || options->on_bus);
    *info = (exk_run_info){
        .profile = &rig->profile,
        .job_hash = rig->job_hash,
        .run_id = options->fast ? exk_rig_run_id(rig, which) : fresh_run_id(),
        .series = which.series,
        .run = which.run,
        .holes = rig->holes,
        .n_holes = rig->n_holes,
        .n_ticks = rig->plan.n_ticks,
        .start_utime_us = options->fast ? 0 : wall_us(),
        .fast = options->fast,
        .url = !on_bus                ? NULL
               : options->url != NULL ? options->url
                                      : rig->profile.telemetry.url,
        .record_path = options->record_path,
        .lateness = options->fast ? NULL : &r->lateness,
        .step_time = options->fast ? NULL : &r->step_time,
    };
}

static bool record_allowed(const loop_options *options)
{
    char why[512];
    if (options->record_path == NULL ||
        exk_event_path_allowed(options->record_path, why, sizeof why)) {
        return true;
    }
    fprintf(stderr, "exk-loop: %s\n", why);
    return false;
}

static bool start_publisher(run *r, exk_run_info *info)
{
    char why[512];
    const size_t length = exk_profile_print(info->profile, NULL, 0);
    char *text = malloc(length + 1);
    if (text == NULL) {
        fprintf(stderr, "exk-loop: out of memory\n");
        return false;
    }
    exk_profile_print(info->profile, text, length + 1);
    info->profile_text = text;
    r->publisher = exk_publisher_start(info, why, sizeof why);
    free(text);
    if (r->publisher == NULL) {
        fprintf(stderr, "exk-loop: %s\n", why);
        return false;
    }
    return true;
}

static void ask_rights(const loop_options *options, run *r)
{
    exk_rights rights;
    const exk_timing_config *timing = &r->rig->profile.timing;
    exk_rights_ask(timing->priority, timing->cpu, &rights);
    exk_publisher_set_rights(r->publisher, rights.text);
    if (!options->quiet) {
        fprintf(stderr, "exk-loop: %s\n", rights.text);
    }
}

static int finish(const loop_options *options, run *r)
{
    exk_publish_summary summary;
    exk_publisher_stop(r->publisher, &summary);
    loop_progress_stop(&r->progress);
    const loop_ending ending = {
        .rig = r->rig,
        .summary = &summary,
        .record = &r->record,
        .k_fault = r->k_fault,
        .n_missed = r->pacer.n_missed,
        .signal = stop_signal,
        .lateness = r->fast ? NULL : &r->lateness,
        .step_time = r->fast ? NULL : &r->step_time,
    };
    loop_summary_print(&ending, options->quiet);
    if (!summary.bus_ok || !summary.file_ok) {
        return EXIT_IO; /* the publisher said why when it happened */
    }
    return stop_signal != 0 || r->k_fault >= 0 ? EXIT_ENDED_EARLY : 0;
}

int loop_run(const loop_options *options, exk_rig *rig, const exk_store *store)
{
    static run r; /* large: histograms and the record */
    exk_run_info info;
    const exk_realisation which = {
        .seed = rig->profile.timing.seed, .series = options->series, .run = options->run};
    const double *const u_rad[EXK_N_AXES] = {store == NULL ? NULL : store->u_rad[EXK_ALPHA],
                                             store == NULL ? NULL : store->u_rad[EXK_BETA]};
    const exk_err err = exk_rig_start(rig, which, u_rad, store == NULL ? 0 : store->n_samples);
    if (err != EXK_OK) {
        fprintf(stderr, "exk-loop: the loop cannot be set up: %s\n", exk_err_name(err));
        return EXIT_INPUT;
    }
    r = (run){.rig = rig, .k_fault = -1, .fast = options->fast};
    describe(options, &r, which, &info);
    catch_signals();
    if (!record_allowed(options)) {
        return EXIT_INPUT;
    }
    if (!start_publisher(&r, &info)) {
        return EXIT_IO;
    }
    if (!options->fast) {
        ask_rights(options, &r);
    }
    r.progress.n_ticks = rig->plan.n_ticks;
    r.progress.n_holes = (int32_t)rig->n_holes;
    loop_progress_start(&r.progress, !options->quiet);
    if (options->fast) {
        run_fast(&r);
    } else {
        run_paced(&r);
    }
    return finish(options, &r);
}
