#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <string.h>
#include <unistd.h>

#include "checks.h"
#include "exk/bus.h"
#include "now.h"

enum { N_ROUND_TRIPS = 200, N_BURST = 2000, PAYLOAD_BYTES = 400, WAIT_MS = 20 };
static const double patience_s = 1.0; /* for the first message to come back */

/* A channel of this process; not EXK_..., so that no recorder takes it for a run. */
static void channel_name(char *out, size_t size)
{
    snprintf(out, size, "DOCTOR_%ld", (long)getpid());
}

static void count(void *ctx, const char *channel, const void *data, size_t bytes,
                  int64_t received_us)
{
    int *n = ctx;
    (void)channel;
    (void)data;
    (void)received_us;
    *n += bytes == PAYLOAD_BYTES;
}

typedef struct {
    exk_bus *sender;
    exk_bus *receiver;
    char channel[32];
    int n_received;
} bench;

/* Sends one message and waits for it; seconds, or -1 when none came. */
static double round_trip(bench *b)
{
    static const unsigned char payload[PAYLOAD_BYTES];
    const int before = b->n_received;
    const double begin = exk_now_s();
    exk_bus_send(b->sender, b->channel, payload, sizeof payload);
    while (b->n_received == before && exk_now_s() - begin < patience_s) {
        exk_bus_wait(b->receiver, WAIT_MS);
    }
    return b->n_received > before ? exk_now_s() - begin : -1.0;
}

static int burst(bench *b)
{
    static const unsigned char payload[PAYLOAD_BYTES];
    const int before = b->n_received;
    for (int i = 0; i < N_BURST; i++) {
        exk_bus_send(b->sender, b->channel, payload, sizeof payload);
    }
    while (b->n_received - before < N_BURST && exk_bus_wait(b->receiver, 10 * WAIT_MS) > 0) {
    }
    return b->n_received - before;
}

static void measure(finding *f, bench *b)
{
    double sum_s = 0.0;
    for (int i = 0; i < N_ROUND_TRIPS; i++) {
        const double one_s = round_trip(b);
        if (one_s < 0.0) {
            snprintf(f->found, sizeof f->found,
                     "message %d of %d did not come back within %g s", i + 1, N_ROUND_TRIPS,
                     patience_s);
            finding_set(
                f, FINDING_FAIL,
                "is a firewall dropping multicast? let UDP to 224.0.0.0/4 through, or send "
                "it over the loopback: `ip route add 224.0.0.0/4 dev lo` as root");
            return;
        }
        sum_s += one_s;
    }
    const int n = burst(b);
    snprintf(f->found, sizeof f->found,
             "%d messages there and back, %.0f us each; %d of a burst of %d received",
             N_ROUND_TRIPS, 1e6 * sum_s / N_ROUND_TRIPS, n, N_BURST);
    if (n < N_BURST) {
        finding_set(f, FINDING_WARN,
                    "bursts lose messages here: see buffer, and use exk-loop --record "
                    "for evidence");
    }
}

static void check_messages(findings *all, const char *url)
{
    bench b = {.n_received = 0};
    finding *f = finding_add(all, "messages");
    channel_name(b.channel, sizeof b.channel);
    b.receiver = exk_bus_open(url, true, f->found, sizeof f->found);
    b.sender = b.receiver != NULL ? exk_bus_open(url, false, f->found, sizeof f->found) : NULL;
    if (b.sender != NULL && exk_bus_listen(b.receiver, b.channel, count, &b.n_received,
                                           f->found, sizeof f->found)) {
        measure(f, &b);
    } else {
        finding_set(f, FINDING_FAIL, "give --url a URL like udpm://239.255.76.67:7667?ttl=0");
    }
    exk_bus_close(b.sender);
    exk_bus_close(b.receiver);
}

static bool check_route(findings *all, const char *url)
{
    finding *f = finding_add(all, "route");
    if (exk_bus_route(url, f->found, sizeof f->found)) {
        snprintf(f->found, sizeof f->found, "%s can be sent to", url);
        return true;
    }
    char *remedy = strstr(f->found, ": run `"); /* said in its own place below */
    if (remedy != NULL) {
        *remedy = '\0';
    }
    finding_set(f, FINDING_FAIL,
                "`ip route add 224.0.0.0/4 dev lo` as root (lasts until the next start)");
    return false;
}

static void check_buffer(findings *all)
{
    finding *f = finding_add(all, "buffer");
    const int64_t granted = exk_bus_granted_bytes();
    snprintf(f->found, sizeof f->found,
             "a receive buffer of %" PRId64 " bytes is granted of %d", granted,
             EXK_BUS_BUFFER_BYTES);
    if (granted < EXK_BUS_BUFFER_BYTES) {
        finding_set(f, FINDING_WARN,
                    "`sysctl -w net.core.rmem_max=4194304` as root; for good: the line "
                    "net.core.rmem_max=4194304 in /etc/sysctl.d/60-exk.conf");
    }
}

static void check_ttl(findings *all, const char *url)
{
    finding *f = finding_add(all, "reach");
    const int ttl = exk_bus_ttl(url);
    if (ttl <= 0) {
        snprintf(f->found, sizeof f->found, "ttl=0: messages stay on this host");
        return;
    }
    snprintf(f->found, sizeof f->found, "ttl=%d: every host %s sees the machine's messages",
             ttl, ttl == 1 ? "on this network" : "within so many routers");
    finding_set(f, FINDING_WARN, "fine when meant; else put ttl=0 into the URL");
}

void check_bus(findings *all, const char *url)
{
    if (check_route(all, url)) {
        check_messages(all, url);
    }
    check_buffer(all);
    check_ttl(all, url);
}
