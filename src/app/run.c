#define _POSIX_C_SOURCE 200809L
#include "run.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "capture_file.h"
#include "exk/bus.h"
#include "exk/event_file.h"
#include "exk/input.h"
#include "exk/realtime.h"
#include "exk/solo.h"
#include "exk/stop_signal.h"
#include "exk/telemetry.h"
#include "summary.h"
#include "ticks.h"

enum { EXIT_ENDED_EARLY = 1, EXIT_INPUT = 2, EXIT_IO = 3 };
enum { LISTEN_MS = 200 };

static int64_t now_ns(void)
{
    const exk_clock clock = exk_clock_monotonic();
    return clock.now_ns(clock.ctx);
}

static int64_t fresh_run_id(void)
{
    char text[64];
    const int n = snprintf(text, sizeof text, "%" PRId64 " %ld", now_ns(), (long)getpid());
    return (int64_t)(exk_store_hash(text, (size_t)n) >> 1);
}

static const char *bus_url(const loop_options *options, const exk_rig *rig)
{
    return options->url != NULL ? options->url : rig->profile.telemetry.url;
}

static bool publishes(const loop_options *options)
{
    return !options->off_bus && (!options->fast || options->on_bus);
}

static bool drives_bus(const exk_rig *rig)
{
    return rig->from == EXK_FROM_BUS;
}

static bool takes_commands(const loop_options *options, const exk_rig *rig)
{
    return rig->profile.command.allow && publishes(options) && !options->fast;
}

static void describe(const loop_options *options, loop_ticks *r, exk_realisation which,
                     exk_run_info *info)
{
    const exk_rig *rig = r->rig;
    *info = (exk_run_info){
        .profile = &rig->profile,
        .job_hash = rig->job_hash,
        .run_id = options->fast ? exk_rig_run_id(rig, which) : fresh_run_id(),
        .series = which.series,
        .run = which.run,
        .holes = rig->holes,
        .n_holes = rig->n_holes,
        .n_ticks = rig->plan.n_ticks,
        .start_utime_us = options->fast ? 0 : exk_wall_us(),
        .fast = options->fast,
        .url = publishes(options) ? bus_url(options, rig) : NULL,
        .record_path = options->record_path,
        .lateness = options->fast ? NULL : &r->lateness,
        .step_time = options->fast ? NULL : &r->step_time,
    };
}

static bool complain(const char *why)
{
    fprintf(stderr, "exk-loop: %s\n", why);
    return false;
}

/* One controller on a bus. A run that neither publishes nor drives disturbs nobody. */
static bool is_alone(const loop_options *options, const exk_rig *rig)
{
    char why[1024];
    const char *url = bus_url(options, rig);
    if (!publishes(options) && !drives_bus(rig)) {
        return true;
    }
    return (exk_bus_url_good(url, why, sizeof why) &&
            exk_solo_claim("controller", url, why, sizeof why) &&
            exk_solo_listen(url, LISTEN_MS, why, sizeof why)) ||
           complain(why);
}

static bool record_allowed(const loop_options *options)
{
    char why[512];
    if (options->record_path == NULL ||
        exk_event_path_allowed(options->record_path, why, sizeof why)) {
        return true;
    }
    return complain(why);
}

static bool start_publisher(loop_ticks *r, exk_run_info *info)
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
        return complain(why);
    }
    return true;
}

/* What the loop drives: told by the profile or by --source, which does not change the profile's text. */
static bool open_link(const loop_options *options, loop_ticks *r, const exk_run_info *info)
{
    char why[1024];
    const exk_timing_config *timing = &r->rig->profile.timing;
    const exk_link_config cfg = {
        .url = bus_url(options, r->rig),
        .run_id = info->run_id,
        .which = {.seed = timing->seed, .series = info->series, .run = info->run},
        .dt_s = timing->dt_s,
        .answer_s = timing->answer_s,
        .priority = timing->priority,
        .fast = options->fast,
    };
    if (!drives_bus(r->rig)) {
        return true;
    }
    r->link = exk_link_open(&cfg, why, sizeof why);
    if (r->link == NULL) {
        return complain(why);
    }
    r->rig->bus = exk_link_source(r->link);
    return true;
}

static bool load_gate(const loop_options *options, const exk_rig *rig, int64_t run_id,
                      exk_gate *gate)
{
    char path[2 * EXK_PATH_MAX];
    char why[2 * EXK_PATH_MAX + 256];
    exk_key_secret key;
    const exk_command_config *command = &rig->profile.command;
    exk_input_beside(options->profile_path, command->key_file, path, sizeof path);
    if (!exk_key_load(path, &key, why, sizeof why)) {
        return complain(why);
    }
    exk_gate_init(gate, &key, run_id, (int64_t)(command->fresh_s * 1e6));
    exk_key_wipe(&key);
    return true;
}

/* 0, or an exit code. */
static int open_inbox(const loop_options *options, loop_ticks *r, const exk_run_info *info)
{
    char why[1024];
    exk_gate gate;
    if (!takes_commands(options, r->rig)) {
        return 0;
    }
    if (!load_gate(options, r->rig, info->run_id, &gate)) {
        return EXIT_INPUT;
    }
    r->inbox = exk_inbox_open(info->url, &gate, why, sizeof why);
    exk_key_wipe(&gate.key);
    if (r->inbox == NULL) {
        complain(why);
        return EXIT_IO;
    }
    return 0;
}

static void ask_rights(const loop_options *options, loop_ticks *r)
{
    exk_rights rights;
    const exk_timing_config *timing = &r->rig->profile.timing;
    exk_rights_ask(timing->priority, timing->cpu, &rights);
    exk_publisher_set_rights(r->publisher, rights.text);
    if (!options->quiet) {
        fprintf(stderr, "exk-loop: %s\n", rights.text);
    }
}

static int finish(const loop_options *options, loop_ticks *r)
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
        .signal = exk_stop_signal(),
        .has_log = options->record_path != NULL && summary.file_ok,
        .on_link = r->link != NULL && !r->fast,
        .took_commands = r->inbox != NULL,
        .lateness = r->fast ? NULL : &r->lateness,
        .step_time = r->fast ? NULL : &r->step_time,
    };
    loop_summary_print(&ending, options->quiet);
    if (!summary.bus_ok || !summary.file_ok) {
        return EXIT_IO; /* the publisher said why when it happened */
    }
    return exk_stop_signal() != 0 || r->k_fault >= 0 ? EXIT_ENDED_EARLY : 0;
}

static void close_bus(loop_ticks *r)
{
    exk_inbox_close(r->inbox);
    exk_link_close(r->link);
    r->inbox = NULL;
    r->link = NULL;
}

static bool set_up_loop(loop_ticks *r, const exk_run_info *info, const exk_store *store)
{
    exk_rig *rig = r->rig;
    const exk_realisation which = {
        .seed = rig->profile.timing.seed, .series = info->series, .run = info->run};
    const double *const u_rad[EXK_N_AXES] = {store == NULL ? NULL : store->u_rad[EXK_ALPHA],
                                             store == NULL ? NULL : store->u_rad[EXK_BETA]};
    const exk_err err = exk_rig_start(rig, which, u_rad, store == NULL ? 0 : store->n_samples);
    if (err != EXK_OK) {
        fprintf(stderr, "exk-loop: the loop cannot be set up: %s\n", exk_err_name(err));
        return false;
    }
    rig->loop.cfg.waits = r->inbox != NULL && rig->profile.command.wait;
    return true;
}

/* Everything that may be refused or fail comes before the first tick; 0, or an exit code. */
static int open_all(const loop_options *options, loop_ticks *r, exk_run_info *info,
                    const exk_store *store)
{
    if (!record_allowed(options) || !is_alone(options, r->rig)) {
        return EXIT_INPUT;
    }
    int code = open_inbox(options, r, info);
    if (code == 0 && !open_link(options, r, info)) {
        code = EXIT_IO;
    }
    if (code == 0 && info->record_path != NULL && !exk_rig_capture(r->rig, loop_capture_s)) {
        complain("out of memory for the samples before a fault");
        code = EXIT_IO;
    }
    if (code == 0 && !set_up_loop(r, info, store)) {
        code = EXIT_INPUT;
    }
    if (code == 0 && !start_publisher(r, info)) {
        code = EXIT_IO;
    }
    if (code != 0) {
        close_bus(r);
    }
    return code;
}

static int run_ticks(const loop_options *options, loop_ticks *r, const exk_run_info *info)
{
    if (!options->fast) {
        ask_rights(options, r);
    }
    r->progress.n_ticks = r->rig->plan.n_ticks;
    r->progress.n_holes = (int32_t)r->rig->n_holes;
    loop_keeper keeper;
    loop_keeper_start(&keeper, r, info);
    loop_progress_start(&r->progress, !options->quiet);
    loop_ticks_run(r);
    int code = finish(options, r);
    if (!loop_keeper_stop(&keeper)) {
        code = EXIT_IO;
    }
    close_bus(r);
    return code;
}

int loop_run(const loop_options *options, exk_rig *rig, const exk_store *store)
{
    static loop_ticks r; /* large: histograms and the record */
    exk_run_info info;
    const exk_realisation which = {
        .seed = rig->profile.timing.seed, .series = options->series, .run = options->run};
    r = (loop_ticks){.rig = rig, .fast = options->fast};
    if (options->source != NULL) { /* the profile's text stays, so that logs can be compared */
        rig->from = strcmp(options->source, "bus") == 0 ? EXK_FROM_BUS : EXK_FROM_TWIN;
    }
    describe(options, &r, which, &info);
    exk_stop_catch();
    const int code = open_all(options, &r, &info, store);
    return code != 0 ? code : run_ticks(options, &r, &info);
}
