#include <sodium.h>
#include <string.h>

#include "exk/command.h"

_Static_assert(EXK_KEY_BYTES == crypto_auth_KEYBYTES, "length of the key");
_Static_assert(EXK_MAC_BYTES == crypto_auth_BYTES, "length of the keyed hash");

enum { MAGIC_BYTES = 8, SIGNED_BYTES = MAGIC_BYTES + 3 * 8 + 1 };

static const char *const command_names[EXK_COMMAND_COUNT] = {
    [EXK_COMMAND_ALIVE] = "alive", [EXK_COMMAND_START] = "start", [EXK_COMMAND_STOP] = "stop",
    [EXK_COMMAND_ABORT] = "abort", [EXK_COMMAND_CLEAR] = "clear",
};

static const char *const refusal_names[EXK_REFUSED_COUNT] = {
    [EXK_REFUSED_MALFORMED] = "malformed", [EXK_REFUSED_RUN] = "other run",
    [EXK_REFUSED_KEY] = "wrong key",       [EXK_REFUSED_STALE] = "stale",
    [EXK_REFUSED_REPLAYED] = "replayed",   [EXK_REFUSED_UNKNOWN] = "unknown",
    [EXK_REFUSED_FULL] = "too many",
};

const char *exk_command_name(exk_command command)
{
    return (unsigned)command < EXK_COMMAND_COUNT ? command_names[command] : "unknown";
}

const char *exk_refusal_name(exk_refusal refusal)
{
    return (unsigned)refusal < EXK_REFUSED_COUNT ? refusal_names[refusal] : "unknown";
}

bool exk_command_find(const char *name, exk_command *out)
{
    for (int i = 0; i < EXK_COMMAND_COUNT; i++) {
        if (strcmp(name, command_names[i]) == 0) {
            *out = (exk_command)i;
            return true;
        }
    }
    return false;
}

static unsigned char *put(unsigned char *at, int64_t value)
{
    for (int i = 0; i < 8; i++) {
        at[i] = (unsigned char)((uint64_t)value >> (8 * i));
    }
    return at + 8;
}

static void lay_out(const exk_wire_command *command, unsigned char bytes[SIGNED_BYTES])
{
    memcpy(bytes, "EXKCMD01", MAGIC_BYTES);
    unsigned char *at = put(bytes + MAGIC_BYTES, command->run_id);
    at = put(at, command->seq);
    at = put(at, command->utime_us);
    *at = (unsigned char)command->command;
}

void exk_command_sign(exk_wire_command *command, const exk_key_secret *key)
{
    unsigned char bytes[SIGNED_BYTES];
    lay_out(command, bytes);
    crypto_auth(command->mac, bytes, sizeof bytes, key->bytes);
}

void exk_gate_init(exk_gate *gate, const exk_key_secret *key, int64_t run_id, int64_t fresh_us)
{
    *gate = (exk_gate){.key = *key, .run_id = run_id, .fresh_us = fresh_us, .last_seq = -1};
}

static bool is_ours(const exk_gate *gate, const exk_wire_command *m)
{
    unsigned char bytes[SIGNED_BYTES];
    lay_out(m, bytes);
    return crypto_auth_verify(m->mac, bytes, sizeof bytes, gate->key.bytes) == 0;
}

/* utime_us has a good hash by now, but the sender's clock may be anywhere: no overflow. */
static bool is_fresh(const exk_gate *gate, int64_t utime_us, int64_t now_us)
{
    return utime_us >= now_us - gate->fresh_us && utime_us <= now_us + gate->fresh_us;
}

static exk_refusal judge(const exk_gate *gate, const exk_wire_command *m, int64_t now_us)
{
    if (m->run_id != gate->run_id) {
        return EXK_REFUSED_RUN;
    }
    if (!is_ours(gate, m)) {
        return EXK_REFUSED_KEY;
    }
    if (!is_fresh(gate, m->utime_us, now_us)) {
        return EXK_REFUSED_STALE;
    }
    if (m->seq <= gate->last_seq) {
        return EXK_REFUSED_REPLAYED;
    }
    if (m->command < 0 || m->command >= (int)EXK_COMMAND_COUNT) {
        return EXK_REFUSED_UNKNOWN;
    }
    return EXK_REFUSED_COUNT;
}

bool exk_gate_pass(exk_gate *gate, const void *data, size_t bytes, int64_t now_us,
                   exk_command *out)
{
    exk_wire_command m;
    exk_refusal refusal = EXK_REFUSED_MALFORMED;
    if (exk_wire_command_decode(data, bytes, &m)) {
        refusal = judge(gate, &m, now_us);
    }
    if (refusal != EXK_REFUSED_COUNT) {
        gate->counts.n_refused[refusal]++;
        return false;
    }
    gate->last_seq = m.seq;
    gate->counts.n_taken++;
    gate->counts.last_seq = m.seq;
    *out = (exk_command)m.command;
    return true;
}
