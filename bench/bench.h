/** Benchmarks of the calls a control step is made of.
 *
 *  Method  each case runs over BENCH_INPUTS independent inputs; a repeat is one pass over them, a round
 *          the median of BENCH_REPEATS repeats; the cases take turns round by round, so that a slow
 *          spell of the machine hits all alike. Reported: median, smallest and largest round.
 */
#ifndef EXK_BENCH_H
#define EXK_BENCH_H

#include <stddef.h>

enum { BENCH_INPUTS = 1024, BENCH_REPEATS = 51, BENCH_ROUNDS = 7 };

/** One case: run makes n_calls calls and returns something that depends on all of them. */
typedef struct {
    const char *name;
    double goal_ns; /* what we promise on this kind of machine, 0: no promise */
    size_t n_calls; /* calls of one repeat */
    double (*run)(void);
    double round_ns[BENCH_ROUNDS];
} bench_case;

/** Times all cases, round by round. */
void bench_time(bench_case *cases, size_t n_cases);
double bench_median(double *values, size_t n);

/** The cases of kinematics, control, noise and ILC; returns how many were written. */
size_t bench_core_cases(bench_case *cases, size_t capacity);

/** The whole step on profiles/machine.ini, the ring and the wire; 0 after a message on stderr. */
size_t bench_step_cases(bench_case *cases, size_t capacity);

#endif
