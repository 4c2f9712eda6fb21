/** Where encoded messages go: the bus, the log file, both or neither.
 *
 *  Failing  the first failure is kept in why and said once on stderr. A bus that fails is tried again
 *           with the next EXK_JOB, so once a second; a file that failed stays closed.
 *  Stamps   fast: the message's own time; else the wall clock.
 */
#ifndef EXK_OUTLET_H
#define EXK_OUTLET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/bus.h"
#include "exk/event_file.h"

typedef struct {
    exk_bus *bus;
    exk_event_writer *file;
    bool fast;
    bool bus_down;
    bool bus_ok;
    bool file_ok;
    char why[512]; /* first failure, empty when none */
} exk_outlet;

bool exk_outlet_open(exk_outlet *out, const char *url, const char *record_path, bool fast,
                     char *why, size_t why_size);
void exk_outlet_send(exk_outlet *out, const char *channel, const void *data, int bytes,
                     int64_t time_us);
void exk_outlet_flush(exk_outlet *out);
void exk_outlet_close(exk_outlet *out);

#endif
