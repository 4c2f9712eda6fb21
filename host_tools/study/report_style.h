/** The page's style sheet: two themes, narrow screens, paper. No file or font from elsewhere. */
#ifndef STUDY_REPORT_STYLE_H
#define STUDY_REPORT_STYLE_H

#include <stdio.h>

void report_style(FILE *page);

#endif
