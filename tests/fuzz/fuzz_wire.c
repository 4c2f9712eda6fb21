/* A message of any bytes on each channel: the first byte chooses the type. What is decoded can be encoded,
 * and decodes again to the same bytes. */
#include <string.h>

#include "exk/command.h"
#include "exk/wire.h"
#include "fuzz.h"

enum { ROOM = 1 << 16 };
static unsigned char first[ROOM], second[ROOM];

static void same(int n_first, int n_second)
{
    PROMISE(n_first > 0 && n_first == n_second);
    PROMISE(memcmp(first, second, (size_t)n_first) == 0);
}

#define ROUND(type)                                                                            \
    static void round_##type(const uint8_t *data, size_t size)                                 \
    {                                                                                          \
        exk_wire_##type a, b;                                                                  \
        if (exk_wire_##type##_decode(data, size, &a)) {                                        \
            const int n = exk_wire_##type##_encode(&a, first, sizeof first);                   \
            PROMISE(n > 0 && exk_wire_##type##_decode(first, (size_t)n, &b));                  \
            same(n, exk_wire_##type##_encode(&b, second, sizeof second));                      \
        }                                                                                      \
    }

ROUND(pose)
ROUND(hole)
ROUND(status)
ROUND(drive)
ROUND(sensor)
ROUND(command)

static int encode_job(const exk_wire_job *job, unsigned char *out)
{
    const exk_wire_scratch scratch = {
        .ids = malloc((job->n_holes + 1) * sizeof(int32_t)),
        .rows = malloc((2 * job->n_holes + 1) * sizeof(double *)),
    };
    PROMISE(scratch.ids != NULL && scratch.rows != NULL);
    const int n = exk_wire_job_encode(job, &scratch, out, ROOM);
    free(scratch.ids);
    free(scratch.rows);
    return n;
}

static void round_job(const uint8_t *data, size_t size)
{
    exk_wire_job a, b;
    if (!exk_wire_job_decode(data, size, &a)) {
        return;
    }
    if (exk_wire_job_bytes(&a) <= ROOM) {
        const int n = encode_job(&a, first);
        PROMISE(n > 0 && exk_wire_job_decode(first, (size_t)n, &b));
        same(n, encode_job(&b, second));
        exk_wire_job_free(&b);
    }
    exk_wire_job_free(&a);
}

/* Nobody without the key is obeyed. */
static void no_command(const uint8_t *data, size_t size)
{
    const exk_key_secret key = {{7, 1, 2, 3}};
    exk_gate gate;
    exk_command command;
    exk_gate_init(&gate, &key, 42, 1000000);
    PROMISE(!exk_gate_pass(&gate, data, size, 1000000, &command));
    PROMISE(gate.counts.n_taken == 0 && gate.last_seq == -1);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static void (*const rounds[])(const uint8_t *, size_t) = {
        round_pose,  round_hole,   round_status,  round_job,
        round_drive, round_sensor, round_command, no_command};
    if (size > 0) {
        rounds[data[0] % (sizeof rounds / sizeof rounds[0])](data + 1, size - 1);
    }
    return 0;
}
