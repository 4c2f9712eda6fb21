/* An ILC store of any bytes: refused with a reason, or finite and as long as it says. The first byte
 * says whether the CRC is put right, so that what is behind it is reached too. */
#include <math.h>
#include <string.h>
#include <zlib.h>

#include "exk/store.h"
#include "fuzz.h"
#include "memory_file.h"

enum { CRC_BYTES = 4 };

static void put_crc_right(uint8_t *bytes, size_t n)
{
    const uLong crc = crc32_z(crc32_z(0, NULL, 0), bytes, n - CRC_BYTES);
    for (size_t i = 0; i < CRC_BYTES; i++) {
        bytes[n - CRC_BYTES + i] = (uint8_t)(crc >> (8 * i));
    }
}

static void good_store(const exk_store *store, size_t size)
{
    PROMISE(store->n_samples > 0 && !store->is_previous);
    PROMISE(store->n_samples * EXK_N_AXES * sizeof(double) < size);
    PROMISE(isfinite(store->dt_s));
    for (int i = 0; i < EXK_N_AXES; i++) {
        for (size_t k = 0; k < store->n_samples; k++) {
            PROMISE(isfinite(store->u_rad[i][k]));
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    exk_store store;
    char why[512] = "";
    if (size < 1) {
        return 0;
    }
    uint8_t *bytes = malloc(size);
    PROMISE(bytes != NULL);
    memcpy(bytes, data, size);
    if ((bytes[0] & 1) != 0 && size > 1 + CRC_BYTES) {
        put_crc_right(bytes + 1, size - 1);
    }
    if (exk_store_load(memory_file(bytes + 1, size - 1), &store, why, sizeof why) ==
        EXK_STORE_OK) {
        good_store(&store, size);
        exk_store_free(&store);
    } else {
        PROMISE(why[0] != '\0' && memchr(why, '\0', sizeof why) != NULL);
    }
    free(bytes);
    return 0;
}
