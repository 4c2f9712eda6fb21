/** The result for people: one row a hole, then the figures beside the published ones. */
#ifndef EXK_HOLES_TABLE_H
#define EXK_HOLES_TABLE_H

#include <stdbool.h>
#include <stdio.h>

#include "report.h"

void hole_table_print(const hole_report *report, FILE *out, bool colour);

#endif
