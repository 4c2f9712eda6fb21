/** The bus: LCM behind five functions, with what LCM leaves to luck made sure of.
 *
 *  Route    a udpm URL needs a route for its multicast group. It is asked for before LCM is, so that
 *           the message says the one line that cures it.
 *  Receive  the URL gets recv_buf_size=4194304 unless it names a size; subscriptions have no bound
 *           (LCM's default of 30 messages drops the newest without a word).
 *  Send     copies to the system; no allocation on udpm.
 *  Errors   NULL or false, with a message that says what to do.
 *  Memory   open allocates, close releases. One thread at a time.
 */
#ifndef EXK_BUS_H
#define EXK_BUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { EXK_BUS_BUFFER_BYTES = 4194304 };

typedef struct exk_bus exk_bus;

/** data is valid during the call; received_us: microseconds since 1970 UTC. */
typedef void (*exk_bus_fn)(void *ctx, const char *channel, const void *data, size_t bytes,
                           int64_t received_us);

exk_bus *exk_bus_open(const char *url, bool receive, char *why, size_t why_size);
void exk_bus_close(exk_bus *bus);

bool exk_bus_send(exk_bus *bus, const char *channel, const void *data, size_t bytes);

/** Every channel that matches pattern (EXK_CHANNEL_ALL) goes to fn, from exk_bus_wait. */
bool exk_bus_listen(exk_bus *bus, const char *pattern, exk_bus_fn fn, void *ctx, char *why,
                    size_t why_size);

/** Waits for messages at most timeout_ms and delivers what came; returns how many, -1 on failure.
 *  A signal ends the wait with 0. Returns after a few thousand, so that a caller stays alive. */
int exk_bus_wait(exk_bus *bus, int timeout_ms);

/** Can this URL be one of LCM's: kind, group, port, ttl? False is wrong use; what the system then refuses
 *  is not. exk_bus_open asks it too. */
bool exk_bus_url_good(const char *url, char *why, size_t why_size);

/** Can the multicast group of a udpm URL be reached? True for every other kind of good URL. */
bool exk_bus_route(const char *url, char *why, size_t why_size);

/** Bytes of receive buffer that the system grants when EXK_BUS_BUFFER_BYTES are asked for. */
int64_t exk_bus_granted_bytes(void);

/** Datagrams for the URL's port that the system dropped before this process read them (a full receive
 *  buffer), all its sockets together; 0 where the system does not say. Reads /proc. */
int64_t exk_bus_dropped(const char *url);

/** The time to live in a udpm URL; 0, this host alone, when it says nothing. */
int exk_bus_ttl(const char *url);

#endif
