/** What the bus did to a run, counted by kind: figures of the status message.
 *
 *  Units   counts from the start of a run.  Memory  plain structs.
 */
#ifndef EXK_BUS_COUNTS_H
#define EXK_BUS_COUNTS_H

#include <stdint.h>

/** Answers of a machine on the bus. */
typedef struct {
    int64_t n_lost;      /* never came, by their seq */
    int64_t n_late;      /* came when the next tick had begun */
    int64_t n_repeated;  /* came twice */
    int64_t n_reordered; /* came after a later one */
    int64_t n_foreign;   /* of another run or machine, or to nothing that was asked */
} exk_link_counts;

/** Why a command is refused, in the order of the checks; on the wire as an index. */
typedef enum {
    EXK_REFUSED_MALFORMED, /* not one whole command_t */
    EXK_REFUSED_RUN,       /* of another run */
    EXK_REFUSED_KEY,       /* keyed hash not ours */
    EXK_REFUSED_STALE,     /* too old, or too far in the future */
    EXK_REFUSED_REPLAYED,  /* seq not above that of the last one taken */
    EXK_REFUSED_UNKNOWN,   /* no such command */
    EXK_REFUSED_FULL,      /* no room: more at once than a run can use */
    EXK_REFUSED_COUNT
} exk_refusal;

typedef struct {
    int64_t n_taken;
    int64_t last_seq; /* of the last one taken; 0 before the first */
    int64_t n_refused[EXK_REFUSED_COUNT];
} exk_command_counts;

/** What a record carries to the status. */
typedef struct {
    exk_link_counts link;
    exk_command_counts command;
    int64_t n_dropped; /* datagrams dropped by the system */
} exk_bus_counts;

#endif
