/** A learning series on one rig: run, judge, learn, run again.
 *
 *  Law      u_{p+1} = Q(u_p + K (e_p + c_p)), exk_ilc_learn for each angle (docs/step.md).
 *           Run 1 is untrained; after n runs and n updates u holds u_{n+1}.
 *  Judged   on the true tip where the source knows it, else on the estimated one.
 *  Samples  on_sample, when set after open, sees every step of a run in order; on_point sees reference
 *           and true tip alone, which costs a third.
 *  Brief    a run on the twin that nobody samples takes exk_loop_brief, with noise that repeats drawn once
 *           a series: the same bits. by_steps turns both off, to show that.
 *  Errors   run: the loop's code (the series is then at the tick of the fault); learn: as
 *           exk_ilc_learn, u keeps its old values then.
 *  Memory   open allocates one block for each array, exk_series_close releases. Outside the core.
 */
#ifndef EXK_SERIES_H
#define EXK_SERIES_H

#include "exk/accuracy.h"
#include "exk/brief.h"
#include "exk/rig.h"

typedef void (*exk_sample_fn)(void *ctx, const exk_sample *sample);
typedef void (*exk_point_fn)(void *ctx, const exk_judged_point *point);

typedef struct {
    exk_rig *rig;
    size_t n; /* samples of one run */
    double *u_rad[EXK_N_AXES];
    double *e_rad[EXK_N_AXES];
    double *c_rad[EXK_N_AXES];
    double *next_rad[EXK_N_AXES];
    exk_hole_result *results; /* of the last run, one a hole */
    int64_t n_bad;            /* rejected sensor samples of the last run */
    double *block;
    exk_sample_fn on_sample; /* NULL: nobody looks */
    void *sample_ctx;
    exk_point_fn on_point;
    void *point_ctx;
    bool by_steps;
    exk_waypoint *way; /* one a tick, made by the first brief run; NULL before */
    double *noise_rad[EXK_N_AXES];
    exk_realisation drawn; /* what noise_rad holds; run 0: nothing */
} exk_series;

bool exk_series_open(exk_series *series, exk_rig *rig);
void exk_series_close(exk_series *series);

/** Back to u_1 = 0, for the next series on the same rig. Needed too after the rig's noise was changed. */
void exk_series_reset(exk_series *series);

/** One whole run with the present u; fills e, c and results. */
exk_err exk_series_run(exk_series *series, exk_realisation which, exk_accuracy *out);

/** u <- u_{p+1} from e and c of the last run. */
exk_err exk_series_learn(exk_series *series);

#endif
