/** Joint source: where a step sends its command and finds its measured angles.
 *
 *  Kinds   twin (this process), replay (a log), bus (another process): one interface.
 *  Shapes  the command of tick k in, the angles of tick k out.  Units  radians, metres.
 *  Errors  exchange: EXK_OK, or EXK_ERR_END when nothing further will come. A lost or late sample
 *          is EXK_OK with fresh = false. Values may be anything, NaN included: the loop checks.
 *  Memory  the caller owns what ctx points to.
 */
#ifndef EXK_SOURCE_H
#define EXK_SOURCE_H

#include <stdbool.h>
#include <stdint.h>

#include "exk/axes.h"
#include "exk/err.h"

typedef struct {
    double angle_rad[EXK_N_AXES]; /* q: commanded alpha, beta */
    double legs_m[EXK_N_LEGS];
    double wrist_rad[EXK_N_WRIST];
} exk_drive;

typedef struct {
    double measured_rad[EXK_N_AXES]; /* m: what the controller may read */
    double true_rad[EXK_N_AXES];     /* theta: for the record only; valid when has_true */
    bool has_true;
    bool fresh;
    int64_t age; /* ticks from the sample's own to the one asked for; 0: in time */
} exk_reading;

typedef struct {
    exk_err (*exchange)(void *ctx, int64_t k, const exk_drive *drive, exk_reading *out);
    void *ctx;
} exk_source;

#endif
