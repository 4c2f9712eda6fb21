/** What came out of a run, for people: results on stdout, notes on stderr. */
#ifndef EXK_LOOP_SUMMARY_H
#define EXK_LOOP_SUMMARY_H

#include <stdbool.h>
#include <stdint.h>

#include "exk/realtime.h"
#include "exk/rig.h"
#include "exk/telemetry.h"

typedef struct {
    const exk_rig *rig;
    const exk_publish_summary *summary;
    const exk_record *record; /* the last one */
    int64_t k_fault;
    int64_t n_missed;
    int signal;
    bool has_log; /* a log was asked for, and is whole */
    bool on_link; /* a machine on the bus, in real time */
    bool took_commands;
    const exk_histogram *lateness; /* NULL in fast mode */
    const exk_histogram *step_time;
} loop_ending;

void loop_summary_print(const loop_ending *ending, bool quiet);

#endif
