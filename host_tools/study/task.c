#define _POSIX_C_SOURCE 200809L
#include "task.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "exk/store.h"
#include "exk/version.h"

int study_sums_open(study_sums *sums, const study_measure *measures, size_t n)
{
    size_t n_bins = 0;
    for (size_t i = 0; i < n; i++) {
        n_bins += study_bins_needed(&measures[i]);
    }
    *sums = (study_sums){.tallies = calloc(n, sizeof *sums->tallies),
                         .bins = calloc(n_bins + 1, sizeof *sums->bins),
                         .n = n};
    if (sums->tallies == NULL || sums->bins == NULL) {
        study_sums_close(sums);
        fprintf(stderr, "exk-study: out of memory\n");
        return STUDY_IO;
    }
    uint32_t *bins = sums->bins;
    for (size_t i = 0; i < n; i++) {
        study_tally_init(&sums->tallies[i], &measures[i], bins);
        bins += sums->tallies[i].n_bins;
    }
    return STUDY_GOOD;
}

void study_sums_close(study_sums *sums)
{
    free(sums->tallies);
    free(sums->bins);
    *sums = (study_sums){.n = 0};
}

uint64_t study_hash(const study_measure *measures, size_t n, const char *text)
{
    char *all = NULL;
    size_t size = 0;
    uint64_t hash = 0;
    FILE *stream = open_memstream(&all, &size);
    if (stream == NULL) {
        return 0;
    }
    fprintf(stream, "exk %s\n", EXK_VERSION);
    for (size_t i = 0; i < n; i++) {
        fprintf(stream, "%s %d %" PRIu32 "\n", measures[i].key, (int)measures[i].kind,
                measures[i].count_max);
    }
    fputs(text, stream);
    if (fclose(stream) == 0) {
        hash = exk_store_hash(all, size);
    }
    free(all);
    return hash;
}
