/** The machine's side of EXK_DRIVE and EXK_SENSOR.
 *
 *  Run      begins with a hello, ends with a bye or one silent second. While it lasts, other runs are
 *           refused and said once: a machine obeys one controller.
 *  Answers  one for each drive, with the drive's tick. The same tick again gives the same answer again;
 *           an older one, one of another run, and one of another rate (time_us is not k dt) gets none.
 *  Memory   the caller owns the struct and lends rig and bus.
 */
#ifndef EXK_TWIN_SERVER_H
#define EXK_TWIN_SERVER_H

#include <stdbool.h>
#include <stdint.h>

#include "exk/arrivals.h"
#include "exk/bus.h"
#include "exk/rig.h"
#include "exk/wire.h"

typedef struct {
    exk_rig *rig;
    exk_bus *bus;
    exk_source machine;
    bool quiet;
    int64_t machine_id;

    bool busy;
    bool over; /* a run has ended */
    int64_t run_id;
    int64_t session_id;      /* names the process that drives: a run_id may come again */
    int64_t refused_session; /* said already */
    bool other_rate;         /* said already */
    int64_t heard_us;
    int64_t seq;
    exk_wire_sensor answer; /* the newest */
    int64_t n_ticks;
    int64_t n_not_ours; /* malformed, of other runs, older than the newest */
    exk_arrivals arrivals;
} twin_server;

/** For exk_bus_listen. */
void twin_server_receive(void *ctx, const char *channel, const void *data, size_t bytes,
                         int64_t received_us);

#endif
