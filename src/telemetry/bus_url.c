#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exk/bus.h"

enum { PORT_MAX = 65535, TTL_MAX = 255 };

/* What LCM has, in one version or another; which of them it was built with it says itself. */
static const char *const kinds[] = {"udpm", "tcpq", "memq", "file", "mpudpm"};

static bool wrong(char *why, size_t why_size, const char *url, const char *what)
{
    snprintf(why, why_size,
             "LCM URL \"%s\": %s; one that works on every host is "
             "udpm://239.255.76.67:7667?ttl=0",
             url, what);
    return false;
}

static bool is_kind(const char *url, size_t length)
{
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        if (strlen(kinds[i]) == length && strncmp(url, kinds[i], length) == 0) {
            return true;
        }
    }
    return false;
}

/* text, up to one of ends, is a whole number from least to most. */
static bool is_number(const char *text, const char *ends, long least, long most)
{
    char *end = NULL;
    const size_t length = strcspn(text, ends);
    const long value = strtol(text, &end, 10);
    return length > 0 && text[0] >= '0' && text[0] <= '9' && end == text + length &&
           value >= least && value <= most;
}

static bool has_group(const char *begin)
{
    char group[64];
    struct in_addr address;
    const size_t n = strcspn(begin, ":?");
    snprintf(group, sizeof group, "%.*s", (int)n, begin);
    return n < sizeof group && inet_pton(AF_INET, group, &address) == 1 &&
           ntohl(address.s_addr) >> 28 == 0xE;
}

static bool check_options(const char *url, char *why, size_t why_size)
{
    const char *at = strchr(url, '?');
    while (at != NULL) {
        at++;
        if (strncmp(at, "ttl=", 4) == 0 && !is_number(at + 4, "&", 0, TTL_MAX)) {
            return wrong(why, why_size, url, "ttl is a whole number, 0 (this host) to 255");
        }
        if (strncmp(at, "recv_buf_size=", 14) == 0 &&
            !is_number(at + 14, "&", 1, 1024L * 1024 * 1024)) {
            return wrong(why, why_size, url, "recv_buf_size is a number of bytes, 1 to 2^30");
        }
        at = strchr(at, '&');
    }
    return true;
}

static bool check_udpm(const char *url, char *why, size_t why_size)
{
    const char *group = url + strlen("udpm://");
    const char *colon = group + strcspn(group, ":?");
    if (!has_group(group)) {
        return wrong(why, why_size, url,
                     "its group is not a multicast address (224.0.0.0 to 239.255.255.255)");
    }
    if (*colon != ':' || !is_number(colon + 1, "?", 1, PORT_MAX)) {
        return wrong(why, why_size, url, "a port, 1 to 65535, has to stand behind the group");
    }
    return check_options(url, why, why_size);
}

bool exk_bus_url_good(const char *url, char *why, size_t why_size)
{
    const char *end = strstr(url, "://");
    if (end == NULL) {
        return wrong(why, why_size, url, url[0] == '\0' ? "it is empty" : "no :// is in it");
    }
    if (!is_kind(url, (size_t)(end - url))) {
        return wrong(why, why_size, url,
                     "unknown kind: udpm, tcpq, memq, file or mpudpm is allowed before ://");
    }
    return strncmp(url, "udpm://", 7) != 0 || check_udpm(url, why, why_size);
}
