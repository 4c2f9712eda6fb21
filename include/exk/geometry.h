/** Dimensions of an Exechon-type machine and their published bounds.
 *
 *  Source  docs/kinematics.md section 1: defaults, published ratios p1..p4.
 *  Ratios  p1 = d1/(2 d5) in [0.5, 0.8], p2 = d2/d1 in [0.5, 1], p3 = 2 d3/d1 in [0.5, 1],
 *          p4 = d4/d3 = 0.75; each bound has a slack of 1e-9 for decimals that binary rounds.
 *  Units   metres and radians.
 *  Errors  exk_geometry_check: EXK_ERR_ARG, with the offending quantity, its value and bounds.
 *  Memory  a plain value; a second machine is data, not a fork.
 */
#ifndef EXK_GEOMETRY_H
#define EXK_GEOMETRY_H

#include <stddef.h>

#include "exk/err.h"

/* No length of a machine is larger: keeps every square below overflow. */
#define EXK_LENGTH_MAX_M 100.0
/* Shortest length that divides, or is a leg, a bar or a joint spacing. */
#define EXK_LENGTH_MIN_M 1e-3

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

/** The assumed X700-class machine: inside every published ratio (docs/kinematics.md section 1). */
exk_geometry exk_geometry_default(void);

/** Checks, in this order, every length (d1..d5, l_min, z0 in [EXK_LENGTH_MIN_M,
 *  EXK_LENGTH_MAX_M]; e, t in [0, EXK_LENGTH_MAX_M]; |f| <= EXK_LENGTH_MAX_M), the angle limit
 *  (above 0, at most 60 deg: beyond that two assembly branches meet) and the ratios. The first
 *  fault is reported. fault may be NULL; it is written only when a bound is broken. */
exk_err exk_geometry_check(const exk_geometry *geo, exk_geometry_fault *fault);

enum { EXK_GEOMETRY_FAULTS_MAX = 11 };

/** All faults in that order, up to capacity; ratios only when every length is good. Returns how
 *  many were written. */
size_t exk_geometry_faults(const exk_geometry *geo, exk_geometry_fault *faults,
                           size_t capacity);

#endif
