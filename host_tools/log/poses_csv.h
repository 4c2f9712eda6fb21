/** Poses as CSV, one row each, in the order they count: written while they come, so that a run of any
 *  length fits.
 *
 *  Columns  names carry their unit; metres and radians, base frame, as on the bus. Numbers to 17
 *           digits: they read back to the same bits. seq shows where samples are lost. What only a
 *           twin knows stays empty without one.
 *  Errors   exit codes as in out_file.h.
 */
#ifndef EXK_LOG_POSES_CSV_H
#define EXK_LOG_POSES_CSV_H

#include "exk/wire.h"
#include "out_file.h"

int poses_csv_open(exk_out *out, const char *path, char *why, size_t why_size);
void poses_csv_row(exk_out *out, const exk_wire_pose *pose);

#endif
