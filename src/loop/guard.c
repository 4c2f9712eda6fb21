#include "exk/guard.h"

#include <math.h>

#include "guard_spike.h"

static const double gain_min = 0.1;
static const double moved_quanta = 10.0;
static const double moved_min_rad = 1e-6; /* movement that any sensor without a quantum shows */
static const double log_false_stuck = -20.7; /* log 1e-9 */
static const double repeat_scale = 3.5449;   /* 2 sqrt(pi) */
enum { STUCK_MIN = 3 };

static const char *const names[EXK_SAMPLE_COUNT] = {
    [EXK_SAMPLE_GOOD] = "good",           [EXK_SAMPLE_MISSING] = "missing",
    [EXK_SAMPLE_LATE] = "late",           [EXK_SAMPLE_REPEATED] = "repeated",
    [EXK_SAMPLE_REORDERED] = "reordered", [EXK_SAMPLE_NAN] = "NaN",
    [EXK_SAMPLE_INFINITE] = "infinite",   [EXK_SAMPLE_RANGE] = "out of range",
    [EXK_SAMPLE_STUCK] = "stuck",         [EXK_SAMPLE_SPIKE] = "spike",
};

const char *exk_sample_kind_name(exk_sample_kind kind)
{
    return (unsigned)kind < EXK_SAMPLE_COUNT ? names[kind] : "unknown";
}

exk_guard_config exk_guard_default(void)
{
    const double no_limit = (double)INFINITY;
    return (exk_guard_config){.dt_s = 1e-3,
                              .angle_max_rad = 0.6,
                              .start_rad = no_limit,
                              .n_sigmas = no_limit,
                              .stuck_s = 0.015};
}

static bool is_size(double x)
{
    return x >= 0.0 && isfinite(x);
}

static bool is_positive(double x)
{
    return x > 0.0 && isfinite(x);
}

static exk_err check(const exk_guard_config *c)
{
    const bool good = is_positive(c->dt_s) && is_positive(c->angle_max_rad) &&
                      is_size(c->servo_tau_s) && is_size(c->white_rad) &&
                      is_size(c->walk_rad) && is_size(c->drift_rad) && is_size(c->noise_rad) &&
                      is_size(c->quantum_rad) && is_size(c->stuck_s) && c->start_rad >= 0.0 &&
                      c->n_sigmas > 0.0;
    return good ? EXK_OK : EXK_ERR_ARG;
}

/* Repeats that clean samples show at rest once in 1e9; 0 where a repeat proves nothing. */
static int64_t repeats_at_rest(const exk_guard_config *c)
{
    if (!(c->noise_rad > 0.0 && c->noise_rad >= c->quantum_rad)) {
        return 0;
    }
    const double p = c->quantum_rad / (repeat_scale * c->noise_rad);
    return p > 0.0 ? (int64_t)ceil(log_false_stuck / log(p)) : STUCK_MIN;
}

static void set_stuck(exk_guard *g)
{
    const double n = ceil(g->cfg.stuck_s / g->cfg.dt_s);
    const int64_t most = INT32_MAX;
    const int64_t wanted = n < (double)most ? (int64_t)n : most;
    const int64_t at_rest = repeats_at_rest(&g->cfg);
    g->n_stuck = wanted > STUCK_MIN ? wanted : STUCK_MIN;
    g->n_stuck_rest = at_rest == 0 || at_rest > g->n_stuck ? at_rest : g->n_stuck;
}

exk_err exk_guard_init(exk_guard *g, const exk_guard_config *cfg)
{
    if (check(cfg) != EXK_OK) {
        return EXK_ERR_ARG;
    }
    const double R = cfg->white_rad * cfg->white_rad;
    const double Q = cfg->walk_rad * cfg->walk_rad;
    const double P = 0.5 * (Q + sqrt(Q * Q + 4.0 * Q * R));
    const double gain = P + R > 0.0 ? P / (P + R) : 1.0;
    *g = (exk_guard){.cfg = *cfg};
    g->gain = fmax(gain, gain_min);
    g->variance = gain < gain_min ? P + R / (1.0 - 0.5 * gain_min) : P + R;
    g->fixed_rad = cfg->drift_rad / g->gain;
    exk_guard_set_limits(g);
    g->pole = cfg->servo_tau_s > 0.0 ? exp(-cfg->dt_s / cfg->servo_tau_s) : 0.0;
    set_stuck(g);
    exk_guard_reset(g);
    return EXK_OK;
}

void exk_guard_forget(exk_guard *g)
{
    g->k = -1;
    g->newest = -1;
    g->starts = false;
    for (int i = 0; i < EXK_N_AXES; i++) {
        g->axis[i] = (exk_guard_axis){.raw_rad = (double)NAN};
        g->command_rad[i] = 0.0;
        g->asked_rad[i] = 0.0;
    }
}

void exk_guard_reset(exk_guard *g)
{
    exk_guard_forget(g);
    g->starts = true;
}

static double approach(double x, double decay, double to)
{
    return decay * x + (1.0 - decay) * to;
}

/* Over the ticks skipped with the old value, then one tick with the new one, as the twin does. */
static double follow(const exk_guard *g, double x, double skipped, double old, double new)
{
    return approach(skipped < 1.0 ? approach(x, skipped, old) : x, g->pole, new);
}

static void expect(exk_guard *g, int64_t k, const double r_rad[EXK_N_AXES],
                   const double q_rad[EXK_N_AXES])
{
    if (k <= g->k) {
        return;
    }
    const bool first = g->k < 0;
    const int64_t n_skipped = first ? 0 : k - g->k - 1;
    const double skipped = n_skipped > 0 ? pow(g->pole, (double)n_skipped) : 1.0;
    for (int i = 0; i < EXK_N_AXES; i++) {
        exk_guard_axis *axis = &g->axis[i];
        const double x = first ? q_rad[i] : axis->expected_rad;
        const double reference = first ? r_rad[i] : axis->reference_rad;
        axis->expected_rad = follow(g, x, skipped, g->command_rad[i], q_rad[i]);
        axis->reference_rad = follow(g, reference, skipped, g->asked_rad[i], r_rad[i]);
        g->command_rad[i] = q_rad[i];
        g->asked_rad[i] = r_rad[i];
    }
    g->k = k;
}

static exk_sample_kind judge_arrival(exk_guard *g, int64_t k, const exk_reading *m)
{
    if (!m->fresh) {
        return EXK_SAMPLE_MISSING;
    }
    if (m->age == 0) {
        g->newest = k;
        return EXK_SAMPLE_GOOD;
    }
    if (m->age < 0 || m->age > k) {
        return EXK_SAMPLE_REORDERED;
    }
    const int64_t tick = k - m->age;
    const int64_t newest = g->newest;
    g->newest = tick > newest ? tick : newest;
    return tick > newest    ? EXK_SAMPLE_LATE
           : tick == newest ? EXK_SAMPLE_REPEATED
                            : EXK_SAMPLE_REORDERED;
}

static exk_sample_kind judge_number(const exk_guard *g, double m_rad)
{
    if (fabs(m_rad) <= g->cfg.angle_max_rad) {
        return EXK_SAMPLE_GOOD;
    }
    return isnan(m_rad)   ? EXK_SAMPLE_NAN
           : isinf(m_rad) ? EXK_SAMPLE_INFINITE
                          : EXK_SAMPLE_RANGE;
}

static bool is_stuck(const exk_guard *g, exk_guard_axis *axis, double m_rad)
{
    if (m_rad != axis->raw_rad) {
        axis->raw_rad = m_rad;
        axis->moved_from = axis->reference_rad;
        axis->expected_from = axis->expected_rad;
        axis->n_same = 0;
        return false;
    }
    axis->n_same++;
    if (axis->n_same < g->n_stuck || !(g->cfg.stuck_s > 0.0)) {
        return false;
    }
    const double moved_rad = fmin(fabs(axis->reference_rad - axis->moved_from),
                                  fabs(axis->expected_rad - axis->expected_from));
    const double least_rad = fmax(moved_quanta * g->cfg.quantum_rad, moved_min_rad) +
                             (double)axis->n_same * g->cfg.drift_rad;
    return moved_rad > least_rad || (g->n_stuck_rest > 0 && axis->n_same >= g->n_stuck_rest);
}

exk_sample_kind exk_guard_reject(exk_guard *g, int axis, exk_sample_kind kind, double value,
                                 double limit)
{
    g->bad_axis = axis;
    g->bad_value = value;
    g->bad_limit = limit;
    return kind;
}

static exk_sample_kind judge_numbers(exk_guard *g, const double m_rad[EXK_N_AXES])
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        const exk_sample_kind kind = judge_number(g, m_rad[i]);
        if (kind != EXK_SAMPLE_GOOD) {
            return exk_guard_reject(g, i, kind, m_rad[i], g->cfg.angle_max_rad);
        }
    }
    return EXK_SAMPLE_GOOD;
}

/* Both angles are looked at, so that each keeps its count of repeats. */
static exk_sample_kind judge_stuck(exk_guard *g, const double m_rad[EXK_N_AXES])
{
    exk_sample_kind kind = EXK_SAMPLE_GOOD;
    for (int i = 0; i < EXK_N_AXES; i++) {
        if (is_stuck(g, &g->axis[i], m_rad[i])) {
            kind =
                exk_guard_reject(g, i, EXK_SAMPLE_STUCK, m_rad[i], (double)g->axis[i].n_same);
        }
    }
    return kind;
}

exk_sample_kind exk_guard_check(exk_guard *g, int64_t k, const double r_rad[EXK_N_AXES],
                                const double q_rad[EXK_N_AXES], const exk_reading *m)
{
    expect(g, k, r_rad, q_rad);
    exk_sample_kind kind = judge_arrival(g, k, m);
    if (kind != EXK_SAMPLE_GOOD) {
        exk_guard_reject(g, -1, kind, (double)m->age, 0.0);
    } else {
        kind = judge_numbers(g, m->measured_rad);
    }
    if (kind == EXK_SAMPLE_GOOD) {
        kind = judge_stuck(g, m->measured_rad);
    }
    if (kind == EXK_SAMPLE_GOOD) {
        kind = exk_guard_judge_spike(g, k, m->measured_rad);
    }
    if (kind == EXK_SAMPLE_GOOD) {
        exk_guard_learn(g, k, m->measured_rad);
    }
    g->n[kind]++;
    return kind;
}
