/** Feedback of both angles behind one interface; a new controller is a file and a row here.
 *
 *  kinds   none: c = 0.  pid: one exk_pid an angle.
 *  Errors  init: EXK_ERR_ARG (kind out of range, or the controller refuses its gains).
 *          step: cannot fail.
 *  Memory  the caller owns the struct; no pointer kept.
 */
#ifndef EXK_FEEDBACK_H
#define EXK_FEEDBACK_H

#include "exk/axes.h"
#include "exk/err.h"
#include "exk/pid.h"

typedef enum { EXK_FEEDBACK_NONE, EXK_FEEDBACK_PID, EXK_FEEDBACK_COUNT } exk_feedback_kind;

typedef struct {
    exk_feedback_kind kind;
    exk_pid_config pid;
} exk_feedback_config;

typedef struct {
    exk_feedback_kind kind;
    exk_pid pid[EXK_N_AXES];
} exk_feedback;

exk_feedback_config exk_feedback_default(void);
exk_err exk_feedback_init(exk_feedback *fb, const exk_feedback_config *cfg);
void exk_feedback_reset(exk_feedback *fb);

/** c[k+1] from e[k]. */
void exk_feedback_step(exk_feedback *fb, const double error_rad[EXK_N_AXES],
                       double correction_rad[EXK_N_AXES]);

/** After samples that were missed: the next step sees no jump of the error since the last one, so that
 *  a derivative does not kick. Everything else goes on as it was. */
void exk_feedback_rejoin(exk_feedback *fb, const double error_rad[EXK_N_AXES]);

/** Goes on from this correction, finite, as if the error before were not known: the derivative does not kick. */
void exk_feedback_preset(exk_feedback *fb, const double correction_rad[EXK_N_AXES]);

const char *exk_feedback_name(exk_feedback_kind kind); /* never NULL */

#endif
