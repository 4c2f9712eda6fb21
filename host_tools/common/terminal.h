/** Whether a stream goes to a person: colour and progress only there, NO_COLOR respected. */
#ifndef EXK_TOOLS_TERMINAL_H
#define EXK_TOOLS_TERMINAL_H

#include <stdbool.h>
#include <stdio.h>

bool exk_is_terminal(FILE *stream);
bool exk_has_colour(FILE *stream);

#endif
