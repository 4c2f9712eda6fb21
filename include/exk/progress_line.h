/** One line of progress on standard error, drawn over and over.
 *
 *  Width   cut to the terminal, at most 79 characters: a longer line would wrap and leave its head behind.
 *  Where   only where standard error is a terminal: exk_progress_wanted. The caller asks.
 *  Memory  no state, no allocation. Outside the core.
 */
#ifndef EXK_PROGRESS_LINE_H
#define EXK_PROGRESS_LINE_H

#include <stdbool.h>

/** Whether somebody sees it: standard error is a terminal. */
bool exk_progress_wanted(void);

/** Draws the line in place of the last one. */
__attribute__((format(printf, 1, 2))) void exk_progress_show(const char *format, ...);

/** Takes the line away; the cursor is where it began. */
void exk_progress_clear(void);

#endif
