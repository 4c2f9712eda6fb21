/** The parts of one step, on the sample that is open (loop->open). */
#ifndef EXK_LOOP_STEP_H
#define EXK_LOOP_STEP_H

#include "exk/loop.h"

int64_t exk_step_time_us(const exk_loop *loop, int64_t k);

/** Reference, inverse, command, limits. On an error what says which limit, where there is one. */
exk_err exk_step_command(exk_loop *loop, exk_violation *what);

void exk_step_drive(const exk_sample *sample, exk_drive *drive);

/** Guard, following error and feedback; raises the faults of both. */
void exk_step_correct(exk_loop *loop, const exk_reading *reading);

/** p_est = FK(m), p_true = FK(theta). */
exk_err exk_step_forward(exk_loop *loop, const exk_reading *reading);

#endif
