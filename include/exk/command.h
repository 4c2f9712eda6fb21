/** Commands to a running controller: who may give them, and which are refused.
 *
 *  Key      32 random bytes in a file of 64 hexadecimal digits, a regular file of its reader's own
 *           with no access for group and others (mode 0600 or 0400); refused otherwise.
 *  Hash     HMAC-SHA-512-256 (libsodium crypto_auth) over "EXKCMD01", run_id, seq, utime_us and
 *           command (lcm_types/command_t.lcm), compared in constant time.
 *  Gate     in this order: one whole message; this run; the hash; the clock (within fresh_us both
 *           ways); seq above that of the last one taken; a known command. What fails is refused,
 *           counted by kind and changes nothing: neither the last seq nor a watchdog.
 *  Inbox    a thread reads EXK_COMMAND and hands what passes to the control thread through a ring;
 *           take is wait-free.
 *  Errors   false or NULL with what to do.  Memory  a gate is a plain value; open allocates, close
 *           releases and wipes the key. Outside the core.
 */
#ifndef EXK_COMMAND_H
#define EXK_COMMAND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/bus_counts.h"
#include "exk/wire.h"

typedef enum {
    EXK_COMMAND_ALIVE, /* nothing but: the sender is there */
    EXK_COMMAND_START,
    EXK_COMMAND_STOP,
    EXK_COMMAND_ABORT,
    EXK_COMMAND_CLEAR,
    EXK_COMMAND_COUNT
} exk_command;

enum { EXK_KEY_BYTES = 32 };

typedef struct {
    unsigned char bytes[EXK_KEY_BYTES];
} exk_key_secret;

const char *exk_command_name(exk_command command); /* "start"; never NULL */
const char *exk_refusal_name(exk_refusal refusal); /* "wrong key"; never NULL */
bool exk_command_find(const char *name, exk_command *out);

/** Reads a key file; why says what is wrong with it and what to do. */
bool exk_key_load(const char *path, exk_key_secret *out, char *why, size_t why_size);

/** Makes a new key in a new file of mode 0600; an existing file stays. */
bool exk_key_make(const char *path, char *why, size_t why_size);
void exk_key_wipe(exk_key_secret *key);

/** Writes the keyed hash of a command into it. */
void exk_command_sign(exk_wire_command *command, const exk_key_secret *key);

typedef struct {
    exk_key_secret key;
    int64_t run_id;
    int64_t fresh_us;
    int64_t last_seq; /* of the last one taken, -1 before */
    exk_command_counts counts;
} exk_gate;

void exk_gate_init(exk_gate *gate, const exk_key_secret *key, int64_t run_id, int64_t fresh_us);

/** True: obey *out. now_us: wall clock. */
bool exk_gate_pass(exk_gate *gate, const void *data, size_t bytes, int64_t now_us,
                   exk_command *out);

typedef struct exk_inbox exk_inbox;

exk_inbox *exk_inbox_open(const char *url, const exk_gate *gate, char *why, size_t why_size);
void exk_inbox_close(exk_inbox *inbox); /* NULL is allowed */

/** Control thread: the next command that passed; false when there is none. */
bool exk_inbox_take(exk_inbox *inbox, exk_command *out);

/** Control thread: datagrams dropped by the system, as last looked at. */
int64_t exk_inbox_dropped(const exk_inbox *inbox);

/** Control thread: counts so far. */
void exk_inbox_counts(const exk_inbox *inbox, exk_command_counts *out);

#endif
