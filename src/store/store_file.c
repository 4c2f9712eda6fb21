#define _POSIX_C_SOURCE 200809L
#include "store_file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const off_t largest = (off_t)2 << 30;

static exk_store_err io_error(char *why, size_t why_size, const char *path, const char *what)
{
    snprintf(why, why_size, "%s: %s: %s", path, what, strerror(errno));
    return EXK_STORE_IO;
}

static bool read_all(int fd, unsigned char *bytes, size_t n)
{
    for (size_t done = 0; done < n;) {
        const ssize_t got = read(fd, bytes + done, n - done);
        if (got == 0 || (got < 0 && errno != EINTR)) {
            return false;
        }
        done += got > 0 ? (size_t)got : 0;
    }
    return true;
}

static bool write_all(int fd, const unsigned char *bytes, size_t n)
{
    for (size_t done = 0; done < n;) {
        const ssize_t put = write(fd, bytes + done, n - done);
        if (put < 0 && errno != EINTR) {
            return false;
        }
        done += put > 0 ? (size_t)put : 0;
    }
    return true;
}

unsigned char *store_file_read(const char *path, size_t *n_bytes, char *why, size_t why_size)
{
    struct stat info;
    unsigned char *bytes = NULL;
    errno = 0;
    const int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0 || fstat(fd, &info) != 0 || !S_ISREG(info.st_mode) || info.st_size > largest) {
        errno = fd >= 0 && errno == 0 ? EINVAL : errno;
        io_error(why, why_size, path, "cannot open the ILC store");
    } else {
        *n_bytes = (size_t)info.st_size;
        bytes = malloc(*n_bytes + 1);
        if (bytes == NULL || !read_all(fd, bytes, *n_bytes)) {
            io_error(why, why_size, path, "cannot read the ILC store");
            free(bytes);
            bytes = NULL;
        }
    }
    if (fd >= 0) {
        close(fd);
    }
    return bytes;
}

static bool is_foreign(const char *path, const unsigned char *magic, size_t n_magic)
{
    unsigned char start[16] = {0};
    const int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0) {
        return errno != ENOENT;
    }
    const bool ours = read_all(fd, start, n_magic) && memcmp(start, magic, n_magic) == 0;
    close(fd);
    return !ours;
}

static bool sync_folder_of(const char *path)
{
    char folder[PATH_MAX];
    const char *slash = strrchr(path, '/');
    const int length = slash == NULL ? 1 : slash == path ? 1 : (int)(slash - path);
    snprintf(folder, sizeof folder, "%.*s", length, slash == NULL ? "." : path);
    const int fd = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const bool good = fd >= 0 && fsync(fd) == 0;
    if (fd >= 0) {
        close(fd);
    }
    return good;
}

static bool write_synced(const char *path, const unsigned char *bytes, size_t n_bytes)
{
    const int fd = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (fd < 0) {
        return false;
    }
    const bool written = write_all(fd, bytes, n_bytes) && fsync(fd) == 0;
    const int reason = errno;
    const bool closed = close(fd) == 0;
    errno = written ? errno : reason;
    return written && closed;
}

exk_store_err store_file_replace(const char *path, const unsigned char *bytes, size_t n_bytes,
                                 const unsigned char *magic, size_t n_magic, char *why,
                                 size_t why_size)
{
    char fresh[PATH_MAX];
    const int length = snprintf(fresh, sizeof fresh, "%s.new", path);
    if (length < 0 || (size_t)length >= sizeof fresh) {
        errno = ENAMETOOLONG;
        return io_error(why, why_size, path, "cannot write the ILC store");
    }
    if (is_foreign(path, magic, n_magic)) {
        snprintf(why, why_size,
                 "%s: exists and is not an ILC store: not overwritten; choose another name",
                 path);
        return EXK_STORE_NOT_OURS;
    }
    if (!write_synced(fresh, bytes, n_bytes) || rename(fresh, path) != 0) {
        io_error(why, why_size, path, "cannot write the ILC store, the old one stays");
        unlink(fresh);
        return EXK_STORE_IO;
    }
    if (!sync_folder_of(path)) {
        return io_error(why, why_size, path, "written, but its folder could not be synced");
    }
    return EXK_STORE_OK;
}
