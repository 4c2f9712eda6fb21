#define _DEFAULT_SOURCE
#include "telemetry_samples.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "unity.h"

static char folder[64];
static const double error_m[RUN_HOLES] = {10e-6, 50e-6};

void make_run(made_up_run *run)
{
    memset(run, 0, sizeof *run);
    snprintf(run->profile.name, sizeof run->profile.name, "made_up");
    run->profile.timing.dt_s = 0.1;
    run->profile.timing.rate_Hz = 10.0;
    run->profile.job.tolerance_m = 30e-6;
    run->profile.telemetry.every = 1;
    run->profile.telemetry.ring_slots = 64;
    run->profile.telemetry.status_Hz = 2.0;
    for (int i = 0; i < RUN_HOLES; i++) {
        run->holes[i] =
            (exk_hole){.id = 7 + i, .target_m = {0.1 * i, 0.2, 1.0}, .axis = {0, 0, 1}};
    }
    run->info = (exk_run_info){.profile = &run->profile,
                               .profile_text = "[job]\ntolerance_mm = 0.03\n",
                               .job_hash = 0xABCDEF0123456789U,
                               .run_id = 99,
                               .series = 3,
                               .run = 4,
                               .holes = run->holes,
                               .n_holes = RUN_HOLES,
                               .n_ticks = RUN_TICKS,
                               .fast = true};
}

static exk_phase phase_of(int64_t tick)
{
    return tick < 5 ? EXK_PHASE_TRAVEL : tick < 8 ? EXK_PHASE_DWELL : EXK_PHASE_DRILL;
}

exk_sample make_sample(const made_up_run *run, int64_t k)
{
    const int32_t hole = (int32_t)(k / RUN_TICKS_PER_HOLE);
    const int64_t tick = k % RUN_TICKS_PER_HOLE;
    exk_sample s;
    memset(&s, 0, sizeof s);
    s.k = k;
    s.time_us = k * 100000;
    s.phase = phase_of(tick);
    s.hole = hole;
    s.hole_id = run->holes[hole].id;
    s.judged = tick == 7;
    s.sensor_ok = true;
    s.has_true = true;
    memcpy(s.ref.tip_m, run->holes[hole].target_m, sizeof s.ref.tip_m);
    memcpy(s.ref.axis, run->holes[hole].axis, sizeof s.ref.axis);
    s.est = s.ref;
    s.real = s.ref;
    s.real.tip_m[EXK_X] += error_m[hole];
    s.r_rad[EXK_ALPHA] = 0.01 * (double)k;
    s.c_rad[EXK_BETA] = -0.001 * (double)k;
    s.h_m = 1.0;
    return s;
}

exk_record make_record(const made_up_run *run, int64_t k)
{
    exk_record record = {.sample = make_sample(run, k), .state = EXK_STATE_RUN};
    if (k == RUN_TICKS - 1) {
        record.state = EXK_STATE_DONE;
    }
    return record;
}

size_t make_pose(const made_up_run *run, int64_t run_id, int64_t seq, int64_t k, void *buffer)
{
    const exk_wire_pose pose = {
        .run_id = run_id, .seq = seq, .sample = make_sample(run, k % RUN_TICKS)};
    exk_wire_pose at_k = pose;
    at_k.sample.k = k;
    const int bytes = exk_wire_pose_encode(&at_k, buffer, EXK_WIRE_POSE_MAX);
    TEST_ASSERT_GREATER_THAN(0, bytes);
    return (size_t)bytes;
}

const char *scratch_path(const char *name)
{
    static char paths[8][128];
    static int next;
    if (folder[0] == '\0') {
        snprintf(folder, sizeof folder, "exk-test-XXXXXX");
        TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    }
    next = (next + 1) % 8;
    snprintf(paths[next], sizeof paths[next], "%s/%s", folder, name);
    return paths[next];
}

void clean_up(void)
{
    DIR *dir = folder[0] != '\0' ? opendir(folder) : NULL;
    if (dir == NULL) {
        return;
    }
    for (struct dirent *e = readdir(dir); e != NULL; e = readdir(dir)) {
        unlink(scratch_path(e->d_name));
    }
    closedir(dir);
    rmdir(folder);
    folder[0] = '\0';
}
