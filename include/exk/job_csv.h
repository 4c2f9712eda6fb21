/** Holes from a CSV text: header id,x_mm,y_mm and optionally z_mm,nx,ny,nz in any order.
 *
 *  z_mm     default: the profile's plane. nx,ny,nz: direction from the machine into the part, any
 *           length above 1e-6, default 0,0,1.
 *  Errors   all collected, each with its line: no header, unknown or missing column, not a number,
 *           not finite, id twice (both lines named), no hole at all, too many.
 *  Memory   the caller lends holes.
 */
#ifndef EXK_JOB_CSV_H
#define EXK_JOB_CSV_H

#include <stddef.h>

#include "exk/err.h"
#include "exk/hole.h"
#include "exk/profile.h"

enum { EXK_MAX_HOLES = 4096 };

exk_err exk_job_csv_parse(const char *text, double plane_z_m, exk_hole *holes, size_t capacity,
                          size_t *n_holes, exk_fault *faults, size_t fault_capacity,
                          size_t *n_faults);

#endif
