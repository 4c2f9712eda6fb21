/** Descriptors 0, 1 and 2 belong to standard input, output and error, also where they came closed.
 *
 *  A program that was started with one of them closed (some supervisors do) gets its number back for the
 *  next file or socket it opens: a note on standard error would then stand in the middle of a log, or go
 *  out on the bus. Called first in main, this takes the free ones of the three. What is printed to them
 *  fails as before, so that a lost result still ends with 3.
 */
#ifndef EXK_STANDARD_STREAMS_H
#define EXK_STANDARD_STREAMS_H

void exk_standard_streams_hold(void);

#endif
