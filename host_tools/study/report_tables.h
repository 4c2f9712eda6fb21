/** The report's tables: figures, claims, fitted numbers, what was run, the machines, sensitivity. */
#ifndef STUDY_REPORT_TABLES_H
#define STUDY_REPORT_TABLES_H

#include "report_page.h"

void report_claims(report_page *page);      /* published against ours, references apart */
void report_words(report_page *page);       /* claims in words */
void report_fitted(report_page *page);      /* fitted numbers and where they came from */
void report_experiments(report_page *page); /* what was run, from the profiles */
void report_machines(report_page *page); /* Exechon, Mazak, Loxin: what their figures imply */

/** How many of a list have key true, of those whose role is given (NULL: all). */
size_t report_count(const json_t *list, const char *key, const char *role, size_t *of);

#endif
