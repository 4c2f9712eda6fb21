#define _GNU_SOURCE
#include "exk/solo.h"

#include <errno.h>
#include <inttypes.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "exk/bus.h"
#include "exk/realtime.h"
#include "exk/wire.h"

enum { LCM_PORT = 7667, WHAT_MAX = 160 };
static const int64_t ns_per_ms = 1000000;

static bool is_shared(const char *url)
{
    return strncmp(url, "udpm://", 7) == 0 || strncmp(url, "tcpq://", 7) == 0;
}

static long port_of(const char *url)
{
    const char *begin = url + strlen("udpm://");
    const char *colon = begin + strcspn(begin, ":?");
    return *colon == ':' ? strtol(colon + 1, NULL, 10) : LCM_PORT;
}

static socklen_t name_of(const char *role, const char *url, struct sockaddr_un *name)
{
    const bool udp = strncmp(url, "udpm://", 7) == 0;
    *name = (struct sockaddr_un){.sun_family = AF_UNIX};
    const size_t size = sizeof name->sun_path - 1;
    const int n = udp ? snprintf(name->sun_path + 1, size, "exk/%s/udp:%ld", role, port_of(url))
                      : snprintf(name->sun_path + 1, size, "exk/%s/%s", role, url);
    const size_t used = (size_t)n < size ? (size_t)n : size - 1;
    return (socklen_t)(offsetof(struct sockaddr_un, sun_path) + 1 + used);
}

/* Who holds a name: its process, 0 when it does not say. Each asking stays in the holder's queue, which
 * nobody empties: it has room for some thousands. */
static long holder_of(const struct sockaddr_un *name, socklen_t length)
{
    struct ucred who = {0};
    socklen_t size = sizeof who;
    const int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (fd >= 0 && connect(fd, (const struct sockaddr *)name, length) == 0) {
        getsockopt(fd, SOL_SOCKET, SO_PEERCRED, &who, &size);
    }
    if (fd >= 0) {
        close(fd);
    }
    return (long)who.pid;
}

static void say_holder(const char *role, const char *url, long process, char *why,
                       size_t why_size)
{
    char who[32] = "";
    if (process > 0) {
        snprintf(who, sizeof who, ": process %ld", process);
    }
    snprintf(why, why_size,
             "another %s is on %s%s; end it first, or give this one a bus of its own (--url "
             "with another port)",
             role, url, who);
}

bool exk_solo_claim(const char *role, const char *url, char *why, size_t why_size)
{
    struct sockaddr_un name;
    if (!is_shared(url)) {
        return true;
    }
    const socklen_t length = name_of(role, url, &name);
    const int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (fd < 0) {
        return true; /* no such sockets here: listening remains */
    }
    if (bind(fd, (struct sockaddr *)&name, length) == 0 && listen(fd, SOMAXCONN) == 0) {
        return true; /* kept open until the process ends */
    }
    const bool taken = errno == EADDRINUSE;
    close(fd);
    if (taken) {
        say_holder(role, url, holder_of(&name, length), why, why_size);
    }
    return !taken;
}

static void hear(void *ctx, const char *channel, const void *data, size_t bytes,
                 int64_t received_us)
{
    char *what = ctx;
    exk_wire_status status;
    exk_wire_pose pose;
    exk_wire_drive drive;
    (void)received_us;
    if (strcmp(channel, EXK_CHANNEL_STATUS) == 0 &&
        exk_wire_status_decode(data, bytes, &status) && !status.last) {
        snprintf(what, WHAT_MAX, "run %" PRId64 ", state %s, tick %" PRId64,
                 status.stamp.run_id, exk_state_name(status.state), status.stamp.k);
    } else if (what[0] == '\0' && exk_wire_pose_decode(data, bytes, &pose)) {
        snprintf(what, WHAT_MAX, "run %" PRId64 ", tick %" PRId64, pose.run_id, pose.sample.k);
    } else if (what[0] == '\0' && exk_wire_drive_decode(data, bytes, &drive) &&
               drive.kind != EXK_DRIVE_BYE) {
        snprintf(what, WHAT_MAX, "run %" PRId64 " drives the machine", drive.stamp.run_id);
    }
}

bool exk_solo_listen(const char *url, int timeout_ms, char *why, size_t why_size)
{
    char what[WHAT_MAX] = "";
    char unused[512];
    if (!is_shared(url)) {
        return true;
    }
    exk_bus *bus = exk_bus_open(url, true, unused, sizeof unused);
    if (bus == NULL ||
        !exk_bus_listen(bus, "EXK_(STATUS|POSE|DRIVE)", hear, what, unused, sizeof unused)) {
        exk_bus_close(bus);
        return true;
    }
    const exk_clock clock = exk_clock_monotonic();
    const int64_t until_ns = clock.now_ns(clock.ctx) + (int64_t)timeout_ms * ns_per_ms;
    int64_t left_ns = until_ns - clock.now_ns(clock.ctx);
    while (what[0] == '\0' && left_ns > 0 &&
           exk_bus_wait(bus, (int)(left_ns / ns_per_ms) + 1) >= 0) {
        left_ns = until_ns - clock.now_ns(clock.ctx);
    }
    exk_bus_close(bus);
    if (what[0] != '\0') {
        snprintf(why, why_size,
                 "another controller speaks on %s: %s; end it first, or give this one a bus of "
                 "its own (--url with another port)",
                 url, what);
    }
    return what[0] == '\0';
}
