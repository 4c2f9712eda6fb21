/** Dimensions of an Exechon-type machine and their published bounds.
 *
 *  Source  kinematics.md section 1 (table of defaults) and study.md (ratios p1..p4).
 *  Ratios  p1 = d1/(2 d5) in [0.5, 0.8], p2 = d2/d1 in [0.5, 1], p3 = 2 d3/d1 in [0.5, 1],
 *          p4 = d4/d3 = 0.75 (within 1e-9).
 *  Units   metres and radians.
 *  Errors  exk_geometry_check: EXK_ERR_ARG, with the offending quantity, its value and bounds.
 *  Memory  a plain value; a second machine is data, not a fork.
 */
#ifndef EXK_GEOMETRY_H
#define EXK_GEOMETRY_H

#include "exk/err.h"

typedef struct {
    double d1_m;          /* |A1A3|, base joints of legs 1 and 3 */
    double d2_m;          /* |OA2|, base joint of leg 2 */
    double d3_m;          /* |B1B3|, platform joints of legs 1 and 3 */
    double d4_m;          /* |O1B2|, platform joint of leg 2 */
    double d5_m;          /* stroke of a leg */
    double l_min_m;       /* shortest leg; the longest is l_min_m + d5_m */
    double angle_max_rad; /* limit of |alpha| and |beta| */
    double z0_m;          /* working height of the plate in models P and U, home height of O1 */
    double e_m;           /* O1 to wrist centre along w */
    double f_m;           /* O1 to wrist centre along v */
    double t_m;           /* wrist centre to tool tip */
} exk_geometry;

/** Which quantity broke its bound, for a message. */
typedef struct {
    const char *name; /* "p3 = 2 d3/d1", static storage */
    double value;
    double min;
    double max;
} exk_geometry_fault;

exk_geometry exk_geometry_default(void);

/** Checks every length (> 0, finite; f_m any finite), the ratios and the angle limit (0 to 60 deg).
 *  fault may be NULL; it is written only when a bound is broken. */
exk_err exk_geometry_check(const exk_geometry *geo, exk_geometry_fault *fault);

#endif
