#include "study_tool.h"
#include <stdio.h>
int study_do_calibrate(const study_options *options)
{
    (void)options;
    fprintf(stderr, "exk-study: not yet\n");
    return STUDY_INPUT;
}
