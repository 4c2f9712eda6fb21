#include "guard_spike.h"

#include <math.h>

static const double young_variance = 2.0; /* 1 + 1/i of the mean of i samples, at most */
static const double rounding_rad = 1e-9;

/* e1 - K e2 = (1 + K^2) A for a spike of A in the first of two samples; each of e1 and e2 may be off by
 * what is not noise. */
void exk_guard_set_limits(exk_guard *g)
{
    const double sigma_rad = sqrt(g->variance);
    const double fixed_rad = g->fixed_rad + g->cfg.quantum_rad + rounding_rad;
    const double square = 1.0 + g->gain * g->gain;
    g->limit_rad = g->cfg.n_sigmas * sigma_rad + fixed_rad;
    g->back_limit_rad =
        g->cfg.n_sigmas * sigma_rad / sqrt(square) + (1.0 + g->gain) / square * fixed_rad;
}

static bool is_young(const exk_guard *g, int64_t n_news)
{
    return (double)n_news * g->gain < 1.0;
}

/* Limit of a spike at tick k: n ticks after the last sample that told something. */
static double spike_limit(const exk_guard *g, const exk_guard_axis *axis, int64_t k)
{
    const bool young = is_young(g, axis->n_news);
    const int64_t n = k - axis->k_news;
    if (n <= 1 && !young) {
        return g->limit_rad;
    }
    const double Q = g->cfg.walk_rad * g->cfg.walk_rad;
    const double steps = n > 1 ? (double)n : 1.0;
    const double variance = (young ? young_variance : 1.0) * g->variance + (steps - 1.0) * Q;
    return g->cfg.n_sigmas * sqrt(variance) + steps * g->fixed_rad + g->cfg.quantum_rad +
           rounding_rad;
}

static double start_limit(const exk_guard *g)
{
    const double Q = g->cfg.walk_rad * g->cfg.walk_rad;
    const double R = g->cfg.white_rad * g->cfg.white_rad;
    const double ticks = (double)g->k + 1.0; /* a walk may have begun at tick 0 */
    return g->cfg.n_sigmas * sqrt(young_variance * R + ticks * Q) + g->cfg.start_rad +
           ticks * g->cfg.drift_rad + g->cfg.quantum_rad + rounding_rad;
}

/* Both samples are of a guard that had grown up, one tick after the other. */
static bool has_pair(const exk_guard *g, const exk_guard_axis *axis, int64_t k)
{
    return k - axis->k_news == 1 && !is_young(g, axis->n_news - 1);
}

/* What the sample before was too much by, now that the one after it is there. */
static double look_back(const exk_guard *g, const exk_guard_axis *axis, double off_rad)
{
    return (axis->last_rad - g->gain * off_rad) / (1.0 + g->gain * g->gain);
}

/* As if the sample before had never come. */
static void unlearn(exk_guard_axis *axis)
{
    axis->offset_rad = axis->before_rad;
    axis->n_news--;
    axis->k_news--;
}

static exk_sample_kind judge_axis(exk_guard *g, int i, int64_t k, double m_rad)
{
    exk_guard_axis *axis = &g->axis[i];
    const double off_rad = m_rad - axis->expected_rad - axis->offset_rad;
    const double limit_rad = axis->n_news > 0 ? spike_limit(g, axis, k) : start_limit(g);
    if (!(fabs(off_rad) <= limit_rad)) {
        return exk_guard_reject(g, i, EXK_SAMPLE_SPIKE, off_rad, limit_rad);
    }
    if (!has_pair(g, axis, k)) {
        return EXK_SAMPLE_GOOD;
    }
    const double before_rad = look_back(g, axis, off_rad);
    if (!(fabs(before_rad) <= g->back_limit_rad)) {
        unlearn(axis);
        return exk_guard_reject(g, i, EXK_SAMPLE_SPIKE, before_rad, g->back_limit_rad);
    }
    return EXK_SAMPLE_GOOD;
}

exk_sample_kind exk_guard_judge_spike(exk_guard *g, int64_t k, const double m_rad[EXK_N_AXES])
{
    exk_sample_kind kind = EXK_SAMPLE_GOOD;
    if (!isfinite(g->cfg.n_sigmas)) {
        return EXK_SAMPLE_GOOD;
    }
    for (int i = 0; i < EXK_N_AXES && kind == EXK_SAMPLE_GOOD; i++) {
        if (g->axis[i].n_news > 0 || g->starts) {
            kind = judge_axis(g, i, k, m_rad[i]);
        }
    }
    return kind;
}

/* d^ begins anew after a gap: what happened meanwhile is not known. */
static void learn_axis(const exk_guard *g, exk_guard_axis *axis, int64_t k, double m_rad)
{
    const bool whole = axis->n_news > 0 && k - axis->k_news <= 1;
    const double mean = whole ? 1.0 / ((double)axis->n_news + 1.0) : 1.0;
    const double gain = mean > g->gain ? mean : g->gain;
    if (axis->n_same > 1) {
        return;
    }
    axis->last_rad = m_rad - axis->expected_rad - axis->offset_rad;
    axis->before_rad = axis->offset_rad;
    axis->offset_rad += gain * axis->last_rad;
    axis->n_news = whole ? axis->n_news + 1 : 1;
    axis->k_news = k;
}

void exk_guard_learn(exk_guard *g, int64_t k, const double m_rad[EXK_N_AXES])
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        learn_axis(g, &g->axis[i], k, m_rad[i]);
    }
    g->starts = false;
}
