/** Wake-up lateness of our tick grid beside cyclictest: the same core, in turns, in one run.
 *
 *  Lateness  wake-up after a tick's own time, whole microseconds, bins of 1 us.
 *  Late      woken more than a period after its time, so that the next tick was due already.
 *  Pair      one stretch of ours and one of cyclictest, in turns which comes first.
 *  Units     us in figures, s for lengths.  Errors  0 or an exit code, said on stderr.
 */
#ifndef EXK_JITTER_H
#define EXK_JITTER_H

#include <stdbool.h>
#include <stdint.h>

enum { JITTER_BINS = 20000, JITTER_PAIRS_MAX = 64, JITTER_FIGURES = 4 };

typedef struct {
    uint64_t bin[JITTER_BINS]; /* bin i: i to i + 1 us */
    uint64_t n;                /* wake-ups in all */
    uint64_t n_over;           /* beyond the last bin */
    double max_us;
} jitter_histogram;

/** What one condition of a run asks for. */
typedef struct {
    double rate_Hz;
    bool loaded;     /* CPU hogs and a disk writer beside */
    bool privileged; /* SCHED_FIFO and locked memory for both, or for neither */
    double seconds;  /* of one stretch */
    int n_pairs;
    int cpu;
} jitter_case;

/** p50, p99, p99.9 and max of one stretch or of many together, and how many were late. */
typedef struct {
    double us[JITTER_FIGURES];
    uint64_t n;
    uint64_t n_late;
    double late_low; /* 95 % interval of the share that was late */
    double late_high;
} jitter_figures;

typedef struct {
    jitter_case what;
    jitter_figures ours[JITTER_PAIRS_MAX];
    jitter_figures theirs[JITTER_PAIRS_MAX];
    jitter_figures all_ours; /* the stretches together */
    jitter_figures all_theirs;
    jitter_histogram sum_ours;
    jitter_histogram sum_theirs;
    double ratio[2]; /* median over the pairs of ours / theirs: p50, p99 */
} jitter_result;

int jitter_ours(const jitter_case *what, jitter_histogram *out);
int jitter_theirs(const jitter_case *what, jitter_histogram *out);

/** Starts the load (processes of their own) and ends it again. */
int jitter_load_start(void);
void jitter_load_stop(void);

void jitter_add(jitter_histogram *to, const jitter_histogram *from);
jitter_figures jitter_figures_of(const jitter_histogram *hist, double period_us);
double jitter_median_ratio(const jitter_figures *ours, const jitter_figures *theirs, int n,
                           int figure);

int jitter_json(const jitter_result *results, int n, const char *path);
int jitter_plot(const jitter_result *results, int n, const char *path);
void jitter_table(const jitter_result *results, int n);

#endif
