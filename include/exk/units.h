/** Our own pi and the conversions used at the edge where people read and write files.
 *
 *  Inside the product lengths are metres and angles radians, everywhere.
 */
#ifndef EXK_UNITS_H
#define EXK_UNITS_H

#define EXK_PI 3.14159265358979323846
#define EXK_RAD_PER_DEG (EXK_PI / 180.0)
#define EXK_M_PER_MM 1e-3
#define EXK_MM_PER_M 1e3

#endif
