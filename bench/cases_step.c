#include <stdio.h>

#include "bench.h"
#include "exk/rig.h"
#include "exk/telemetry.h"

enum { SLOTS = 4096 };
static exk_rig machine;
static exk_rig pendulum;
static double *stored_rad[EXK_N_AXES];
static exk_ring ring;
static exk_record slots[SLOTS];
static exk_record record;
static exk_record popped;

static bool open_rig(exk_rig *rig, const char *path)
{
    return exk_rig_open(rig, path) == 0;
}

/* Back to back: the ring is emptied between repeats, outside the part that is a step's own. */
static double run_steps(exk_rig *rig)
{
    const double *const u_rad[EXK_N_AXES] = {stored_rad[0], stored_rad[1]};
    const exk_realisation which = {.seed = 1, .run = 1};
    exk_rig_start(rig, which, u_rad, BENCH_INPUTS);
    for (int64_t k = 0; k < BENCH_INPUTS; k++) {
        exk_loop_step(&rig->loop, k, &record.sample);
        exk_ring_push(&ring, &record);
    }
    ring.tail = ring.head; /* nothing else runs here */
    return record.sample.est.tip_m[0];
}

static double run_machine_steps(void)
{
    return run_steps(&machine);
}

static double run_pendulum_steps(void)
{
    return run_steps(&pendulum);
}

static double run_push(void)
{
    for (int i = 0; i < BENCH_INPUTS; i++) {
        exk_ring_push(&ring, &record);
    }
    ring.tail = ring.head;
    return 0.0;
}

static double run_push_pop(void)
{
    double sum = 0.0;
    for (int i = 0; i < BENCH_INPUTS; i++) {
        exk_ring_push(&ring, &record);
        sum += exk_ring_pop(&ring, &popped) ? 1.0 : 0.0;
    }
    return sum;
}

size_t bench_step_cases(bench_case *cases, size_t capacity)
{
    static double u_rad[EXK_N_AXES][BENCH_INPUTS];
    static const bench_case all[] = {
        {"whole step, machine profile", 500.0, BENCH_INPUTS, run_machine_steps, {0}},
        {"whole step, rectangle profile (P)", 0.0, BENCH_INPUTS, run_pendulum_steps, {0}},
        {"ring push, one record", 0.0, BENCH_INPUTS, run_push, {0}},
        {"ring push and pop", 0.0, BENCH_INPUTS, run_push_pop, {0}},
    };
    const size_t n = sizeof all / sizeof all[0];
    stored_rad[EXK_ALPHA] = u_rad[EXK_ALPHA];
    stored_rad[EXK_BETA] = u_rad[EXK_BETA];
    if (n > capacity || exk_ring_init(&ring, slots, SLOTS, sizeof slots[0]) != EXK_OK ||
        !open_rig(&machine, EXK_SOURCE_DIR "/profiles/machine.ini") ||
        !open_rig(&pendulum, EXK_SOURCE_DIR "/profiles/rectangle.ini")) {
        fprintf(stderr, "exk-bench: the step cannot be set up\n");
        return 0;
    }
    for (size_t i = 0; i < n; i++) {
        cases[i] = all[i];
    }
    return n;
}
