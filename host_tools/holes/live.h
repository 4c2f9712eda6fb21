/** Listens to a run on the bus until it is done.
 *
 *  Ends    on DONE or FAULT, after the time asked for, on SIGINT or SIGTERM, or when a run that has
 *          begun stays silent for five seconds.
 *  Loss    the queue is unbounded (bus.h); what the bus itself loses shows as a gap.
 *  Errors  an exit code: 0, 3 (no bus) or 2 (nothing heard); why says what to do.
 */
#ifndef EXK_HOLES_LIVE_H
#define EXK_HOLES_LIVE_H

#include <stdbool.h>
#include <stddef.h>

#include "exk/log.h"

int hole_live_listen(exk_run_log *log, const char *url, double seconds, bool quiet, char *why,
                     size_t why_size);

#endif
