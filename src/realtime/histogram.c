#include "exk/realtime.h"

/* Bin 0 holds all below 64 ns; above, four bins a factor of two:
 * 64-80, 80-96, 96-112, 112-128, 128-160, ... ns */
enum { FIRST_LOG2 = 6, PER_OCTAVE = 4 };

static int log2_floor(uint64_t v)
{
    int n = 0;
    while (v >>= 1) {
        n++;
    }
    return n;
}

static int bin_of(int64_t value_ns)
{
    if (value_ns < (int64_t)1 << FIRST_LOG2) {
        return 0;
    }
    const int octave = log2_floor((uint64_t)value_ns);
    /* NOLINTNEXTLINE(clang-analyzer-core.BitwiseShift): octave >= FIRST_LOG2 */
    const int quarter = (int)(((uint64_t)value_ns >> (octave - 2)) & 3U);
    const int bin = 1 + PER_OCTAVE * (octave - FIRST_LOG2) + quarter;
    return bin < EXK_HIST_BINS ? bin : EXK_HIST_BINS - 1;
}

static int64_t upper_edge_ns(int bin)
{
    if (bin == 0) {
        return (int64_t)1 << FIRST_LOG2;
    }
    const int octave = FIRST_LOG2 + (bin - 1) / PER_OCTAVE;
    const int64_t quarter = (bin - 1) % PER_OCTAVE;
    return (PER_OCTAVE + quarter + 1) * ((int64_t)1 << (octave - 2));
}

void exk_histogram_add(exk_histogram *hist, int64_t value_ns)
{
    const int bin = bin_of(value_ns);
    const uint64_t here = atomic_load_explicit(&hist->bin[bin], memory_order_relaxed);
    const uint64_t all = atomic_load_explicit(&hist->n, memory_order_relaxed);
    atomic_store_explicit(&hist->bin[bin], here + 1, memory_order_relaxed);
    atomic_store_explicit(&hist->n, all + 1, memory_order_relaxed);
    if (value_ns > atomic_load_explicit(&hist->max_ns, memory_order_relaxed)) {
        atomic_store_explicit(&hist->max_ns, value_ns, memory_order_relaxed);
    }
}

int64_t exk_histogram_quantile_ns(const exk_histogram *hist, double p)
{
    const uint64_t n = atomic_load_explicit(&hist->n, memory_order_relaxed);
    const int64_t max_ns = atomic_load_explicit(&hist->max_ns, memory_order_relaxed);
    uint64_t below = 0;
    for (int bin = 0; bin < EXK_HIST_BINS; bin++) {
        below += atomic_load_explicit(&hist->bin[bin], memory_order_relaxed);
        if (n > 0 && (double)below >= p * (double)n) {
            const int64_t edge_ns = upper_edge_ns(bin);
            return edge_ns < max_ns ? edge_ns : max_ns;
        }
    }
    return max_ns;
}
