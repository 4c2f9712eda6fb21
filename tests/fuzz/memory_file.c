#define _GNU_SOURCE
#include "memory_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include "fuzz.h"

static char path[64];

const char *memory_file(const uint8_t *data, size_t size)
{
    static int file = -1;
    if (file < 0) {
        file = memfd_create("fuzz", MFD_CLOEXEC);
        PROMISE(file >= 0);
        snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    }
    PROMISE(ftruncate(file, 0) == 0);
    PROMISE(pwrite(file, data, size, 0) == (ssize_t)size);
    return path;
}
