/** The report's figures, in the order of the page; each reads what it needs from the page. */
#ifndef STUDY_REPORT_FIGURES_H
#define STUDY_REPORT_FIGURES_H

#include "report_page.h"

void report_overview(report_page *page); /* all claims on one scale */
void report_paths(report_page *page);    /* S1 to S3 */
void report_learning(report_page *page); /* S4, S5 */
void report_grid25(report_page *page);   /* S7, S8 */
void report_target45(report_page *page); /* S9 */
void report_spread(report_page *page);   /* the simulated distribution of each claim */

/** What acts in an experiment, from its profile: "sine of 0.005 rad at 0.5 Hz ...". */
void report_noise_text(const exk_profile *profile, char *out, size_t size);

#endif
