/** Which limit of the machine a refused place breaks, and by how much: for messages, never in a step
 *  that is in order.
 *
 *  How      the same equations with the limits taken away; the angle or leg that is beyond the one it has.
 *  Errors   false: nothing to be named. The place is in order, or refused for another reason (not
 *           finite, singular, off the branch, the wrist), or the model is P or U.
 *  Memory   writes *out only when true.
 */
#ifndef EXK_EXCESS_H
#define EXK_EXCESS_H

#include <stdbool.h>

#include "exk/kinematics.h"

typedef struct {
    bool is_leg;  /* else an angle */
    int index;    /* leg 0 to 2; EXK_ALPHA, EXK_BETA */
    double value; /* [m] or [rad] */
    double limit; /* the one it is beyond */
} exk_excess;

bool exk_excess_of_tool(const exk_kin *kin, const exk_tool *tool, exk_excess *out);
bool exk_excess_of_joints(const exk_kin *kin, const exk_joints *joints, exk_excess *out);

#endif
