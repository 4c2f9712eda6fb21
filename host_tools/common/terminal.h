/** Whether a stream goes to a person who wants colour: NO_COLOR respected. */
#ifndef EXK_TOOLS_TERMINAL_H
#define EXK_TOOLS_TERMINAL_H

#include <stdbool.h>
#include <stdio.h>

bool exk_has_colour(FILE *stream);

#endif
