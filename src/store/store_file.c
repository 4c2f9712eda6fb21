#define _POSIX_C_SOURCE 200809L
#include "store_file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const off_t largest = (off_t)2 << 30;

static exk_store_err io_error(char *why, size_t why_size, const char *path, const char *what)
{
    snprintf(why, why_size, "%s: %s: %s", path, what, strerror(errno));
    return EXK_STORE_IO;
}

static bool read_all(const store_os *os, int fd, unsigned char *bytes, size_t n)
{
    for (size_t done = 0; done < n;) {
        const ssize_t got = os->read(os->ctx, fd, bytes + done, n - done);
        if (got == 0 || (got < 0 && errno != EINTR)) {
            return false;
        }
        done += got > 0 ? (size_t)got : 0;
    }
    return true;
}

static bool write_all(const store_os *os, int fd, store_bytes fresh)
{
    for (size_t done = 0; done < fresh.n;) {
        const ssize_t put = os->write(os->ctx, fd, fresh.bytes + done, fresh.n - done);
        if (put < 0 && errno != EINTR) {
            return false;
        }
        done += put > 0 ? (size_t)put : 0;
    }
    return true;
}

unsigned char *store_file_read(const store_os *os, const char *path, size_t *n_bytes, char *why,
                               size_t why_size)
{
    unsigned char *bytes = NULL;
    errno = 0;
    const int fd = os->open(os->ctx, path, O_RDONLY);
    const off_t size = fd < 0 ? -1 : os->size(os->ctx, fd);
    if (fd >= 0 && size < 0 && errno == 0) {
        snprintf(why, why_size, "%s: not a regular file: an ILC store is kept in one", path);
    } else if (size < 0 || size > largest) {
        errno = size > largest ? EFBIG : errno;
        io_error(why, why_size, path, "cannot open the ILC store");
    } else {
        *n_bytes = (size_t)size;
        bytes = malloc(*n_bytes + 1);
        if (bytes == NULL || !read_all(os, fd, bytes, *n_bytes)) {
            io_error(why, why_size, path, "cannot read the ILC store");
            free(bytes);
            bytes = NULL;
        }
    }
    if (fd >= 0) {
        os->close(os->ctx, fd);
    }
    return bytes;
}

bool store_file_exists(const store_os *os, const char *path)
{
    const int fd = os->open(os->ctx, path, O_RDONLY);
    const bool missing = fd < 0 && errno == ENOENT;
    if (fd >= 0) {
        os->close(os->ctx, fd);
    }
    return !missing;
}

static bool name(const char *path, const char *ending, char *out, size_t size)
{
    const int length = snprintf(out, size, "%s%s", path, ending);
    errno = ENAMETOOLONG;
    return length > 0 && (size_t)length < size;
}

bool store_file_previous(const char *path, char *out, size_t size)
{
    return name(path, ".prev", out, size);
}

static bool sync_folder_of(const store_os *os, const char *path)
{
    char folder[PATH_MAX];
    const char *slash = strrchr(path, '/');
    const int length = slash == NULL ? 1 : slash == path ? 1 : (int)(slash - path);
    snprintf(folder, sizeof folder, "%.*s", length, slash == NULL ? "." : path);
    const int fd = os->open(os->ctx, folder, O_RDONLY | O_DIRECTORY);
    const bool good = fd >= 0 && os->fsync(os->ctx, fd) == 0;
    if (fd >= 0) {
        os->close(os->ctx, fd);
    }
    return good;
}

/* Always a new file: what an earlier crash left under this name may be the good one under another. */
static bool write_synced(const store_os *os, const char *path, store_bytes fresh)
{
    os->unlink(os->ctx, path);
    const int fd = os->open(os->ctx, path, O_WRONLY | O_CREAT | O_EXCL);
    if (fd < 0) {
        return false;
    }
    const bool written = write_all(os, fd, fresh) && os->fsync(os->ctx, fd) == 0;
    const int reason = errno;
    const bool closed = os->close(os->ctx, fd) == 0;
    errno = written ? errno : reason;
    return written && closed;
}

static bool keep_previous(const store_os *os, const char *path, const char *previous)
{
    os->unlink(os->ctx, previous);
    return os->link(os->ctx, path, previous) == 0 || os->rename(os->ctx, path, previous) == 0;
}

exk_store_err store_file_replace(const store_os *os, const char *path, store_bytes fresh,
                                 bool keep, char *why, size_t why_size)
{
    char next[PATH_MAX];
    char previous[PATH_MAX];
    if (!name(path, ".new", next, sizeof next) ||
        !store_file_previous(path, previous, sizeof previous)) {
        return io_error(why, why_size, path, "cannot write the ILC store");
    }
    if (!write_synced(os, next, fresh) || (keep && !keep_previous(os, path, previous)) ||
        os->rename(os->ctx, next, path) != 0) {
        io_error(why, why_size, path,
                 keep ? "cannot write the ILC store, the old one stays"
                      : "cannot write the ILC store");
        os->unlink(os->ctx, next);
        return EXK_STORE_IO;
    }
    if (!sync_folder_of(os, path)) {
        return io_error(why, why_size, path, "written, but its folder could not be synced");
    }
    return EXK_STORE_OK;
}
