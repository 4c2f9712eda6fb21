/** exk-ilc: the learned correction of a job, made, looked at and checked. */
#ifndef EXK_ILC_TOOL_H
#define EXK_ILC_TOOL_H

#include <stdbool.h>
#include <stdint.h>

enum { ILC_GOOD = 0, ILC_MISSED = 1, ILC_INPUT = 2, ILC_IO = 3 };

typedef enum { ILC_LEARN, ILC_SHOW, ILC_VERIFY, ILC_TRAIN } ilc_command;

typedef struct {
    ilc_command command;
    const char *input;   /* LOG, STORE or PROFILE */
    const char *profile; /* verify: the profile it should fit, or NULL */
    const char *output;  /* -o STORE, NULL: none */
    uint32_t n_runs;     /* train */
    uint32_t series;     /* train */
    double until_mm;     /* train: stop below this last-point error; 0: never */
    bool json;
    bool allow_bad; /* learn, train: from a run with rejected sensor samples as well */
} ilc_options;

/** Exits with 2 on wrong use, with 0 after --help and --version. */
void ilc_options_parse(int argc, char **argv, ilc_options *out);

/** Each returns an exit code. */
int ilc_learn(const ilc_options *options);
int ilc_show(const ilc_options *options);
int ilc_verify(const ilc_options *options);
int ilc_train(const ilc_options *options);

#endif
