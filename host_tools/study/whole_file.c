#define _POSIX_C_SOURCE 200809L
#include "whole_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { TEMP_SIZE = 4200 };

static uint8_t *fail_read(const char *path, char *why, size_t why_size)
{
    snprintf(why, why_size, "%s: cannot be read: %s", path, strerror(errno));
    return NULL;
}

uint8_t *study_read_whole(const char *path, size_t *n, char *why, size_t why_size)
{
    struct stat st;
    FILE *file = fopen(path, "rb");
    if (file == NULL || fstat(fileno(file), &st) != 0) {
        fail_read(path, why, why_size);
        if (file != NULL) {
            fclose(file);
        }
        return NULL;
    }
    const size_t size = (size_t)st.st_size;
    uint8_t *bytes = malloc(size + 1);
    errno = EIO;
    if (bytes != NULL && fread(bytes, 1, size, file) != size) {
        free(bytes);
        bytes = NULL;
    }
    fclose(file);
    *n = size;
    return bytes != NULL ? bytes : fail_read(path, why, why_size);
}

static bool write_all(int fd, const uint8_t *bytes, size_t n)
{
    while (n > 0) {
        const ssize_t done = write(fd, bytes, n);
        if (done < 0 && errno != EINTR) {
            return false;
        }
        if (done > 0) {
            bytes += done;
            n -= (size_t)done;
        }
    }
    return fsync(fd) == 0;
}

bool study_write_whole(const char *path, const uint8_t *bytes, size_t n, char *why,
                       size_t why_size)
{
    char temp[TEMP_SIZE];
    snprintf(temp, sizeof temp, "%s.XXXXXX", path);
    const int fd = mkstemp(temp);
    bool good = fd >= 0 && write_all(fd, bytes, n);
    if (fd >= 0) {
        (void)fchmod(fd, 0644);
        good = close(fd) == 0 && good;
        good = good && rename(temp, path) == 0;
    }
    if (!good) {
        snprintf(why, why_size, "%s: cannot be written: %s", path, strerror(errno));
        if (fd >= 0) {
            unlink(temp);
        }
    }
    return good;
}
