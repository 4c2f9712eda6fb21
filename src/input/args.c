#include "exk/args.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_WRONG_USE = 2 };

void exk_args_parse(const struct argp *argp, const char *version, int argc, char **argv,
                    void *out)
{
    argp_program_version = version;
    argp_err_exit_status = EXIT_WRONG_USE;
    argp_parse(argp, argc, argv, 0, NULL, out);
}

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

char *exk_args_name(const struct argp_state *state, const char *what, char *arg)
{
    if (arg[0] == '\0') {
        argp_error(state, "%s: the name is empty", what);
    }
    return arg;
}

bool exk_args_stdout_is_whole(const char *program)
{
    errno = 0;
    const bool flushed = fflush(stdout) == 0;
    if (flushed && !ferror(stdout)) {
        return true;
    }
    fprintf(stderr, "%s: standard output: could not be written: %s\n", program,
            strerror(errno != 0 ? errno : EIO));
    return false;
}
