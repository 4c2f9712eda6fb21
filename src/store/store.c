#define _POSIX_C_SOURCE 200809L
#include "exk/store.h"

#include <inttypes.h>
#include <limits.h>
#include <math.h>
#include <sodium.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "store_file.h"
#include "store_on.h"
#include "store_os.h"

enum { VERSION = 1, HEADER_BYTES = 48, CRC_BYTES = 4, SAMPLES_MAX = 100000000 };
static const unsigned char magic[8] = {'E', 'X', 'K', 'I', 'L', 'C', 0, 0};

/* Numbers are little-endian on every host. */
static void put(unsigned char *at, uint64_t value, int n_bytes)
{
    for (int i = 0; i < n_bytes; i++) {
        at[i] = (unsigned char)(value >> (8 * i));
    }
}

static uint64_t get(const unsigned char *at, int n_bytes)
{
    uint64_t value = 0;
    for (int i = 0; i < n_bytes; i++) {
        value |= (uint64_t)at[i] << (8 * i);
    }
    return value;
}

static void put_f64(unsigned char *at, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put(at, bits, 8);
}

static double get_f64(const unsigned char *at)
{
    const uint64_t bits = get(at, 8);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static uint32_t crc_of(const unsigned char *bytes, size_t n)
{
    return (uint32_t)crc32_z(crc32_z(0, NULL, 0), bytes, n);
}

uint64_t exk_store_hash(const char *text, size_t length)
{
    unsigned char hash[16] = {0};
    if (sodium_init() < 0) {
        return 0;
    }
    crypto_generichash(hash, sizeof hash, (const unsigned char *)text, length, NULL, 0);
    return get(hash, 8);
}

exk_store_err exk_store_alloc(exk_store *store, size_t n_samples)
{
    *store = (exk_store){.iteration = 1, .n_samples = n_samples};
    double *block = n_samples > 0 && n_samples <= SAMPLES_MAX
                        ? calloc(n_samples * EXK_N_AXES, sizeof *block)
                        : NULL;
    if (block == NULL) {
        return EXK_STORE_IO;
    }
    for (size_t i = 0; i < EXK_N_AXES; i++) {
        store->u_rad[i] = block + i * n_samples;
    }
    return EXK_STORE_OK;
}

void exk_store_free(exk_store *store)
{
    free(store->u_rad[0]);
    *store = (exk_store){.n_samples = 0};
}

static size_t file_bytes(size_t n_samples)
{
    return HEADER_BYTES + n_samples * EXK_N_AXES * 8 + CRC_BYTES;
}

static void encode(const exk_store *store, unsigned char *bytes)
{
    memcpy(bytes, magic, sizeof magic);
    put(bytes + 8, VERSION, 4);
    put(bytes + 12, HEADER_BYTES, 4);
    put(bytes + 16, store->job_hash, 8);
    put_f64(bytes + 24, store->dt_s);
    put(bytes + 32, store->iteration, 4);
    put(bytes + 36, EXK_N_AXES, 4);
    put(bytes + 40, store->n_samples, 8);
    unsigned char *at = bytes + HEADER_BYTES;
    for (int i = 0; i < EXK_N_AXES; i++) {
        for (size_t k = 0; k < store->n_samples; k++, at += 8) {
            put_f64(at, store->u_rad[i][k]);
        }
    }
    put(at, crc_of(bytes, (size_t)(at - bytes)), CRC_BYTES);
}

static exk_store_err corrupt(char *why, size_t why_size, const char *path, const char *what)
{
    snprintf(why, why_size, "%s: damaged ILC store: %s", path, what);
    return EXK_STORE_CORRUPT;
}

static exk_store_err check_frame(const char *path, const unsigned char *bytes, size_t n_bytes,
                                 char *why, size_t why_size)
{
    if (n_bytes == 0) { /* nobody's work: may be replaced */
        return corrupt(why, why_size, path, "it is empty");
    }
    if (n_bytes < sizeof magic || memcmp(bytes, magic, sizeof magic) != 0) {
        snprintf(why, why_size, "%s: not an ILC store (no EXKILC at its start)", path);
        return EXK_STORE_NOT_OURS;
    }
    if (n_bytes < HEADER_BYTES + CRC_BYTES) {
        return corrupt(why, why_size, path, "it ends inside its header");
    }
    const uint64_t stored = get(bytes + n_bytes - CRC_BYTES, CRC_BYTES);
    const uint32_t found = crc_of(bytes, n_bytes - CRC_BYTES);
    if (stored != found) {
        char text[96];
        snprintf(text, sizeof text, "CRC-32 is %08" PRIx32 ", its end says %08" PRIx64, found,
                 stored);
        return corrupt(why, why_size, path, text);
    }
    return EXK_STORE_OK;
}

static exk_store_err check_header(const char *path, const unsigned char *bytes, size_t n_bytes,
                                  char *why, size_t why_size)
{
    if (get(bytes + 8, 4) != VERSION) {
        snprintf(why, why_size, "%s: ILC store of format version %" PRIu64 "; this is %d", path,
                 get(bytes + 8, 4), VERSION);
        return EXK_STORE_NOT_OURS;
    }
    const uint64_t n_samples = get(bytes + 40, 8);
    if (get(bytes + 12, 4) != HEADER_BYTES || get(bytes + 36, 4) != EXK_N_AXES ||
        n_samples == 0 || n_samples > SAMPLES_MAX || file_bytes(n_samples) != n_bytes) {
        return corrupt(why, why_size, path, "its length does not fit its header");
    }
    return EXK_STORE_OK;
}

static bool decode(const unsigned char *bytes, exk_store *store)
{
    if (exk_store_alloc(store, (size_t)get(bytes + 40, 8)) != EXK_STORE_OK) {
        return false;
    }
    store->job_hash = get(bytes + 16, 8);
    store->dt_s = get_f64(bytes + 24);
    store->iteration = (uint32_t)get(bytes + 32, 4);
    const unsigned char *at = bytes + HEADER_BYTES;
    bool finite = isfinite(store->dt_s);
    for (int i = 0; i < EXK_N_AXES; i++) {
        for (size_t k = 0; k < store->n_samples; k++, at += 8) {
            store->u_rad[i][k] = get_f64(at);
            finite = finite && isfinite(store->u_rad[i][k]);
        }
    }
    return finite;
}

static exk_store_err read_bytes(const char *path, const unsigned char *bytes, size_t n_bytes,
                                exk_store *store, char *why, size_t why_size)
{
    exk_store_err err = check_frame(path, bytes, n_bytes, why, why_size);
    if (err == EXK_STORE_OK) {
        err = check_header(path, bytes, n_bytes, why, why_size);
    }
    if (err == EXK_STORE_OK && !decode(bytes, store)) {
        exk_store_free(store);
        err = corrupt(why, why_size, path, "a value is not finite, or memory ran out");
    }
    return err;
}

static exk_store_err load_one(const store_os *os, const char *path, exk_store *store, char *why,
                              size_t why_size)
{
    *store = (exk_store){.n_samples = 0};
    size_t n_bytes = 0;
    unsigned char *bytes = store_file_read(os, path, &n_bytes, why, why_size);
    if (bytes == NULL) {
        return EXK_STORE_IO;
    }
    const exk_store_err err = read_bytes(path, bytes, n_bytes, store, why, why_size);
    free(bytes);
    return err;
}

static void add(char *why, size_t why_size, const char *text)
{
    const size_t used = strlen(why);
    snprintf(why + used, why_size - used, "%s", text);
}

/* path is not good, and why says so: the previous generation, where there is one that is. */
static exk_store_err load_previous(const store_os *os, const char *path, exk_store_err err,
                                   exk_store *store, char *why, size_t why_size)
{
    char previous[PATH_MAX];
    char why_not[PATH_MAX + 256];
    const bool there =
        store_file_previous(path, previous, sizeof previous) && store_file_exists(os, previous);
    if (there && load_one(os, previous, store, why_not, sizeof why_not) == EXK_STORE_OK) {
        store->is_previous = true;
        add(why, why_size, "; its previous generation is used: ");
        add(why, why_size, previous);
        return EXK_STORE_OK;
    }
    if (there) {
        add(why, why_size, "; its previous generation is no better: ");
        add(why, why_size, why_not);
    }
    if (err == EXK_STORE_CORRUPT) {
        add(why, why_size, "; train again or restore a copy of the file");
    }
    return err;
}

exk_store_err store_load_on(const store_os *os, const char *path, exk_store *store, char *why,
                            size_t why_size)
{
    const exk_store_err err = load_one(os, path, store, why, why_size);
    return err == EXK_STORE_OK ? err : load_previous(os, path, err, store, why, why_size);
}

exk_store_err exk_store_load(const char *path, exk_store *store, char *why, size_t why_size)
{
    return store_load_on(store_os_posix(), path, store, why, why_size);
}

/* What is there now: EXK_STORE_OK is worth keeping; what is not ours stays untouched. */
static exk_store_err look_at(const store_os *os, const char *path, char *why, size_t why_size)
{
    exk_store old;
    const exk_store_err err = load_one(os, path, &old, why, why_size);
    if (err == EXK_STORE_OK) {
        exk_store_free(&old);
    }
    return err;
}

static exk_store_err replace(const store_os *os, const char *path, store_bytes fresh, char *why,
                             size_t why_size)
{
    exk_store_err now = EXK_STORE_CORRUPT;
    if (store_file_exists(os, path)) {
        now = look_at(os, path, why, why_size);
    }
    if (now == EXK_STORE_NOT_OURS || now == EXK_STORE_IO) {
        snprintf(why, why_size,
                 "%s: exists and is not an ILC store: not overwritten; choose another name",
                 path);
        return EXK_STORE_NOT_OURS;
    }
    return store_file_replace(os, path, fresh, now == EXK_STORE_OK, why, why_size);
}

exk_store_err store_save_on(const store_os *os, const char *path, const exk_store *store,
                            char *why, size_t why_size)
{
    const size_t n_bytes = file_bytes(store->n_samples);
    unsigned char *bytes = malloc(n_bytes);
    if (bytes == NULL) {
        snprintf(why, why_size, "%s: out of memory for %zu bytes; nothing was written", path,
                 n_bytes);
        return EXK_STORE_IO;
    }
    encode(store, bytes);
    const exk_store_err err = replace(os, path, (store_bytes){bytes, n_bytes}, why, why_size);
    free(bytes);
    return err;
}

exk_store_err exk_store_save(const char *path, const exk_store *store, char *why,
                             size_t why_size)
{
    int lock = -1;
    if (!store_os_lock(path, &lock)) {
        snprintf(why, why_size,
                 "%s: another process has been saving a store in this folder for 10 s; nothing "
                 "was written; end it, then save again",
                 path);
        return EXK_STORE_IO;
    }
    const exk_store_err err = store_save_on(store_os_posix(), path, store, why, why_size);
    store_os_unlock(lock);
    return err;
}

exk_store_err exk_store_match(const exk_store *store, uint64_t job_hash, double dt_s,
                              size_t n_samples, char *why, size_t why_size)
{
    if (store->job_hash != job_hash) {
        snprintf(why, why_size,
                 "ILC store of another job: its hash is %016" PRIx64
                 ", this profile's %016" PRIx64
                 "; train a store for this [machine], [kinematics], [job] and rate",
                 store->job_hash, job_hash);
        return EXK_STORE_OTHER_JOB;
    }
    if (store->dt_s != dt_s || store->n_samples != n_samples) {
        snprintf(why, why_size,
                 "ILC store of %zu samples of %g s; this job has %zu samples of %g s",
                 store->n_samples, store->dt_s, n_samples, dt_s);
        return EXK_STORE_OTHER_JOB;
    }
    return EXK_STORE_OK;
}
