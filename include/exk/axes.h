/** The two controlled angles and the tool, shared by every room.
 *
 *  Angles   alpha goes with +x, beta with +y (docs/kinematics.md section 1), radians.
 *  Frames   base frame O: X along A1->A3, Y along O->A2, Z toward the tool.
 */
#ifndef EXK_AXES_H
#define EXK_AXES_H

enum { EXK_ALPHA = 0, EXK_BETA = 1, EXK_N_AXES = 2 };
enum { EXK_X = 0, EXK_Y = 1, EXK_Z = 2 };
enum { EXK_N_LEGS = 3, EXK_N_WRIST = 2 };

/** Tool tip and unit tool direction (from the machine into the part), base frame. */
typedef struct {
    double tip_m[3];
    double axis[3];
} exk_tool;

#endif
