#include "exk/inject.h"

#include <math.h>
#include <string.h>

static const double beyond_rad = 10.0;
static const double any_rad = 0.5;
static const double ticks_max = 9e15; /* whole numbers of a double */
static const double word_max = 4294967295.0;
enum { SLOTS = EXK_INJECT_DELAY_MAX + 1 };

static const char *const names[EXK_INJECT_COUNT] = {
    [EXK_INJECT_NONE] = "none",       [EXK_INJECT_NAN] = "nan",
    [EXK_INJECT_INF] = "inf",         [EXK_INJECT_RANGE] = "range",
    [EXK_INJECT_SPIKE] = "spike",     [EXK_INJECT_STUCK] = "stuck",
    [EXK_INJECT_DROPOUT] = "dropout", [EXK_INJECT_DELAY] = "delay",
    [EXK_INJECT_GARBAGE] = "garbage",
};

const char *exk_inject_name(exk_inject_kind kind)
{
    return (unsigned)kind < EXK_INJECT_COUNT ? names[kind] : "unknown";
}

exk_inject_fault exk_inject_default(void)
{
    return (exk_inject_fault){
        .kind = EXK_INJECT_NONE, .channel = {true, true}, .size_rad = 5e-3, .delay_s = 0.01};
}

static bool fits(double time_s, double dt_s)
{
    return time_s >= 0.0 && time_s / dt_s <= ticks_max;
}

static exk_err check(const exk_inject_config *cfg, double dt_s)
{
    if (cfg->n_faults > EXK_MAX_INJECTED) {
        return EXK_ERR_SIZE;
    }
    bool good = dt_s > 0.0 && isfinite(dt_s);
    for (size_t i = 0; good && i < cfg->n_faults; i++) {
        const exk_inject_fault *f = &cfg->fault[i];
        good = (unsigned)f->kind < EXK_INJECT_COUNT && fits(f->at_s, dt_s) &&
               fits(f->for_s, dt_s) && isfinite(f->size_rad) && f->delay_s >= 0.0 &&
               f->delay_s / dt_s <= (double)EXK_INJECT_DELAY_MAX;
    }
    return good ? EXK_OK : EXK_ERR_ARG;
}

exk_err exk_inject_init(exk_inject *inject, const exk_inject_config *cfg, double dt_s,
                        exk_realisation which)
{
    const exk_err err = check(cfg, dt_s);
    if (err != EXK_OK) {
        return err;
    }
    *inject = (exk_inject){.cfg = *cfg};
    inject->stream = (exk_stream){.seed = which.seed, .series = which.series, .run = which.run};
    for (size_t i = 0; i < cfg->n_faults; i++) {
        const exk_inject_fault *f = &cfg->fault[i];
        const int64_t n = llround(f->for_s / dt_s);
        inject->begin[i] = llround(f->at_s / dt_s);
        inject->end[i] = inject->begin[i] + (n > 1 ? n : 1);
        inject->delay[i] = llround(f->delay_s / dt_s);
    }
    for (int i = 0; i < SLOTS; i++) {
        inject->past_k[i] = -1;
    }
    return EXK_OK;
}

static double bits_as_number(const uint32_t word[4])
{
    const uint64_t bits = (uint64_t)word[1] << 32 | word[0];
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static double garbage(const exk_inject *inject, size_t i, int axis, int64_t k)
{
    uint32_t word[4];
    exk_stream stream = inject->stream;
    stream.source = (uint8_t)(EXK_SOURCE_INJECT + i);
    stream.channel = (uint8_t)axis;
    exk_random_block(&stream, k, word);
    return k % 2 == 0 ? bits_as_number(word)
                      : any_rad * (2.0 * (double)word[2] / word_max - 1.0);
}

static double spoilt(exk_inject *inject, size_t i, int axis, int64_t k, double m_rad)
{
    const exk_inject_fault *f = &inject->cfg.fault[i];
    switch (f->kind) {
    case EXK_INJECT_NAN:
        return (double)NAN;
    case EXK_INJECT_INF:
        return k % 2 == 0 ? (double)INFINITY : -(double)INFINITY;
    case EXK_INJECT_RANGE:
        return m_rad + beyond_rad;
    case EXK_INJECT_SPIKE:
        return m_rad + f->size_rad;
    case EXK_INJECT_STUCK:
        return inject->held_rad[i][axis];
    case EXK_INJECT_GARBAGE:
        return garbage(inject, i, axis, k);
    case EXK_INJECT_NONE:
    case EXK_INJECT_DROPOUT:
    case EXK_INJECT_DELAY:
    case EXK_INJECT_COUNT:
        break;
    }
    return m_rad;
}

static void delay(const exk_inject *inject, size_t i, int64_t k, exk_reading *reading)
{
    const int64_t then = k - inject->delay[i];
    const int slot = (int)(then >= 0 ? then % SLOTS : 0);
    if (then < 0 || inject->past_k[slot] != then) {
        reading->fresh = false;
        return;
    }
    for (int axis = 0; axis < EXK_N_AXES; axis++) {
        reading->measured_rad[axis] = inject->past[slot].measured_rad[axis];
    }
    reading->age = inject->delay[i];
}

static void act(exk_inject *inject, size_t i, int64_t k, exk_reading *reading)
{
    const exk_inject_fault *f = &inject->cfg.fault[i];
    if (f->kind == EXK_INJECT_DROPOUT) {
        reading->fresh = false;
        return;
    }
    if (f->kind == EXK_INJECT_DELAY) {
        delay(inject, i, k, reading);
        return;
    }
    for (int axis = 0; axis < EXK_N_AXES; axis++) {
        double *m_rad = &reading->measured_rad[axis];
        if (!inject->holds[i]) {
            inject->held_rad[i][axis] = k > 0 ? inject->before_rad[axis] : *m_rad;
        }
        *m_rad = f->channel[axis] ? spoilt(inject, i, axis, k, *m_rad) : *m_rad;
    }
    inject->holds[i] = true;
}

void exk_inject_apply(exk_inject *inject, int64_t k, exk_reading *reading)
{
    const exk_reading whole = *reading;
    const int slot = (int)(k >= 0 ? k % SLOTS : 0);
    inject->past[slot] = whole;
    inject->past_k[slot] = k;
    for (size_t i = 0; i < inject->cfg.n_faults; i++) {
        if (k >= inject->begin[i] && k < inject->end[i]) {
            act(inject, i, k, reading);
        }
    }
    for (int axis = 0; axis < EXK_N_AXES; axis++) {
        inject->before_rad[axis] = whole.measured_rad[axis];
    }
}

static exk_err exchange(void *ctx, int64_t k, const exk_drive *drive, exk_reading *out)
{
    exk_inject *inject = ctx;
    const exk_err err = inject->inner.exchange(inject->inner.ctx, k, drive, out);
    if (err == EXK_OK) {
        exk_inject_apply(inject, k, out);
    }
    return err;
}

exk_source exk_inject_source(exk_inject *inject, exk_source inner)
{
    if (inject->cfg.n_faults == 0) {
        return inner;
    }
    inject->inner = inner;
    return (exk_source){.exchange = exchange, .ctx = inject};
}
