#include "exk/limits.h"

#include <math.h>

exk_limits_config exk_limits_default(void)
{
    const double no_limit = (double)INFINITY;
    return (exk_limits_config){
        .dt_s = 1e-3,
        .angle_max_rad = no_limit,
        .correction_max_rad = no_limit,
        .rate_max_radps = no_limit,
        .leg_min_m = 0.0,
        .leg_max_m = no_limit,
        .leg_speed_max_mps = no_limit,
        .box_min_m = {-no_limit, -no_limit, -no_limit},
        .box_max_m = {no_limit, no_limit, no_limit},
        .following_rad = no_limit,
    };
}

static bool is_bound(double x)
{
    return x >= 0.0;
}

static exk_err check(const exk_limits_config *c)
{
    bool good = c->dt_s > 0.0 && isfinite(c->dt_s) && is_bound(c->angle_max_rad) &&
                is_bound(c->correction_max_rad) && is_bound(c->rate_max_radps) &&
                is_bound(c->leg_min_m) && c->leg_min_m <= c->leg_max_m &&
                is_bound(c->leg_speed_max_mps) && is_bound(c->following_rad) &&
                is_bound(c->following_time_s) && isfinite(c->following_time_s);
    for (int i = 0; i < 3; i++) {
        good = good && c->box_min_m[i] <= c->box_max_m[i];
    }
    return good ? EXK_OK : EXK_ERR_ARG;
}

bool exk_limits_ask_legs(const exk_limits *limits)
{
    const exk_limits_config *c = &limits->cfg;
    return c->leg_min_m > 0.0 || isfinite(c->leg_max_m) || isfinite(c->leg_speed_max_mps);
}

exk_err exk_limits_init(exk_limits *limits, const exk_limits_config *cfg)
{
    if (check(cfg) != EXK_OK) {
        return EXK_ERR_ARG;
    }
    *limits = (exk_limits){.cfg = *cfg};
    return EXK_OK;
}

void exk_limits_reset(exk_limits *limits)
{
    limits->has_last = false;
}

static bool report(exk_violation *out, exk_quantity quantity, int index, double value,
                   double limit)
{
    *out = (exk_violation){quantity, index, value, limit};
    return false;
}

static bool angles_pass(const exk_limits *l, const exk_limits_step *s, const double rate[],
                        exk_violation *out)
{
    const exk_limits_config *c = &l->cfg;
    for (int i = 0; i < EXK_N_AXES; i++) {
        const double q = s->q_rad[i];
        const double off = q - s->r_rad[i];
        if (!(fabs(q) <= c->angle_max_rad) || !isfinite(q)) {
            return report(out, EXK_QUANTITY_ANGLE, i, q, c->angle_max_rad);
        }
        if (!(fabs(off) <= c->correction_max_rad)) {
            return report(out, EXK_QUANTITY_CORRECTION, i, off, c->correction_max_rad);
        }
        if (!(fabs(rate[i]) <= c->rate_max_radps)) {
            return report(out, EXK_QUANTITY_RATE, i, rate[i], c->rate_max_radps);
        }
    }
    return true;
}

static bool legs_pass(const exk_limits *l, const exk_limits_step *s, double per_s,
                      exk_violation *out)
{
    const exk_limits_config *c = &l->cfg;
    for (int i = 0; i < EXK_N_LEGS; i++) {
        const double leg = s->legs_m[i];
        const double speed = l->has_last ? (leg - l->legs_m[i]) * per_s : 0.0;
        if (!(leg <= c->leg_max_m) || !isfinite(leg)) {
            return report(out, EXK_QUANTITY_LEG, i, leg, c->leg_max_m);
        }
        if (!(leg >= c->leg_min_m)) {
            return report(out, EXK_QUANTITY_LEG, i, leg, c->leg_min_m);
        }
        if (!(fabs(speed) <= c->leg_speed_max_mps)) {
            return report(out, EXK_QUANTITY_LEG_SPEED, i, speed, c->leg_speed_max_mps);
        }
    }
    return true;
}

static bool tip_passes(const exk_limits *l, const double tip_m[3], exk_violation *out)
{
    const exk_limits_config *c = &l->cfg;
    for (int i = 0; i < 3; i++) {
        if (!(tip_m[i] <= c->box_max_m[i]) || !isfinite(tip_m[i])) {
            return report(out, EXK_QUANTITY_WORKSPACE, i, tip_m[i], c->box_max_m[i]);
        }
        if (!(tip_m[i] >= c->box_min_m[i])) {
            return report(out, EXK_QUANTITY_WORKSPACE, i, tip_m[i], c->box_min_m[i]);
        }
    }
    return true;
}

static void remember(exk_limits *l, int64_t k, const exk_limits_step *s, const double rate[])
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        l->q_rad[i] = s->q_rad[i];
        l->rate_radps[i] = rate[i];
    }
    for (int i = 0; i < EXK_N_LEGS; i++) {
        l->legs_m[i] = s->legs_m[i];
    }
    l->k = k;
    l->has_last = true;
}

bool exk_limits_command(exk_limits *l, int64_t k, const exk_limits_step *s, exk_violation *out)
{
    const int64_t n = l->has_last && k > l->k ? k - l->k : 1;
    const double per_s = 1.0 / ((double)n * l->cfg.dt_s);
    double rate[EXK_N_AXES];
    for (int i = 0; i < EXK_N_AXES; i++) {
        rate[i] = l->has_last ? (s->q_rad[i] - l->q_rad[i]) * per_s : 0.0;
    }
    if (!angles_pass(l, s, rate, out) || !legs_pass(l, s, per_s, out) ||
        !tip_passes(l, s->tip_m, out)) {
        return false;
    }
    remember(l, k, s, rate);
    return true;
}

void exk_limits_stand(exk_limits *l, int64_t k)
{
    l->k = k;
    for (int i = 0; i < EXK_N_AXES; i++) {
        l->rate_radps[i] = 0.0;
    }
}

bool exk_limits_following(const exk_limits *l, const double m_rad[EXK_N_AXES],
                          exk_violation *out)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        const double off = l->q_rad[i] - m_rad[i];
        const double limit =
            l->cfg.following_rad + l->cfg.following_time_s * fabs(l->rate_radps[i]);
        if (!(fabs(off) <= limit)) {
            return report(out, EXK_QUANTITY_FOLLOWING, i, off, limit);
        }
    }
    return true;
}
