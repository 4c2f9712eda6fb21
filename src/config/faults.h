/** The faults of a text, kept in line order in a lent array.
 *
 *  Faults of line 0 belong to no line and come first. When the array is full the faults of the
 *  highest lines are left out; n counts them all.
 */
#ifndef EXK_CONFIG_FAULTS_H
#define EXK_CONFIG_FAULTS_H

#include "exk/profile.h"
#include "text.h"

typedef struct {
    exk_fault *faults;
    size_t capacity;
    size_t n;
} exk_faults;

/** Adds a message; faults may be NULL with capacity 0. */
void exk_faults_add(exk_faults *list, int line, const char *format, ...) EXK_PRINTF(3, 4);

#endif
