/** One controller, and one machine, on a bus: a second one is told so and does not start.
 *
 *  Claim    a name in the abstract socket space of this network namespace, from role and UDP port: taken
 *           at once or refused at once, and given back by the system however the process ends. Other
 *           groups on the same port hear one another (LCM 1.3), so the group does not count.
 *  Listen   for what another host or an older program may be sending.
 *  Scope    udpm and tcpq URLs; file and memq reach nobody else.
 *  Errors   false, and why says who is there and what to do.
 *  Memory   one descriptor, closed with the process.
 */
#ifndef EXK_SOLO_H
#define EXK_SOLO_H

#include <stdbool.h>
#include <stddef.h>

/** role: "controller" or "machine". */
bool exk_solo_claim(const char *role, const char *url, char *why, size_t why_size);

/** Listens for another controller's EXK_STATUS, EXK_POSE or EXK_DRIVE; true when none is heard, or when
 *  the bus cannot be opened (whoever opens it next says why). */
bool exk_solo_listen(const char *url, int timeout_ms, char *why, size_t why_size);

#endif
