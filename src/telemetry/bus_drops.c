#define _DEFAULT_SOURCE
#include <dirent.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "exk/bus.h"

enum { LCM_PORT = 7667, LINE_MAX_BYTES = 512, SOCKETS_MAX = 64 };

static unsigned port_of(const char *url)
{
    const char *begin = url + strlen("udpm://");
    const char *colon = begin + strcspn(begin, ":?");
    return *colon == ':' ? (unsigned)strtoul(colon + 1, NULL, 10) : LCM_PORT;
}

/* The inodes of this process' sockets: /proc/self/fd/N -> socket:[inode]. */
static int own_sockets(unsigned long inodes[SOCKETS_MAX])
{
    int n = 0;
    DIR *folder = opendir("/proc/self/fd");
    const struct dirent *entry = NULL;
    while (folder != NULL && n < SOCKETS_MAX && (entry = readdir(folder)) != NULL) {
        char target[64] = "";
        const ssize_t length =
            readlinkat(dirfd(folder), entry->d_name, target, sizeof target - 1);
        if (length > 0 && sscanf(target, "socket:[%lu]", &inodes[n]) == 1) {
            n++;
        }
    }
    if (folder != NULL) {
        closedir(folder);
    }
    return n;
}

static bool is_own(const unsigned long inodes[], int n, unsigned long inode)
{
    for (int i = 0; i < n; i++) {
        if (inodes[i] == inode) {
            return true;
        }
    }
    return false;
}

/* Columns of /proc/net/udp: sl local remote st queues timer retransmits uid timeout inode ref pointer
 * drops. */
int64_t exk_bus_dropped(const char *url)
{
    unsigned long inodes[SOCKETS_MAX];
    char line[LINE_MAX_BYTES];
    int64_t sum = 0;
    FILE *table = strncmp(url, "udpm://", 7) == 0 ? fopen("/proc/net/udp", "r") : NULL;
    const int n = table == NULL ? 0 : own_sockets(inodes);
    while (table != NULL && fgets(line, sizeof line, table) != NULL) {
        unsigned port = 0;
        unsigned long inode = 0;
        int64_t drops = 0;
        if (sscanf(line, "%*s %*8[0-9A-F]:%x %*s %*s %*s %*s %*s %*s %*s %lu %*s %*s %" SCNd64,
                   &port, &inode, &drops) == 3 &&
            port == port_of(url) && is_own(inodes, n, inode)) {
            sum += drops;
        }
    }
    if (table != NULL) {
        fclose(table);
    }
    return sum;
}
