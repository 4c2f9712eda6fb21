/** The system calls of the store behind a table, so that a test can cut the power after any of them.
 *
 *  Calls  as in POSIX, errno included; size: bytes of an open regular file, -1 for anything else.
 */
#ifndef EXK_STORE_OS_H
#define EXK_STORE_OS_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

typedef struct {
    int (*open)(void *ctx, const char *path, int flags);
    ssize_t (*read)(void *ctx, int fd, void *bytes, size_t n);
    ssize_t (*write)(void *ctx, int fd, const void *bytes, size_t n);
    off_t (*size)(void *ctx, int fd);
    int (*fsync)(void *ctx, int fd);
    int (*close)(void *ctx, int fd);
    int (*rename)(void *ctx, const char *from, const char *to);
    int (*link)(void *ctx, const char *from, const char *to);
    int (*unlink)(void *ctx, const char *path);
    void *ctx;
} store_os;

/** The system's own. */
const store_os *store_os_posix(void);

/** One saver at a time: a lock on the folder of path, given back by the system however a process ends.
 *  Waits up to 10 s; false when it is still held then. Where folders cannot be locked, fd is as good. */
bool store_os_lock(const char *path, int *fd);
void store_os_unlock(int fd);

#endif
