/** Progress of trials on a terminal: share, rate, time left, a few times a second. */
#ifndef STUDY_PACE_H
#define STUDY_PACE_H

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    const char *name;
    uint64_t n_before; /* done before this run */
    uint64_t n_here;   /* done in this run */
    uint64_t n_all;
    uint64_t scale; /* ranks that go along at our rate */
    double begin_s;
    double shown_s;
    bool shown;
} study_pace;

void study_pace_begin(study_pace *pace, const char *name, uint64_t n_before, uint64_t n_all,
                      uint64_t scale, bool quiet);
void study_pace_step(study_pace *pace);
void study_pace_end(study_pace *pace);

#endif
