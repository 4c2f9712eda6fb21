#define _DEFAULT_SOURCE
#include "store_os.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { LOCK_TRIES = 500 };
static const struct timespec lock_pause = {.tv_nsec = 20000000};

static int do_open(void *ctx, const char *path, int flags)
{
    (void)ctx;
    return open(path, flags | O_CLOEXEC | O_NONBLOCK, 0666); /* a FIFO must not hold us up */
}

static ssize_t do_read(void *ctx, int fd, void *bytes, size_t n)
{
    (void)ctx;
    return read(fd, bytes, n);
}

static ssize_t do_write(void *ctx, int fd, const void *bytes, size_t n)
{
    (void)ctx;
    return write(fd, bytes, n);
}

static off_t do_size(void *ctx, int fd)
{
    struct stat info;
    (void)ctx;
    return fstat(fd, &info) == 0 && S_ISREG(info.st_mode) ? info.st_size : -1;
}

static int do_fsync(void *ctx, int fd)
{
    (void)ctx;
    return fsync(fd);
}

static int do_close(void *ctx, int fd)
{
    (void)ctx;
    return close(fd);
}

static int do_rename(void *ctx, const char *from, const char *to)
{
    (void)ctx;
    return rename(from, to);
}

static int do_link(void *ctx, const char *from, const char *to)
{
    (void)ctx;
    return link(from, to);
}

static int do_unlink(void *ctx, const char *path)
{
    (void)ctx;
    return unlink(path);
}

static const store_os posix_calls = {do_open,  do_read,   do_write, do_size,   do_fsync,
                                     do_close, do_rename, do_link,  do_unlink, NULL};

const store_os *store_os_posix(void)
{
    return &posix_calls;
}

static int open_folder_of(const char *path)
{
    char folder[PATH_MAX];
    const char *slash = strrchr(path, '/');
    const int length = slash == NULL || slash == path ? 1 : (int)(slash - path);
    snprintf(folder, sizeof folder, "%.*s", length, slash == NULL ? "." : path);
    return open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

bool store_os_lock(const char *path, int *fd)
{
    *fd = open_folder_of(path);
    for (int i = 0; *fd >= 0 && i < LOCK_TRIES; i++) {
        if (flock(*fd, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) {
            return true;
        }
        nanosleep(&lock_pause, NULL);
    }
    store_os_unlock(*fd);
    return *fd < 0;
}

void store_os_unlock(int fd)
{
    if (fd >= 0) {
        close(fd);
    }
}
