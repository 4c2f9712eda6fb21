#include "exk/twin.h"

#include <math.h>

exk_twin_config exk_twin_default(void)
{
    return (exk_twin_config){.dt_s = 1e-3};
}

static bool is_size(double x)
{
    return x >= 0.0 && isfinite(x);
}

static exk_err check(const exk_twin_config *cfg)
{
    if (cfg->n_disturbances > EXK_MAX_DISTURBANCES) {
        return EXK_ERR_SIZE;
    }
    if (!(cfg->dt_s > 0.0 && isfinite(cfg->dt_s)) || !is_size(cfg->servo_tau_s) ||
        !is_size(cfg->sensor_sigma_rad) || !is_size(cfg->sensor_quantum_rad)) {
        return EXK_ERR_ARG;
    }
    return EXK_OK;
}

exk_err exk_twin_init(exk_twin *twin, const exk_twin_config *cfg, exk_realisation which)
{
    exk_err err = check(cfg);
    for (size_t i = 0; err == EXK_OK && i < cfg->n_disturbances; i++) {
        err = exk_disturbance_init(&twin->disturbance[i], &cfg->disturbance[i], cfg->dt_s,
                                   which, (uint8_t)i);
    }
    if (err != EXK_OK) {
        return err;
    }
    twin->cfg = *cfg;
    twin->n_lent = 0;
    for (int i = 0; i < EXK_N_AXES; i++) {
        twin->sensor[i] = (exk_stream){.seed = which.seed,
                                       .series = which.series,
                                       .run = cfg->sensor_frozen ? 0 : which.run,
                                       .source = EXK_SOURCE_SENSOR,
                                       .channel = (uint8_t)i};
    }
    twin->pole = cfg->servo_tau_s > 0.0 ? exp(-cfg->dt_s / cfg->servo_tau_s) : 0.0;
    exk_twin_reset(twin);
    return EXK_OK;
}

void exk_twin_reset(exk_twin *twin)
{
    twin->k = -1;
    twin->has_command = false;
    for (int i = 0; i < EXK_N_AXES; i++) {
        twin->command_rad[i] = 0.0;
        twin->servo_rad[i] = 0.0;
    }
    for (size_t i = 0; i < twin->cfg.n_disturbances; i++) {
        exk_disturbance_reset(&twin->disturbance[i]);
    }
}

bool exk_twin_draw(const exk_twin *twin, size_t n, double *const n_rad[EXK_N_AXES])
{
    if (twin->cfg.n_disturbances != 1) {
        return false;
    }
    exk_disturbance d = twin->disturbance[0];
    exk_disturbance_reset(&d);
    for (size_t k = 0; k < n; k++) {
        double sum_rad[EXK_N_AXES] = {0.0};
        exk_disturbance_add(&d, (int64_t)k, sum_rad);
        n_rad[EXK_ALPHA][k] = sum_rad[EXK_ALPHA];
        n_rad[EXK_BETA][k] = sum_rad[EXK_BETA];
    }
    return true;
}

void exk_twin_lend(exk_twin *twin, size_t n, double *const n_rad[EXK_N_AXES])
{
    twin->lent_rad[EXK_ALPHA] = n_rad[EXK_ALPHA];
    twin->lent_rad[EXK_BETA] = n_rad[EXK_BETA];
    twin->n_lent = n;
}

/* x moves n ticks towards the command, decay = a^n: x = decay x + (1 - decay) q. */
static void servo_run(exk_twin *twin, double decay)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        twin->servo_rad[i] = decay * twin->servo_rad[i] + (1.0 - decay) * twin->command_rad[i];
    }
}

/* A bad command becomes the place where the servo is. */
static void take_command(exk_twin *twin, const double q_rad[EXK_N_AXES])
{
    const bool good = isfinite(q_rad[EXK_ALPHA]) && isfinite(q_rad[EXK_BETA]);
    for (int i = 0; i < EXK_N_AXES; i++) {
        twin->command_rad[i] = good ? q_rad[i] : twin->servo_rad[i];
        if (good && !twin->has_command) {
            twin->servo_rad[i] = q_rad[i]; /* x[-1] = q[0] */
        }
    }
    twin->has_command = twin->has_command || good;
}

static void servo_step(exk_twin *twin, int64_t k, const double q_rad[EXK_N_AXES])
{
    if (k <= twin->k) {
        return;
    }
    const int64_t n_skipped = k - twin->k - 1;
    if (n_skipped > 0) {
        servo_run(twin, pow(twin->pole, (double)n_skipped));
    }
    take_command(twin, q_rad);
    servo_run(twin, twin->pole);
    twin->k = k;
}

static double measure(const exk_twin *twin, int i, int64_t k, double theta_rad)
{
    const exk_twin_config *cfg = &twin->cfg;
    double m = theta_rad;
    if (cfg->sensor_sigma_rad > 0.0) {
        m += cfg->sensor_sigma_rad * exk_normal(&twin->sensor[i], k);
    }
    if (cfg->sensor_quantum_rad > 0.0) {
        m = round(m / cfg->sensor_quantum_rad) * cfg->sensor_quantum_rad;
    }
    return m;
}

static void disturb(exk_twin *twin, int64_t k, double theta_rad[EXK_N_AXES])
{
    if (k >= 0 && (uint64_t)k < twin->n_lent) {
        theta_rad[EXK_ALPHA] += twin->lent_rad[EXK_ALPHA][k];
        theta_rad[EXK_BETA] += twin->lent_rad[EXK_BETA][k];
        return;
    }
    for (size_t i = 0; i < twin->cfg.n_disturbances; i++) {
        exk_disturbance_add(&twin->disturbance[i], k, theta_rad);
    }
}

void exk_twin_step(exk_twin *twin, int64_t k, const double q_rad[EXK_N_AXES], exk_reading *out)
{
    servo_step(twin, k, q_rad);
    double theta[EXK_N_AXES] = {twin->servo_rad[EXK_ALPHA], twin->servo_rad[EXK_BETA]};
    disturb(twin, k, theta);
    for (int i = 0; i < EXK_N_AXES; i++) {
        out->true_rad[i] = theta[i];
        out->measured_rad[i] = measure(twin, i, k, theta[i]);
    }
    out->has_true = true;
    out->fresh = true;
    out->age = 0;
}

static exk_err exchange(void *ctx, int64_t k, const exk_drive *drive, exk_reading *out)
{
    exk_twin_step(ctx, k, drive->angle_rad, out);
    return EXK_OK;
}

exk_source exk_twin_source(exk_twin *twin)
{
    return (exk_source){.exchange = exchange, .ctx = twin};
}
