#include <stdlib.h>

#include "exk/standard_streams.h"
#include "mpi_ranks.h"
#include "study_tool.h"

int main(int argc, char **argv)
{
    static int (*const run[])(const study_options *) = {
        [STUDY_PAPER] = study_do_paper,         [STUDY_COMPARE] = study_do_compare,
        [STUDY_CALIBRATE] = study_do_calibrate, [STUDY_SENSITIVITY] = study_do_sensitivity,
        [STUDY_BLOCK] = study_do_block,         [STUDY_MERGE] = study_do_merge,
    };
    study_options options;
    exk_standard_streams_hold();
    study_options_parse(argc, argv, &options);
    study_mpi_begin();
    const int code = run[options.command](&options);
    study_mpi_end();
    free(options.parts);
    return code == STUDY_NOT_ROOT ? STUDY_GOOD : code;
}
