/** Ctrl-C and its like, for a program that ends cleanly: its loop asks, nothing is torn down in a handler.
 *
 *  Memory  one flag of the process, which the signal handler alone writes. Outside the core.
 */
#ifndef EXK_STOP_SIGNAL_H
#define EXK_STOP_SIGNAL_H

/** From now on SIGINT, SIGTERM and SIGHUP (the terminal was closed) are noted, no longer
 *  deadly. Where SIGHUP is ignored, as under nohup, it stays ignored. SIGPIPE is ignored: a
 *  reader of our words that goes away (| head) does not end a machine, a record or a series; what could not
 *  be printed is an error of its own. */
void exk_stop_catch(void);

/** The number of the newest such signal, 0: none since exk_stop_catch. */
int exk_stop_signal(void);

#endif
