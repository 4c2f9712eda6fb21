/** Picture of a run: the drilled path on its reference with the error enlarged, and the error over
 *  time beside the tolerance. Drawn from the log, so a picture never slows recording.
 *
 *  Errors   an exit code as in gnuplot.h, or the log's.
 */
#ifndef EXK_LOG_PATH_PICTURE_H
#define EXK_LOG_PATH_PICTURE_H

#include "exk/log.h"

/** log: what was counted in the log at log_path. */
int path_picture_write(const exk_run_log *log, const char *log_path, const char *path,
                       char *why, size_t why_size);

#endif
