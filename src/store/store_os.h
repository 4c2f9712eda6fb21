/** The system calls of the store behind a table, so that a test can cut the power after any of them.
 *
 *  Calls  as in POSIX, errno included; size: bytes of an open regular file, -1 for anything else.
 */
#ifndef EXK_STORE_OS_H
#define EXK_STORE_OS_H

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

#endif
