/** Command line of exk-command. */
#ifndef EXK_COMMAND_OPTIONS_H
#define EXK_COMMAND_OPTIONS_H

#include <stdbool.h>

#include "exk/command.h"

typedef struct {
    bool keygen;
    exk_command command;
    const char *key_path; /* or the file to make */
    const char *url;      /* NULL: default */
    double keep_s;        /* 0: send once; else repeat alive so often, seconds */
    bool quiet;
} command_options;

/** Exits with 2 on wrong use, with 0 after --help and --version. */
void command_options_parse(int argc, char **argv, command_options *out);

#endif
