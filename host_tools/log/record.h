/** Recording: every EXK_ message of the bus into an LCM log, byte by byte, as it comes.
 *
 *  End      Ctrl-C or SIGTERM, the time given, or the run's last status (until_done; a second after
 *           DONE or FAULT when that one is lost; after five silent seconds when the run died).
 *  Errors   an exit code: 0, or with why 2 (a path that is refused), 3 (no bus, a full disk).
 */
#ifndef EXK_LOG_RECORD_H
#define EXK_LOG_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/log.h"

typedef enum {
    RECORD_STOPPED, /* by a signal */
    RECORD_TIME,    /* the time was over */
    RECORD_DONE,    /* the run was */
    RECORD_SILENT   /* it fell silent */
} record_end;

typedef struct {
    const char *path;
    const char *url;
    double seconds; /* 0: no bound */
    bool until_done;
    bool progress;
} record_request;

typedef struct {
    record_end end;
    int64_t n_messages;
    int64_t n_bytes; /* of the log */
    double seconds;  /* from the first message to the last */
} record_result;

int record_bus(exk_run_log *log, const record_request *request, record_result *out, char *why,
               size_t why_size);

#endif
