/** In what order numbered messages arrive: new, repeated, or after a later one.
 *
 *  seq       counts the sender's messages from 0. A jump of n counts n - 1 as lost; one that comes
 *            after all is no longer lost but reordered. A window of 64 seq tells a repeat from a late
 *            comer; what is older than the window is left out as a repeat.
 *  Shapes    one struct a sender.  Errors  none: any number is survived.  Memory  the caller's.
 */
#ifndef EXK_ARRIVALS_H
#define EXK_ARRIVALS_H

#include <stdint.h>

typedef enum { EXK_ARRIVAL_NEW, EXK_ARRIVAL_REORDERED, EXK_ARRIVAL_REPEATED } exk_arrival;

typedef struct {
    int64_t newest; /* -1 before the first */
    uint64_t seen;  /* bit i: newest - i came */
    int64_t n_lost;
    int64_t n_repeated;
    int64_t n_reordered;
} exk_arrivals;

void exk_arrivals_init(exk_arrivals *arrivals);
exk_arrival exk_arrivals_take(exk_arrivals *arrivals, int64_t seq);

#endif
