#define _POSIX_C_SOURCE 200809L
#include <time.h>

#include "exk/realtime.h"

int64_t exk_wall_us(void)
{
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    return (int64_t)now.tv_sec * 1000000 + now.tv_nsec / 1000;
}
