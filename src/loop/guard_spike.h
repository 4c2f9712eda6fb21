/** The part of the guard that expects: what the next sample may be, and what the one before it was. */
#ifndef EXK_LOOP_GUARD_SPIKE_H
#define EXK_LOOP_GUARD_SPIKE_H

#include "exk/guard.h"

/** The limits of a guard that has grown up, from its gain and variance. */
void exk_guard_set_limits(exk_guard *g);

/** Notes which angle was refused, and why; returns kind. */
exk_sample_kind exk_guard_reject(exk_guard *g, int axis, exk_sample_kind kind, double value,
                                 double limit);

exk_sample_kind exk_guard_judge_spike(exk_guard *g, int64_t k, const double m_rad[EXK_N_AXES]);

/** Takes a good sample into d^. */
void exk_guard_learn(exk_guard *g, int64_t k, const double m_rad[EXK_N_AXES]);

#endif
