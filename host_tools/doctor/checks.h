/** What exk-doctor looks at; each function adds its lines. */
#ifndef EXK_DOCTOR_CHECKS_H
#define EXK_DOCTOR_CHECKS_H

#include "finding.h"

/** Route, messages there and back, receive buffer, time to live. */
void check_bus(findings *all, const char *url);

/** Scheduling, locked memory, punctuality, gnuplot, Java. */
void check_host(findings *all);

#endif
