/** Beyond the study: the controllers on frozen and on fresh noise beside the floor; sensitivity. */
#ifndef STUDY_REPORT_OWN_H
#define STUDY_REPORT_OWN_H

#include "report_page.h"

void report_own(report_page *page);
void report_sensitivity(report_page *page);

#endif
