/** Joint source that answers with the angles recorded in an LCM log.
 *
 *  m[k]    the recorded measurement of tick k; a tick that the log does not hold is not fresh.
 *  theta   not known: what moved in the recorded run is not the truth of this one.
 *  Errors  open: false, with a reason. exchange: EXK_ERR_END past the last recorded tick.
 *  Memory  open allocates; exk_replay_close releases. Outside the core.
 */
#ifndef EXK_REPLAY_H
#define EXK_REPLAY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/axes.h"
#include "exk/source.h"

typedef struct {
    int64_t k;
    double m_rad[EXK_N_AXES];
} exk_replay_sample;

typedef struct {
    exk_replay_sample *samples; /* in order of k */
    size_t n_samples;
    size_t next; /* first sample not yet passed */
} exk_replay;

bool exk_replay_open(exk_replay *replay, const char *path, char *why, size_t why_size);
void exk_replay_close(exk_replay *replay);
void exk_replay_rewind(exk_replay *replay);
exk_source exk_replay_source(exk_replay *replay);

#endif
