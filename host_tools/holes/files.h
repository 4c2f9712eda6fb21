/** The result for machines: JSON and CSV. Exit codes and reasons as in out_file.h. */
#ifndef EXK_HOLES_FILES_H
#define EXK_HOLES_FILES_H

#include <stddef.h>

#include "report.h"

int hole_json_write(const hole_report *report, const char *path, char *why, size_t why_size);
int hole_csv_write(const hole_report *report, const char *path, char *why, size_t why_size);

#endif
