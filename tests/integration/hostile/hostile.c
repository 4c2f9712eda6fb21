/* hostile WHAT URL N [RUN_ID]: what a bus must survive.
 *
 *  garbage   N datagrams: random bytes; LCM's magic numbers before random bytes; whole LCM headers of our
 *            channels with random bodies; fragments that lie about their sizes.
 *  commands  N well-formed commands nobody allowed: no hash, a random hash, a hash by another key, another
 *            run, and, once one was heard on the bus, that one again. RUN_ID: the run to aim at.
 *  flood     N messages of 64 bytes on EXK_COMMAND and as many on EXK_FLOOD, as fast as they go.
 *
 *  At the end: what was sent, and how many of the commands were replays. */
#define _DEFAULT_SOURCE
#include <arpa/inet.h>
#include <inttypes.h>
#include <netinet/in.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "exk/bus.h"
#include "exk/command.h"
#include "exk/realtime.h"

enum { DATAGRAM_MAX = 1400, PAUSE_EVERY = 50, HEAR_MS = 400 };

static unsigned char heard[EXK_WIRE_COMMAND_MAX];
static size_t n_heard;

static uint64_t random_bits(void)
{
    static uint64_t x = 0x9e3779b97f4a7c15U;
    x ^= x << 13;
    x ^= x >> 7;
    x ^= x << 17;
    return x;
}

static void fill(unsigned char *bytes, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        bytes[i] = (unsigned char)(random_bits() >> 32);
    }
}

static void nap_us(long us)
{
    const struct timespec pause = {.tv_nsec = us * 1000};
    nanosleep(&pause, NULL);
}

static int socket_of(const char *url, struct sockaddr_in *to)
{
    char group[64];
    unsigned port = 0;
    const unsigned char ttl = 0;
    *to = (struct sockaddr_in){.sin_family = AF_INET};
    if (sscanf(url, "udpm://%63[0-9.]:%u", group, &port) != 2 ||
        inet_pton(AF_INET, group, &to->sin_addr) != 1) {
        return -1;
    }
    to->sin_port = htons((uint16_t)port);
    const int fd = socket(AF_INET, SOCK_DGRAM, 0);
    setsockopt(fd, IPPROTO_IP, IP_MULTICAST_TTL, &ttl, sizeof ttl);
    return fd;
}

/* LC02: a whole message, LC03: a fragment; then a number, and for LC02 the channel's name. */
static size_t make_garbage(long i, unsigned char *bytes)
{
    static const char *const channels[] = {"EXK_COMMAND", "EXK_SENSOR", "EXK_STATUS",
                                           "EXK_POSE"};
    const size_t n = random_bits() % DATAGRAM_MAX;
    fill(bytes, DATAGRAM_MAX);
    if (i % 4 != 0) {
        memcpy(bytes, i % 4 == 3 ? "LC03" : "LC02", 4);
    }
    if (i % 4 == 2) {
        const char *channel = channels[random_bits() % 4];
        memcpy(bytes + 8, channel, strlen(channel) + 1);
    }
    return n;
}

static int send_garbage(const char *url, long n)
{
    unsigned char bytes[DATAGRAM_MAX];
    struct sockaddr_in to;
    const int fd = socket_of(url, &to);
    long n_sent = 0;
    for (long i = 0; fd >= 0 && i < n; i++) {
        const size_t size = make_garbage(i, bytes);
        n_sent += sendto(fd, bytes, size, 0, (const struct sockaddr *)&to, sizeof to) >= 0;
        if (i % PAUSE_EVERY == 0) {
            nap_us(500); /* so that they arrive: a full buffer would spare the reader */
        }
    }
    printf("sent %ld\n", n_sent);
    return n_sent == n ? 0 : 1;
}

static void hear(void *ctx, const char *channel, const void *data, size_t bytes,
                 int64_t received_us)
{
    (void)ctx;
    (void)channel;
    (void)received_us;
    if (n_heard == 0 && bytes <= sizeof heard) {
        memcpy(heard, data, bytes);
        n_heard = bytes;
    }
}

static size_t make_command(long i, int64_t run_id, const exk_key_secret *other,
                           unsigned char *buffer)
{
    exk_wire_command m = {.run_id = run_id,
                          .seq = exk_wall_us() + i,
                          .utime_us = exk_wall_us(),
                          .command = (int8_t)(1 + i % 4)};
    if (i % 5 == 1) {
        fill(m.mac, sizeof m.mac);
    } else if (i % 5 == 2) {
        exk_command_sign(&m, other);
    } else if (i % 5 == 3) {
        m.run_id++;
        exk_command_sign(&m, other);
    } else if (i % 5 == 4 && n_heard > 0) {
        memcpy(buffer, heard, n_heard);
        return n_heard;
    }
    return (size_t)exk_wire_command_encode(&m, buffer, EXK_WIRE_COMMAND_MAX);
}

static int send_commands(exk_bus *bus, long n, int64_t run_id)
{
    unsigned char buffer[EXK_WIRE_COMMAND_MAX];
    exk_key_secret other;
    long n_replays = 0;
    fill(other.bytes, sizeof other.bytes);
    puts("listening");
    fflush(stdout);
    for (int i = 0; i < 50 && n_heard == 0; i++) {
        exk_bus_wait(bus, HEAR_MS / 10);
    }
    for (long i = 0; i < n; i++) {
        const size_t bytes = make_command(i, run_id, &other, buffer);
        exk_bus_send(bus, EXK_CHANNEL_COMMAND, buffer, bytes);
        n_replays += i % 5 == 4 && n_heard > 0 ? 1 : 0;
        if (i % PAUSE_EVERY == 0) {
            nap_us(2000);
        }
    }
    printf("sent %ld\nreplays %ld\n", n, n_replays);
    return 0;
}

static int flood(exk_bus *bus, long n)
{
    unsigned char bytes[64];
    long n_sent = 0;
    fill(bytes, sizeof bytes);
    for (long i = 0; i < n; i++) {
        n_sent += exk_bus_send(bus, EXK_CHANNEL_COMMAND, bytes, sizeof bytes) ? 1 : 0;
        n_sent += exk_bus_send(bus, "EXK_FLOOD", bytes, sizeof bytes) ? 1 : 0;
    }
    printf("sent %ld\n", n_sent);
    return 0;
}

int main(int argc, char **argv)
{
    char why[512];
    const long n = argc >= 4 ? strtol(argv[3], NULL, 10) : 0;
    if (n <= 0) {
        fprintf(stderr, "hostile: WHAT URL N [RUN_ID] are wanted\n");
        return 2;
    }
    if (strcmp(argv[1], "garbage") == 0) {
        return send_garbage(argv[2], n);
    }
    const bool commands = strcmp(argv[1], "commands") == 0;
    exk_bus *bus = exk_bus_open(argv[2], commands, why, sizeof why);
    if (bus == NULL ||
        (commands && !exk_bus_listen(bus, EXK_CHANNEL_COMMAND, hear, NULL, why, sizeof why))) {
        fprintf(stderr, "hostile: %s\n", why);
        return 3;
    }
    return commands ? send_commands(bus, n, argc > 4 ? strtoll(argv[4], NULL, 10) : 0)
                    : flood(bus, n);
}
