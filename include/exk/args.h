/** A command line, its numbers and names: said clearly when they are wrong (exit through argp_error).
 *
 *  what    the option with its dashes, for the message: "--seconds".
 */
#ifndef EXK_ARGS_H
#define EXK_ARGS_H

#include <argp.h>
#include <stdbool.h>
#include <stdint.h>

/** Parses a command line: --version says version, "exk-log 0.1.0"; wrong use is said and ends with 2. out is
 *  the parser's input. */
void exk_args_parse(const struct argp *argp, const char *version, int argc, char **argv,
                    void *out);

/** A whole number from min to max. */
uint64_t exk_args_whole(const struct argp_state *state, const char *what, const char *arg,
                        uint64_t min, uint64_t max);

/** A finite number above 0; unit is what the message calls it, "seconds". */
double exk_args_positive(const struct argp_state *state, const char *what, const char *arg,
                         const char *unit);

/** The name of a file: arg itself, unless it is empty. */
char *exk_args_name(const struct argp_state *state, const char *what, char *arg);

/** At the end of a program: whatever was printed has arrived, or it is said and false is returned. */
bool exk_args_stdout_is_whole(const char *program);

#endif
