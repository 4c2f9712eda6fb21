/** Faults put into a joint source on purpose, to see what becomes of them.
 *
 *  A fault acts on the readings of the ticks at_s/dt <= k < at_s/dt + max(1, for_s/dt), rounded:
 *    none     nothing is done
 *    nan      NaN                          inf      +infinity, -infinity by turns
 *    range    10 rad are added             spike    size_rad is added
 *    stuck    the value of the tick before, all the time
 *    garbage  draws of Philox: by turns 64 random bits taken for a number, and any angle up to 0.5 rad
 *    dropout  nothing comes (fresh = false), both angles
 *    delay    the reading of delay ticks earlier, which says so (age); nothing before tick 0
 *  The true angles are left alone. Faults act in their listed order.
 *  Draws   a function of (seed, series, run, fault, k): the same in both twins.
 *  Errors  init: EXK_ERR_SIZE (too many), EXK_ERR_ARG (kind, dt not > 0, a time negative, a number not
 *          finite, a delay of more than EXK_INJECT_DELAY_MAX ticks).  apply: cannot fail.
 *  Memory  the caller owns the struct; the source made by exk_inject_source points into it.
 */
#ifndef EXK_INJECT_H
#define EXK_INJECT_H

#include <stddef.h>

#include "exk/disturbance.h"
#include "exk/source.h"

enum { EXK_MAX_INJECTED = 8, EXK_INJECT_DELAY_MAX = 255, EXK_SOURCE_INJECT = 240 };

typedef enum {
    EXK_INJECT_NONE,
    EXK_INJECT_NAN,
    EXK_INJECT_INF,
    EXK_INJECT_RANGE,
    EXK_INJECT_SPIKE,
    EXK_INJECT_STUCK,
    EXK_INJECT_DROPOUT,
    EXK_INJECT_DELAY,
    EXK_INJECT_GARBAGE,
    EXK_INJECT_COUNT
} exk_inject_kind;

typedef struct {
    exk_inject_kind kind;
    bool channel[EXK_N_AXES];
    double at_s;
    double for_s;
    double size_rad; /* spike */
    double delay_s;  /* delay */
} exk_inject_fault;

typedef struct {
    exk_inject_fault fault[EXK_MAX_INJECTED];
    size_t n_faults;
} exk_inject_config;

typedef struct {
    exk_inject_config cfg; /* fixed by init */
    exk_stream stream;
    int64_t begin[EXK_MAX_INJECTED]; /* ticks */
    int64_t end[EXK_MAX_INJECTED];
    int64_t delay[EXK_MAX_INJECTED];
    double before_rad[EXK_N_AXES];                 /* of the last tick, as it was */
    double held_rad[EXK_MAX_INJECTED][EXK_N_AXES]; /* stuck */
    bool holds[EXK_MAX_INJECTED];
    exk_reading past[EXK_INJECT_DELAY_MAX + 1]; /* by tick, round and round */
    int64_t past_k[EXK_INJECT_DELAY_MAX + 1];
    exk_source inner;
} exk_inject;

/** none, both angles, at once, for one sample; 5 mrad, 10 ms where they matter. */
exk_inject_fault exk_inject_default(void);
exk_err exk_inject_init(exk_inject *inject, const exk_inject_config *cfg, double dt_s,
                        exk_realisation which);

/** What becomes of the reading of tick k; ticks rise. */
void exk_inject_apply(exk_inject *inject, int64_t k, exk_reading *reading);

/** The inner source with the faults in it; inner itself when there are none. */
exk_source exk_inject_source(exk_inject *inject, exk_source inner);

const char *exk_inject_name(exk_inject_kind kind); /* never NULL */

#endif
