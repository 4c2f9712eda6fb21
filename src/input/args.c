#include "exk/args.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

uint64_t exk_args_whole(const struct argp_state *state, const char *what, const char *arg,
                        uint64_t min, uint64_t max)
{
    char *end = NULL;
    errno = 0;
    const unsigned long long value = strtoull(arg, &end, 10);
    if (errno != 0 || end == arg || *end != '\0' || strchr(arg, '-') != NULL || value < min ||
        value > max) {
        argp_error(state, "%s %s: a whole number from %" PRIu64 " to %" PRIu64 " is allowed",
                   what, arg, min, max);
    }
    return value;
}

double exk_args_positive(const struct argp_state *state, const char *what, const char *arg,
                         const char *unit)
{
    char *end = NULL;
    errno = 0;
    const double value = strtod(arg, &end);
    if (errno != 0 || end == arg || *end != '\0' || !(value > 0.0 && isfinite(value))) {
        argp_error(state, "%s %s: a number of %s above 0 is allowed", what, arg, unit);
    }
    return value;
}
