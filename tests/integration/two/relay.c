/* relay URL_LOOP URL_TWIN WHAT N: carries EXK_DRIVE one way and EXK_SENSOR the other, and does WHAT to every
 * N-th answer of a tick: drop, repeat, swap (with the next), late (three answers later), foreign (as
 * another run, before the true one), garbage (a cut one, before the true one). At the end it says how often. */
#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exk/bus.h"
#include "exk/wire.h"

enum { KEPT_MAX = 128, BEHIND = 3 };

typedef struct {
    exk_bus *to_loop;
    exk_bus *to_twin;
    const char *what;
    int64_t every;
    int64_t n_answers;
    int64_t n_done;
    unsigned char kept[KEPT_MAX];
    size_t n_kept;
    int64_t give_back; /* answers until the kept one goes out */
} relay;

static volatile sig_atomic_t stop;

static void on_signal(int number)
{
    stop = number;
}

static void on_drive(void *ctx, const char *channel, const void *data, size_t bytes,
                     int64_t received_us)
{
    const relay *r = ctx;
    (void)received_us;
    exk_bus_send(r->to_twin, channel, data, bytes);
}

static void keep(relay *r, const void *data, size_t bytes, int64_t for_answers)
{
    memcpy(r->kept, data, bytes);
    r->n_kept = bytes;
    r->give_back = for_answers;
}

static void send_foreign(relay *r, const void *data, size_t bytes)
{
    exk_wire_sensor m;
    unsigned char buffer[EXK_WIRE_SENSOR_MAX];
    if (exk_wire_sensor_decode(data, bytes, &m)) {
        m.stamp.run_id ^= 1;
        m.reading.measured_rad[0] = 0.5;
        const int n = exk_wire_sensor_encode(&m, buffer, sizeof buffer);
        exk_bus_send(r->to_loop, EXK_CHANNEL_SENSOR, buffer, (size_t)n);
    }
}

/* True: the answer itself goes on. */
static bool harm(relay *r, const void *data, size_t bytes)
{
    r->n_done++;
    if (strcmp(r->what, "drop") == 0) {
        return false;
    }
    if (strcmp(r->what, "swap") == 0 || strcmp(r->what, "late") == 0) {
        keep(r, data, bytes, strcmp(r->what, "swap") == 0 ? 1 : BEHIND);
        return false;
    }
    if (strcmp(r->what, "repeat") == 0) {
        exk_bus_send(r->to_loop, EXK_CHANNEL_SENSOR, data, bytes);
    } else if (strcmp(r->what, "foreign") == 0) {
        send_foreign(r, data, bytes);
    } else {
        exk_bus_send(r->to_loop, EXK_CHANNEL_SENSOR, data, bytes - 1);
    }
    return true;
}

static void on_answer(void *ctx, const char *channel, const void *data, size_t bytes,
                      int64_t received_us)
{
    relay *r = ctx;
    exk_wire_sensor m;
    (void)received_us;
    const bool of_tick = exk_wire_sensor_decode(data, bytes, &m) && m.stamp.k >= 0;
    r->n_answers += of_tick ? 1 : 0;
    if (!of_tick || r->n_answers % r->every != 0 || bytes > KEPT_MAX || harm(r, data, bytes)) {
        exk_bus_send(r->to_loop, channel, data, bytes);
        if (r->n_kept > 0 && --r->give_back == 0) {
            exk_bus_send(r->to_loop, channel, r->kept, r->n_kept);
            r->n_kept = 0;
        }
    }
}

static int carry(relay *r, const char *url_loop, const char *url_twin)
{
    char why[512];
    r->to_loop = exk_bus_open(url_loop, true, why, sizeof why);
    r->to_twin = exk_bus_open(url_twin, true, why, sizeof why);
    if (r->to_loop == NULL || r->to_twin == NULL ||
        !exk_bus_listen(r->to_loop, EXK_CHANNEL_DRIVE, on_drive, r, why, sizeof why) ||
        !exk_bus_listen(r->to_twin, EXK_CHANNEL_SENSOR, on_answer, r, why, sizeof why)) {
        fprintf(stderr, "relay: %s\n", why);
        return 3;
    }
    puts("ready");
    fflush(stdout);
    while (stop == 0) {
        exk_bus_wait(r->to_loop, 1);
        exk_bus_wait(r->to_twin, 1);
    }
    printf("%s %" PRId64 "\n", r->what, r->n_done);
    return 0;
}

int main(int argc, char **argv)
{
    static relay r;
    struct sigaction action = {.sa_handler = on_signal};
    sigemptyset(&action.sa_mask);
    sigaction(SIGTERM, &action, NULL);
    if (argc != 5) {
        fprintf(stderr, "relay: URL_LOOP URL_TWIN WHAT N are wanted\n");
        return 2;
    }
    r.what = argv[3];
    r.every = strtol(argv[4], NULL, 10);
    return r.every > 0 ? carry(&r, argv[1], argv[2]) : 2;
}
