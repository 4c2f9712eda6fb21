/** Seconds on a clock that only goes forward, from a beginning that means nothing. */
#ifndef EXK_TOOLS_NOW_H
#define EXK_TOOLS_NOW_H

double exk_now_s(void);

#endif
