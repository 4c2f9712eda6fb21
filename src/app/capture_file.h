/** The samples before a fault, at full rate, as a log of their own beside the record. */
#ifndef EXK_LOOP_CAPTURE_FILE_H
#define EXK_LOOP_CAPTURE_FILE_H

#include <stdbool.h>

#include "ticks.h"

/** Seconds that are kept. */
extern const double loop_capture_s;

/** Writes NAME.fault.lcm beside NAME.lcm when the run met a fault, and says so on stderr. False: it
 *  could not be written; the reason was said. */
bool loop_capture_write(const loop_ticks *t, const exk_run_info *info);

#endif
