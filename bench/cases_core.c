#include "bench.h"
#include "exk/disturbance.h"
#include "exk/feedback.h"
#include "exk/ilc.h"
#include "exk/machine.h"
#include "exk/random.h"
#include "exk/tripod.h"

enum { PASS = 4096, SOURCE = 3 };
static exk_tripod tripod;
static exk_kin machine;
static exk_pid pid;
static exk_disturbance walk;
static double position_m[BENCH_INPUTS][3];
static double legs_m[BENCH_INPUTS][EXK_N_LEGS];
static exk_tripod_pose near_pose[BENCH_INPUTS]; /* a servo step from the pose of legs_m */
static exk_tool tool[BENCH_INPUTS];
static exk_joints joints[BENCH_INPUTS];
static double error_rad[BENCH_INPUTS];
static double u_rad[PASS];
static double e_rad[PASS];
static double c_rad[PASS];
static double next_rad[PASS];

static const exk_stream stream = {.seed = 1, .source = SOURCE};

/* Uniform in (-1, 1), from our own draws. */
static double spread(int64_t i)
{
    double z = exk_normal(&stream, i);
    z = z > 2.0 ? 2.0 : z < -2.0 ? -2.0 : z;
    return 0.5 * z;
}

static void make_pose(int i)
{
    const double step_m = 1e-4;
    double shifted_m[3];
    double unused_m[EXK_N_LEGS];
    position_m[i][0] = 0.25 * spread(3 * i);
    position_m[i][1] = 0.18 * spread(3 * i + 1);
    position_m[i][2] = 0.95 + 0.05 * spread(3 * i + 2);
    exk_tripod_lengths(&tripod, position_m[i], legs_m[i]);
    for (int j = 0; j < 3; j++) {
        shifted_m[j] = position_m[i][j] + step_m * spread(5000 + 3 * i + j);
    }
    exk_tripod_inverse(&tripod, shifted_m, &near_pose[i], unused_m);
    tool[i] = (exk_tool){{position_m[i][0], position_m[i][1], 1.45}, {0.0, 0.0, 1.0}};
    exk_kin_inverse(&machine, &tool[i], &joints[i]);
}

static void set_up(void)
{
    const exk_geometry geo = exk_geometry_default();
    exk_pid_config pid_cfg = exk_pid_default();
    exk_disturbance_config walk_cfg = exk_disturbance_default();
    pid_cfg.kp = 0.2;
    pid_cfg.ki = 2.0;
    pid_cfg.dt_s = 0.001;
    walk_cfg.wave = EXK_WAVE_GAUSSIAN;
    walk_cfg.order = 1;
    walk_cfg.channel[EXK_ALPHA] = true;
    walk_cfg.channel[EXK_BETA] = true;
    walk_cfg.amplitude = 1.16e-4;
    exk_tripod_init(&tripod, &geo);
    exk_kin_init(&machine, EXK_KIN_MACHINE, EXK_WRIST_AB, &geo);
    exk_pid_init(&pid, &pid_cfg);
    exk_disturbance_init(&walk, &walk_cfg, 0.001, (exk_realisation){.seed = 1, .run = 1}, 0);
    for (int i = 0; i < BENCH_INPUTS; i++) {
        make_pose(i);
        error_rad[i] = 1e-4 * spread(20000 + i);
    }
    for (int k = 0; k < PASS; k++) {
        e_rad[k] = 1e-4 * spread(30000 + k);
        c_rad[k] = 1e-4 * spread(40000 + k);
    }
}

static double run_lengths(void)
{
    double sum = 0.0;
    double out_m[EXK_N_LEGS] = {0.0};
    for (int i = 0; i < BENCH_INPUTS; i++) {
        exk_tripod_lengths(&tripod, position_m[i], out_m);
        sum += out_m[0] + out_m[1] + out_m[2];
    }
    return sum;
}

static double run_inverse(void)
{
    double sum = 0.0;
    double out_m[EXK_N_LEGS] = {0.0};
    exk_tripod_pose pose = {0.0, 0.0, 0.0};
    for (int i = 0; i < BENCH_INPUTS; i++) {
        exk_tripod_inverse(&tripod, position_m[i], &pose, out_m);
        sum += out_m[0] + pose.alpha_rad + pose.beta_rad;
    }
    return sum;
}

static double run_forward(void)
{
    double sum = 0.0;
    exk_tripod_pose pose = {0.0, 0.0, 0.0};
    for (int i = 0; i < BENCH_INPUTS; i++) {
        exk_tripod_forward(&tripod, legs_m[i], &near_pose[i], &pose, NULL);
        sum += pose.h_m;
    }
    return sum;
}

static double run_jacobian(void)
{
    double sum = 0.0;
    double J[3][3] = {{0.0}};
    for (int i = 0; i < BENCH_INPUTS; i++) {
        exk_tripod_jacobian(&tripod, position_m[i], J);
        sum += J[0][0] + J[1][1] + J[2][2];
    }
    return sum;
}

static double run_machine_inverse(void)
{
    double sum = 0.0;
    exk_joints out = {.h_m = 0.0};
    for (int i = 0; i < BENCH_INPUTS; i++) {
        exk_kin_inverse(&machine, &tool[i], &out);
        sum += out.h_m + out.wrist_rad[0];
    }
    return sum;
}

static double run_machine_forward(void)
{
    double sum = 0.0;
    exk_tool out = {{0.0}, {0.0}};
    for (int i = 0; i < BENCH_INPUTS; i++) {
        exk_kin_forward(&machine, &joints[i], &out);
        sum += out.tip_m[0] + out.axis[2];
    }
    return sum;
}

static double run_pid(void)
{
    double sum = 0.0;
    for (int i = 0; i < BENCH_INPUTS; i++) {
        sum += exk_pid_step(&pid, error_rad[i]);
    }
    return sum;
}

static double run_normal(void)
{
    double sum = 0.0;
    for (int i = 0; i < BENCH_INPUTS; i++) {
        sum += exk_normal(&stream, i);
    }
    return sum;
}

static double run_walk(void)
{
    double n_rad[EXK_N_AXES] = {0.0, 0.0};
    exk_disturbance_reset(&walk);
    for (int i = 0; i < BENCH_INPUTS; i++) {
        exk_disturbance_add(&walk, i, n_rad);
    }
    return n_rad[0] + n_rad[1];
}

static double learn(double cutoff_Hz)
{
    exk_ilc_config cfg = exk_ilc_default();
    cfg.gain = 0.5;
    cfg.dt_s = 0.001;
    cfg.cutoff_Hz = cutoff_Hz;
    return exk_ilc_learn(&cfg, u_rad, e_rad, c_rad, PASS, next_rad) == EXK_OK ? next_rad[7]
                                                                              : 0.0;
}

static double run_learn(void)
{
    return learn(0.0);
}

static double run_learn_filtered(void)
{
    return learn(20.0);
}

size_t bench_core_cases(bench_case *cases, size_t capacity)
{
    static const bench_case all[] = {
        {"tripod lengths from position", 35.0, BENCH_INPUTS, run_lengths, {0}},
        {"tripod inverse with both angles", 70.0, BENCH_INPUTS, run_inverse, {0}},
        {"tripod forward from the last pose", 300.0, BENCH_INPUTS, run_forward, {0}},
        {"tripod Jacobian", 0.0, BENCH_INPUTS, run_jacobian, {0}},
        {"machine inverse (tripod + wrist)", 0.0, BENCH_INPUTS, run_machine_inverse, {0}},
        {"machine forward from angles", 0.0, BENCH_INPUTS, run_machine_forward, {0}},
        {"PI step, one angle", 6.0, BENCH_INPUTS, run_pid, {0}},
        {"ILC learn, P-type, a sample", 0.7, PASS, run_learn, {0}},
        {"ILC learn, zero-phase Q, a sample", 0.0, PASS, run_learn_filtered, {0}},
        {"normal draw", 0.0, BENCH_INPUTS, run_normal, {0}},
        {"first-order disturbance, both angles", 0.0, BENCH_INPUTS, run_walk, {0}},
    };
    const size_t n = sizeof all / sizeof all[0];
    set_up();
    for (size_t i = 0; i < n && i < capacity; i++) {
        cases[i] = all[i];
    }
    return n < capacity ? n : capacity;
}
