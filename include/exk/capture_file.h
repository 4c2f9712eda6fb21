/** A capture ring as an LCM log: EXK_JOB, every sample as EXK_POSE, EXK_HOLE, the last EXK_STATUS.
 *
 *  Reads like any log of a run (exk-log --from, exk-holes): its first tick is not 0, and it ends with the
 *  fault. Stamps are those of the samples.
 *  Errors   false and why: as event_file.h. What exists and is not an LCM log is not overwritten.
 *  Memory   allocates while it runs, keeps nothing.
 */
#ifndef EXK_CAPTURE_FILE_H
#define EXK_CAPTURE_FILE_H

#include "exk/capture.h"
#include "exk/telemetry.h"

/** end: state, fault and figures of the run as they are now. */
bool exk_capture_file_write(const char *path, const exk_run_info *info,
                            const exk_capture *capture, const exk_record *end, char *why,
                            size_t why_size);

#endif
