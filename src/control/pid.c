#include "exk/pid.h"

#include <math.h>

exk_pid_config exk_pid_default(void)
{
    return (exk_pid_config){.ki = 2.0, .c_max_rad = 0.1, .dt_s = 1e-3};
}

enum { MAX_DEGREE = 3 };

/* Schur-Cohn: are all roots of a[0] + a[1] z + ... + a[n] z^n inside the unit circle? Each pass
 * needs |a[0]| < |a[n]| and goes on with (a[n] p(z) - a[0] z^n p(1/z)) / z, one degree lower. */
static bool roots_are_inside(const double a[MAX_DEGREE + 1], int n)
{
    double p[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++) {
        p[i] = a[i];
    }
    for (; n > 0; n--) {
        if (!(fabs(p[0]) < fabs(p[n]))) {
            return false;
        }
        const double ratio = p[0] / p[n];
        double next[MAX_DEGREE + 1];
        for (int i = 1; i <= n; i++) {
            next[i - 1] = p[i] - ratio * p[n - i];
        }
        for (int i = 0; i < n; i++) {
            p[i] = next[i];
        }
    }
    return true;
}

/* The characteristic polynomial of the header, kd > 0. */
static bool pid_is_stable(double kp, double g, double h, double b)
{
    if (!(g > 0.0)) { /* less (z - 1): z (z - b) + kp (z - b) + h (z - 1) */
        const double quadratic[MAX_DEGREE + 1] = {-kp * b - h, kp - b + h, 1.0};
        return roots_are_inside(quadratic, 2);
    }
    const double cubic[MAX_DEGREE + 1] = {kp * b + h, b - kp * (1.0 + b) - g * b - 2.0 * h,
                                          kp - 1.0 - b + g + h, 1.0};
    return roots_are_inside(cubic, 3);
}

static bool numbers_are_good(const exk_pid_config *c)
{
    const bool finite = isfinite(c->kp) && isfinite(c->ki) && isfinite(c->kd) &&
                        isfinite(c->d_filter_s) && isfinite(c->c_max_rad) && isfinite(c->dt_s);
    return finite && c->dt_s > 0.0 && c->c_max_rad > 0.0 && c->d_filter_s >= 0.0 &&
           c->kd >= 0.0;
}

exk_err exk_pid_init(exk_pid *pid, const exk_pid_config *cfg)
{
    if (!numbers_are_good(cfg)) {
        return EXK_ERR_ARG;
    }
    const double b = cfg->d_filter_s > 0.0 ? exp(-cfg->dt_s / cfg->d_filter_s) : 0.0;
    const double g = cfg->ki * cfg->dt_s;
    const double h = (1.0 - b) * cfg->kd / cfg->dt_s;
    if (!(cfg->kp >= 0.0 && cfg->kp < 1.0 && g >= 0.0 && g < 2.0 * (1.0 - cfg->kp))) {
        return EXK_ERR_ARG;
    }
    if (cfg->kd > 0.0 && !pid_is_stable(cfg->kp, g, h, b)) {
        return EXK_ERR_ARG;
    }
    *pid = (exk_pid){.cfg = *cfg, .i_gain = g, .d_gain = h, .d_pole = b};
    return EXK_OK;
}

void exk_pid_reset(exk_pid *pid)
{
    pid->integral_rad = 0.0;
    pid->derivative_rad = 0.0;
    pid->last_error_rad = 0.0;
    pid->output_rad = 0.0;
    pid->has_last = false;
}

static double clip(double x, double limit)
{
    const double below = x > limit ? limit : x;
    return below < -limit ? -limit : below;
}

void exk_pid_preset(exk_pid *pid, double output_rad, double error_rad)
{
    const double integral = clip(output_rad, pid->cfg.c_max_rad) - pid->cfg.kp * error_rad;
    if (!(isfinite(output_rad) && isfinite(integral))) {
        return;
    }
    pid->integral_rad = integral;
    pid->derivative_rad = 0.0;
    pid->last_error_rad = error_rad;
    pid->output_rad = clip(output_rad, pid->cfg.c_max_rad);
    pid->has_last = true;
}

void exk_pid_rejoin(exk_pid *pid, double error_rad)
{
    if (isfinite(error_rad)) {
        pid->last_error_rad = error_rad;
    }
}

static double next_derivative(const exk_pid *pid, double error_rad)
{
    const double step = pid->has_last ? error_rad - pid->last_error_rad : 0.0;
    return pid->d_pole * pid->derivative_rad + pid->d_gain * step;
}

double exk_pid_step(exk_pid *pid, double error_rad)
{
    const double d = pid->d_gain > 0.0 ? next_derivative(pid, error_rad) : 0.0;
    const double integral = pid->integral_rad + pid->i_gain * error_rad;
    const double sum = pid->cfg.kp * error_rad + integral + d;
    if (!isfinite(sum)) {
        return pid->output_rad;
    }
    const double out = clip(sum, pid->cfg.c_max_rad);
    const bool pushes_further =
        (sum > out && error_rad > 0.0) || (sum < out && error_rad < 0.0);
    if (!pushes_further) {
        pid->integral_rad = integral;
    }
    pid->derivative_rad = d;
    pid->last_error_rad = error_rad;
    pid->has_last = true;
    pid->output_rad = out;
    return out;
}
