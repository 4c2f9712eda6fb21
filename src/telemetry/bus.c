#define _POSIX_C_SOURCE 200809L
#include "exk/bus.h"

#include <errno.h>
#include <lcm/lcm.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { URL_MAX = 1024, BATCH = 4096 };

struct exk_bus {
    lcm_t *lcm;
    exk_bus_fn fn;
    void *ctx;
};

static bool is_udpm(const char *url)
{
    return strncmp(url, "udpm://", 7) == 0;
}

static bool is_tcpq(const char *url)
{
    return strncmp(url, "tcpq://", 7) == 0;
}

/* LCM takes a tcpq URL whose server is not there, and aborts in its first wait. */
static bool is_connected(lcm_t *lcm, const char *url)
{
    return !is_tcpq(url) || lcm_get_fileno(lcm) >= 0;
}

static void with_buffer(const char *url, char *out, size_t size)
{
    if (!is_udpm(url) || strstr(url, "recv_buf_size") != NULL) {
        snprintf(out, size, "%s", url);
        return;
    }
    snprintf(out, size, "%s%srecv_buf_size=%d", url, strchr(url, '?') != NULL ? "&" : "?",
             (int)EXK_BUS_BUFFER_BYTES);
}

exk_bus *exk_bus_open(const char *url, bool receive, char *why, size_t why_size)
{
    char full[URL_MAX];
    if (!exk_bus_route(url, why, why_size)) {
        return NULL;
    }
    exk_bus *bus = calloc(1, sizeof *bus);
    if (bus == NULL) {
        snprintf(why, why_size, "no memory for the bus");
        return NULL;
    }
    if (receive) {
        with_buffer(url, full, sizeof full);
    } else {
        snprintf(full, sizeof full, "%s", url);
    }
    bus->lcm = lcm_create(full);
    if (bus->lcm == NULL || !is_connected(bus->lcm, url)) {
        snprintf(why, why_size,
                 "%s: LCM cannot open this URL%s; use one like udpm://239.255.76.67:7667?ttl=0 "
                 "(exk-doctor says more)",
                 url, is_tcpq(url) ? ": no lcm-tcpq-server answers there" : "");
        exk_bus_close(bus);
        return NULL;
    }
    return bus;
}

void exk_bus_close(exk_bus *bus)
{
    if (bus != NULL && bus->lcm != NULL) {
        lcm_destroy(bus->lcm);
    }
    free(bus);
}

bool exk_bus_send(exk_bus *bus, const char *channel, const void *data, size_t bytes)
{
    return lcm_publish(bus->lcm, channel, data, (unsigned)bytes) == 0;
}

static void deliver(const lcm_recv_buf_t *buffer, const char *channel, void *ctx)
{
    const exk_bus *bus = ctx;
    bus->fn(bus->ctx, channel, buffer->data, buffer->data_size, buffer->recv_utime);
}

bool exk_bus_listen(exk_bus *bus, const char *pattern, exk_bus_fn fn, void *ctx, char *why,
                    size_t why_size)
{
    bus->fn = fn;
    bus->ctx = ctx;
    lcm_subscription_t *subscription = lcm_subscribe(bus->lcm, pattern, deliver, bus);
    if (subscription == NULL) {
        snprintf(why, why_size, "LCM cannot subscribe to %s: exk-doctor finds out why",
                 pattern);
        return false;
    }
    lcm_subscription_set_queue_capacity(subscription, 0); /* no bound */
    return true;
}

int exk_bus_wait(exk_bus *bus, int timeout_ms)
{
    int n = 0;
    if (lcm_get_fileno(bus->lcm) < 0) {
        return -1; /* a tcpq server that went: LCM would abort */
    }
    errno = 0;
    int got = lcm_handle_timeout(bus->lcm, timeout_ms);
    while (got > 0 && ++n < BATCH) {
        got = lcm_handle_timeout(bus->lcm, 0);
    }
    if (got < 0 && errno == EINTR) {
        got = 0;
    }
    return n > 0 ? n : got;
}
