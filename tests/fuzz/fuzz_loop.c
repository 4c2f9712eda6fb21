/* The loop on any answers of its machine, any ticks and any commands: what it sends is finite and within
 * every limit, and what it publishes is finite. */
#include <math.h>

#include "exk/loop.h"
#include "fuzz.h"
#include "numbers.h"

enum { SEGMENTS = 10, N_CAPTURE = 8, N_U = 16 };

static const double angle_max_rad = 0.3;
static const double rate_max_radps = 10.0;
static const exk_hole holes[2] = {{1, {-0.004, 0.0, 0.95}, {0.0, 0.0, 1.0}},
                                  {2, {0.004, 0.002, 0.95}, {0.0, 0.0, 1.0}}};

static exk_segment segments[SEGMENTS];
static exk_sample kept[N_CAPTURE];
static double u_rad[EXK_N_AXES][N_U];
static exk_plan plan;
static exk_kin kin;
static exk_capture capture;
static exk_loop loop;

/* What the machine was told, and what it has to say. */
typedef struct {
    numbers *in;
    double q_rad[EXK_N_AXES];
    int64_t k;
    bool told;
} machine;

static void obeys_limits(machine *m, int64_t k, const exk_drive *drive)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        const double q = drive->angle_rad[i];
        PROMISE(fabs(q) <= angle_max_rad);
        PROMISE(!m->told || fabs(q - m->q_rad[i]) <=
                                1.000001 * rate_max_radps * plan.cfg.dt_s * (double)(k - m->k));
        m->q_rad[i] = q;
    }
    for (int i = 0; i < EXK_N_LEGS; i++) {
        PROMISE(isfinite(drive->legs_m[i]));
    }
    m->k = k;
    m->told = true;
}

static exk_err exchange(void *ctx, int64_t k, const exk_drive *drive, exk_reading *out)
{
    machine *m = ctx;
    const uint8_t how = next_byte(m->in);
    obeys_limits(m, k, drive);
    *out = (exk_reading){.fresh = (how & 1) == 0, .has_true = (how & 2) != 0};
    out->age = (how & 4) != 0 ? (int8_t)next_byte(m->in) : 0;
    for (int i = 0; i < EXK_N_AXES; i++) {
        const double near =
            (how & 8) != 0 ? next_near(m->in, drive->angle_rad[i], 1e-3) : drive->angle_rad[i];
        out->measured_rad[i] = (how & 16) != 0 ? next_bits(m->in) : near;
        out->true_rad[i] = (how & 32) != 0 ? next_bits(m->in) : near;
    }
    return (how & 0xc0) == 0xc0 && (how & 0x3f) == 0x3f ? EXK_ERR_END : EXK_OK;
}

static exk_feedback_config feedback(numbers *in)
{
    exk_feedback_config cfg = exk_feedback_default();
    cfg.kind = EXK_FEEDBACK_PID;
    cfg.pid.dt_s = plan.cfg.dt_s;
    cfg.pid.kp = next_near(in, 0.4, 0.6);
    cfg.pid.ki = next_near(in, 100.0, 120.0);
    return cfg;
}

static bool start(numbers *in, machine *m)
{
    const exk_geometry geo = exk_geometry_default();
    exk_plan_config plan_cfg = exk_plan_default();
    plan_cfg.dwell_s = 0.004;
    plan_cfg.clearance_m = 0.001;
    plan_cfg.stroke_m = 0.001;
    plan_cfg.accel_mps2 = (double)INFINITY;
    PROMISE(exk_kin_init(&kin, EXK_KIN_PENDULUM, EXK_WRIST_AB, &geo) == EXK_OK);
    PROMISE(exk_plan_init(&plan, &plan_cfg, holes, 2, segments, SEGMENTS) == EXK_OK);
    PROMISE(exk_capture_init(&capture, kept, N_CAPTURE) == EXK_OK);
    exk_loop_config cfg = {.kin = &kin,
                           .plan = &plan,
                           .source = {exchange, m},
                           .feedback = feedback(in),
                           .angle_max_rad = angle_max_rad,
                           .n_bad_max = 1 + next_byte(in) % 8,
                           .guard = exk_guard_default(),
                           .limits = exk_limits_default(),
                           .wait_s = 0.002,
                           .capture = &capture};
    cfg.guard.white_rad = 1e-4;
    cfg.guard.n_sigmas = 6.0;
    cfg.limits.angle_max_rad = angle_max_rad;
    cfg.limits.rate_max_radps = rate_max_radps;
    for (int i = 0; i < N_U && (next_byte(in) & 1) != 0; i++) {
        u_rad[0][i] = next_bits(in);
        u_rad[1][i] = next_near(in, 0.0, 1e-3);
        cfg.u_rad[0] = u_rad[0];
        cfg.u_rad[1] = u_rad[1];
        cfg.n_u = N_U;
    }
    return exk_loop_init(&loop, &cfg) == EXK_OK;
}

static void publishes_numbers(const exk_sample *s)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        PROMISE(isfinite(s->r_rad[i]) && isfinite(s->m_rad[i]) && isfinite(s->q_rad[i]));
        PROMISE(isfinite(s->c_rad[i]) && isfinite(s->u_rad[i]) && isfinite(s->theta_rad[i]));
    }
    for (int i = 0; i < 3; i++) {
        PROMISE(isfinite(s->ref.tip_m[i]) && isfinite(s->est.tip_m[i]));
        PROMISE(!s->has_true || isfinite(s->real.tip_m[i]));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    numbers in = {data, size};
    machine m = {.in = &in};
    exk_sample sample;
    if (!start(&in, &m)) {
        return 0;
    }
    int64_t k = -1;
    for (int n = 0; n < 400 && in.left > 0; n++) {
        const uint8_t what = next_byte(&in);
        k += what < 0xe0 ? 1 : what - 0xe0; /* also the same tick again, and ticks skipped */
        if ((what & 0x1f) == 0x1f) {
            exk_loop_request(&loop, (exk_cause)(next_byte(&in) % (EXK_CAUSE_COUNT + 1)), k);
        }
        const exk_err err = exk_loop_step(&loop, k, &sample);
        PROMISE(err == EXK_ERR_ARG || err == loop.fault);
        publishes_numbers(&sample);
        PROMISE((loop.fault != EXK_OK) == (loop.sm.state == EXK_STATE_FAULT));
    }
    return 0;
}
