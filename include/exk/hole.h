/** A hole to drill: where, along which axis, and the name its owner gave it.
 *
 *  Units   metres, base frame; axis is a unit vector from the machine into the part.
 */
#ifndef EXK_HOLE_H
#define EXK_HOLE_H

#include <stdint.h>

typedef struct {
    int32_t id; /* as in the job file; built-in jobs count from 1 */
    double target_m[3];
    double axis[3];
} exk_hole;

#endif
