#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "exk/bus.h"

/* The group of udpm://GROUP:PORT?options. */
static void group_of(const char *url, char *group, size_t size)
{
    const char *begin = url + strlen("udpm://");
    const size_t n = strcspn(begin, ":?");
    snprintf(group, size, "%.*s", (int)n, begin);
}

/* connect on a datagram socket sends nothing: it only looks the route up. */
static bool route_to(struct in_addr address)
{
    const int fd = socket(AF_INET, SOCK_DGRAM, 0);
    struct sockaddr_in to = {.sin_family = AF_INET, .sin_port = htons(9), .sin_addr = address};
    const int result = fd >= 0 ? connect(fd, (struct sockaddr *)&to, sizeof to) : -1;
    const int error = errno;
    if (fd >= 0) {
        close(fd);
    }
    errno = error;
    return result == 0;
}

bool exk_bus_route(const char *url, char *why, size_t why_size)
{
    char group[64];
    struct in_addr address;
    if (!exk_bus_url_good(url, why, why_size)) {
        return false;
    }
    if (strncmp(url, "udpm://", 7) != 0) {
        return true;
    }
    group_of(url, group, sizeof group);
    if (inet_pton(AF_INET, group, &address) != 1 || !route_to(address)) {
        snprintf(
            why, why_size,
            "no route for multicast (%s: %s): run `ip route add 224.0.0.0/4 dev lo` as root, "
            "then again",
            group, strerror(errno));
        return false;
    }
    return true;
}

/* The kernel doubles what it grants, for its own bookkeeping; half of it is what was granted. */
int64_t exk_bus_granted_bytes(void)
{
    const int fd = socket(AF_INET, SOCK_DGRAM, 0);
    int bytes = EXK_BUS_BUFFER_BYTES;
    socklen_t size = sizeof bytes;
    if (fd < 0) {
        return 0;
    }
    setsockopt(fd, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
    if (getsockopt(fd, SOL_SOCKET, SO_RCVBUF, &bytes, &size) != 0) {
        bytes = 0;
    }
    close(fd);
    return bytes / 2;
}

int exk_bus_ttl(const char *url)
{
    const char *found = strstr(url, "ttl=");
    return found != NULL ? (int)strtol(found + 4, NULL, 10) : 0;
}
