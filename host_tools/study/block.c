#include "block.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { VERSION = 1, HEAD_BYTES = 48, FIXED_BYTES = 60, BIN_BYTES = 8, CRC_BYTES = 4 };

static const char magic[8] = {'E', 'X', 'K', 'B', 'L', 'K', '\0', '\0'};

typedef struct {
    uint8_t *at;
} writer;

typedef struct {
    const uint8_t *at;
    const uint8_t *end;
    bool good;
} reader;

static void put(writer *w, uint64_t value, int n)
{
    for (int i = 0; i < n; i++) {
        *w->at++ = (uint8_t)(value >> (8 * i));
    }
}

static void put_double(writer *w, double value)
{
    uint64_t bits = 0;
    memcpy(&bits, &value, sizeof bits);
    put(w, bits, 8);
}

static uint64_t get(reader *r, int n)
{
    uint64_t value = 0;
    r->good = r->good && r->end - r->at >= n;
    for (int i = 0; i < n && r->good; i++) {
        value |= (uint64_t)*r->at++ << (8 * i);
    }
    return value;
}

static double get_double(reader *r)
{
    const uint64_t bits = get(r, 8);
    double value = 0.0;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static uint32_t filled_bins(const study_tally *tally)
{
    uint32_t n = 0;
    for (uint32_t i = 0; i < tally->n_bins && tally->moments.n > 0; i++) {
        n += tally->bins[i] > 0;
    }
    return n;
}

static void put_tally(writer *w, const study_tally *tally)
{
    put(w, tally->moments.n, 8);
    put_double(w, tally->moments.mean);
    put_double(w, tally->moments.m2);
    put_double(w, tally->min);
    put_double(w, tally->max);
    put(w, tally->n_positive, 8);
    put(w, tally->n_bad, 8);
    put(w, filled_bins(tally), 4);
    for (uint32_t i = 0; i < tally->n_bins && tally->moments.n > 0; i++) {
        if (tally->bins[i] > 0) {
            put(w, i, 4);
            put(w, tally->bins[i], 4);
        }
    }
}

static size_t size_needed(const study_tally *tallies, size_t n_measures)
{
    size_t n = HEAD_BYTES + CRC_BYTES;
    for (size_t i = 0; i < n_measures; i++) {
        n += FIXED_BYTES + BIN_BYTES * (size_t)filled_bins(&tallies[i]);
    }
    return n;
}

static uint32_t crc_of(const uint8_t *bytes, size_t n)
{
    return (uint32_t)crc32_z(0, bytes, n);
}

uint8_t *study_block_encode(const study_tally *tallies, size_t n_measures,
                            const study_block_head *head, size_t *n_bytes)
{
    const size_t n = size_needed(tallies, n_measures);
    uint8_t *bytes = malloc(n);
    if (bytes == NULL) {
        return NULL;
    }
    memcpy(bytes, magic, sizeof magic);
    writer w = {bytes + sizeof magic};
    put(&w, VERSION, 4);
    put(&w, n_measures, 4);
    put(&w, head->hash, 8);
    put(&w, head->first, 8);
    put(&w, head->n_trials, 8);
    put(&w, n, 8);
    for (size_t i = 0; i < n_measures; i++) {
        put_tally(&w, &tallies[i]);
    }
    put(&w, crc_of(bytes, n - CRC_BYTES), 4);
    *n_bytes = n;
    return bytes;
}

static bool refuse(char *why, size_t why_size, const char *reason)
{
    snprintf(why, why_size, "%s", reason);
    return false;
}

bool study_block_check(const uint8_t *bytes, size_t size, study_block_head *head, char *why,
                       size_t why_size)
{
    if (size < HEAD_BYTES + CRC_BYTES || memcmp(bytes, magic, sizeof magic) != 0) {
        return refuse(why, why_size, "not a block of a study, or cut in its first bytes");
    }
    reader r = {bytes + sizeof magic, bytes + size, true};
    if (get(&r, 4) != VERSION) {
        return refuse(why, why_size, "a block of another version of the format");
    }
    get(&r, 4);
    const study_block_head found = {.hash = get(&r, 8),
                                    .first = get(&r, 8),
                                    .n_trials = get(&r, 8),
                                    .n_bytes = (size_t)get(&r, 8)};
    if (found.n_bytes < HEAD_BYTES + CRC_BYTES || found.n_bytes > size) {
        return refuse(why, why_size, "cut: the block is longer than what is there");
    }
    reader tail = {bytes + found.n_bytes - CRC_BYTES, bytes + found.n_bytes, true};
    if (get(&tail, 4) != crc_of(bytes, found.n_bytes - CRC_BYTES)) {
        return refuse(why, why_size, "damaged: its CRC does not fit its bytes");
    }
    *head = found;
    return true;
}

static void get_tally(reader *r, study_tally *tally)
{
    study_tally_clear(tally);
    tally->moments.n = get(r, 8);
    tally->moments.mean = get_double(r);
    tally->moments.m2 = get_double(r);
    tally->min = get_double(r);
    tally->max = get_double(r);
    tally->n_positive = get(r, 8);
    tally->n_bad = get(r, 8);
    const uint64_t n_filled = get(r, 4);
    for (uint64_t i = 0; i < n_filled && r->good; i++) {
        const uint64_t bin = get(r, 4);
        const uint64_t count = get(r, 4);
        r->good = r->good && bin < tally->n_bins;
        if (r->good) {
            tally->bins[bin] = (uint32_t)count;
        }
    }
}

bool study_block_fold(const uint8_t *bytes, size_t size, study_tally *totals, study_tally *part,
                      size_t n_measures)
{
    reader r = {bytes + sizeof magic + 4, bytes + size - CRC_BYTES, true};
    if (get(&r, 4) != n_measures) {
        return false;
    }
    r.at = bytes + HEAD_BYTES;
    for (size_t i = 0; i < n_measures; i++) {
        get_tally(&r, &part[i]);
    }
    if (!r.good || r.at != r.end) {
        return false;
    }
    for (size_t i = 0; i < n_measures; i++) {
        study_tally_merge(&totals[i], &part[i]);
    }
    return true;
}
