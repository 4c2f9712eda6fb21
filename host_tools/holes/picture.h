/** Picture of the drilled holes: a map with the errors enlarged, and all holes in one circle.
 *
 *  Map     each hole at its place with its tolerance circle; the error vector and the circle are
 *          enlarged alike, so a point beyond its circle missed the tolerance. Equal scale in x and y.
 *  Marks   inside: filled circle, blue; outside: triangle, red; no drilled position: grey cross.
 *  Errors  exit codes and reasons as in gnuplot.h.
 */
#ifndef EXK_HOLES_PICTURE_H
#define EXK_HOLES_PICTURE_H

#include <stddef.h>

#include "report.h"

int hole_picture_write(const hole_report *report, const char *path, char *why, size_t why_size);

#endif
