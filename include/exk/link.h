/** The machine in another process: EXK_DRIVE out, EXK_SENSOR in (source bus).
 *
 *  Lock-step  (fast) exchange sends q[k] and waits for the answer to it; asks again every 50 ms, so a
 *             lost datagram changes nothing; no answer within answer_s is EXK_ERR_SILENT. Virtual time:
 *             the same bits as a twin in the process.
 *  Paced      send hands q[k] to a thread, collect takes what has come for tick k when tick k + 1
 *             begins: what is not there then is missing (fresh = false), and counted as late when it
 *             comes after all. Both are wait-free: two rings, no allocation, no system call.
 *  Order      lost, repeated, reordered (exk/arrivals.h), late, and foreign: another run, another
 *             machine, or the answer to nothing that was sent. Only answers to this run count.
 *  Start      open says hello until one machine answers; the run stays with that one.
 *  Errors     open: NULL with what to do: no machine answers, no route, no memory.
 *  Memory     open allocates, close releases. Outside the core.
 */
#ifndef EXK_LINK_H
#define EXK_LINK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/bus_counts.h"
#include "exk/disturbance.h"
#include "exk/source.h"

typedef struct {
    const char *url;
    int64_t run_id;
    exk_realisation which; /* which noise a twin shall be */
    double dt_s;
    double answer_s;
    bool fast;    /* lock-step */
    int priority; /* of the control thread; the paced link's threads ask for the one below it */
} exk_link_config;

typedef struct exk_link exk_link;

exk_link *exk_link_open(const exk_link_config *cfg, char *why, size_t why_size);

/** Says bye to the machine and ends the threads. NULL is allowed. */
void exk_link_close(exk_link *link);

/** Lock-step: a joint source. */
exk_source exk_link_source(exk_link *link);

/** Paced, control thread. */
void exk_link_send(exk_link *link, int64_t k, const exk_drive *drive);
void exk_link_collect(exk_link *link, int64_t k, exk_reading *out);

/** Control thread: datagrams dropped by the system, as last looked at. */
int64_t exk_link_dropped(const exk_link *link);

/** Control thread: counts so far. */
void exk_link_counts_so_far(const exk_link *link, exk_link_counts *out);

#endif
