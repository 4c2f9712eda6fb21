#define _POSIX_C_SOURCE 200809L
#include "exk/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

/* The lowest free number is the one that open gives. Each is opened the wrong way round, so that using it
 * is an error and not a success that goes nowhere. */
void exk_standard_streams_hold(void)
{
    int fd = 0;
    while (fd >= 0 && fd <= STDERR_FILENO) {
        fd = open("/dev/null", fcntl(STDIN_FILENO, F_GETFD) == -1 ? O_WRONLY : O_RDONLY);
    }
    if (fd > STDERR_FILENO) {
        close(fd);
    }
}
