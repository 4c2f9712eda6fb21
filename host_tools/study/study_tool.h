/** The commands of exk-study behind its options. */
#ifndef STUDY_TOOL_H
#define STUDY_TOOL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "paper.h"
#include "work.h"

typedef enum {
    STUDY_PAPER,
    STUDY_COMPARE,
    STUDY_CALIBRATE,
    STUDY_SENSITIVITY,
    STUDY_BLOCK,
    STUDY_MERGE
} study_command;

typedef struct {
    study_command command;
    uint64_t n_seeds; /* 0: the command's own default */
    int n_threads;
    const char *profiles; /* folder, NULL: found */
    const char *json;
    const char *csv;
    const char *report;
    const char *with_compare; /* their JSON files, for the report */
    const char *with_sensitivity;
    const char *resume;
    const char *output; /* block */
    bool by_steps;
    uint64_t from;
    uint64_t to;
    const char *only;   /* as given, NULL: all */
    uint32_t parts_run; /* its bits of study_part */
    bool write;         /* calibrate: into the profiles */
    char **parts;
    size_t n_parts;
} study_options;

void study_options_parse(int argc, char **argv, study_options *out);

int study_do_paper(const study_options *options);
int study_do_block(const study_options *options);
int study_do_merge(const study_options *options);
int study_do_compare(const study_options *options);
int study_do_calibrate(const study_options *options);
int study_do_sensitivity(const study_options *options);

/** Acts on the experiments of parts (bits of study_part), step by step where the options say so. */
int study_with_paper(const study_options *options, uint32_t parts,
                     int (*act)(const study_options *options, study_paper *paper));

/** Threads and folders of a run from the options; n_seeds trials. */
study_work study_work_of(const study_options *options, uint64_t n_seeds);

#endif
