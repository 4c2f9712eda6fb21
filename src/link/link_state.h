/** What the two ways of driving a machine over the bus share. */
#ifndef EXK_LINK_STATE_H
#define EXK_LINK_STATE_H

#include <pthread.h>
#include <stdatomic.h>

#include "exk/arrivals.h"
#include "exk/bus.h"
#include "exk/link.h"
#include "exk/ring.h"
#include "exk/wire.h"

enum { LINK_SLOTS = 1024 };

typedef struct {
    int64_t k;
    int64_t seq;
    exk_drive drive;
} link_drive;

typedef struct {
    int64_t k;
    exk_reading reading;
} link_answer;

struct exk_link {
    exk_link_config cfg;
    int64_t session_id;
    exk_bus *in;
    exk_bus *out; /* lock-step: the same as in */
    exk_ring drives;
    exk_ring answers;
    link_drive drive_slots[LINK_SLOTS];
    link_answer answer_slots[LINK_SLOTS];

    /* written by whoever reads the bus */
    exk_arrivals arrivals;
    int64_t machine_id;
    bool has_machine;
    bool greeted;
    _Atomic int64_t n_lost;
    _Atomic int64_t n_repeated;
    _Atomic int64_t n_reordered;
    _Atomic int64_t n_foreign;
    _Atomic int64_t n_dropped;

    /* the control thread's own */
    int64_t next_seq;
    int64_t n_late;
    _Atomic int64_t last_k;   /* newest tick sent: no answer can be of a later one */
    _Atomic int64_t last_seq; /* newest drive sent */

    pthread_t reader;
    pthread_t writer;
    bool has_reader;
    bool has_writer;
    _Atomic bool stopping;
};

/** Encodes and sends; false when the bus refuses. */
bool link_transmit(exk_link *link, exk_drive_kind kind, const link_drive *drive);

/** Gives the next drive its number and notes what may be answered. */
void link_number(exk_link *link, link_drive *drive);

/** A message on EXK_SENSOR. */
void link_receive(void *ctx, const char *channel, const void *data, size_t bytes,
                  int64_t received_us);

/** Starts the two threads of a paced run; 0 or an errno. */
int link_start_threads(exk_link *link);
void link_stop_threads(exk_link *link);

#endif
