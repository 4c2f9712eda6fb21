#include "exk/arrivals.h"

enum { WINDOW = 64 };

void exk_arrivals_init(exk_arrivals *arrivals)
{
    *arrivals = (exk_arrivals){.newest = -1};
}

static exk_arrival take_new(exk_arrivals *arrivals, int64_t seq)
{
    const uint64_t step = (uint64_t)seq - (uint64_t)arrivals->newest;
    arrivals->seen = step < WINDOW ? arrivals->seen << step | 1U : 1U;
    arrivals->n_lost += (int64_t)(step - 1);
    arrivals->newest = seq;
    return EXK_ARRIVAL_NEW;
}

exk_arrival exk_arrivals_take(exk_arrivals *arrivals, int64_t seq)
{
    if (seq > arrivals->newest) {
        return take_new(arrivals, seq);
    }
    const uint64_t age = (uint64_t)arrivals->newest - (uint64_t)seq;
    if (seq < 0 || age >= WINDOW || (arrivals->seen >> age & 1U) != 0) {
        arrivals->n_repeated++;
        return EXK_ARRIVAL_REPEATED;
    }
    arrivals->seen |= (uint64_t)1 << age;
    arrivals->n_lost--;
    arrivals->n_reordered++;
    return EXK_ARRIVAL_REORDERED;
}
