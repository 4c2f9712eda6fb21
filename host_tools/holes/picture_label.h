/** Places of ids and labels: tried round their hole, the one that covers least is taken. */
#ifndef EXK_HOLES_PICTURE_LABEL_H
#define EXK_HOLES_PICTURE_LABEL_H

#include "picture_layout.h"

/** Allocates and fills layout->ids; without memory the picture goes without ids. */
void picture_ids_place(const hole_report *report, picture_layout *layout);

#endif
