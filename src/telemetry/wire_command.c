#include <string.h>

#include "exk/wire.h"
#include "exk_command_t.h"

int exk_wire_command_encode(const exk_wire_command *command, void *buffer, size_t size)
{
    exk_command_t m = {
        .run_id = command->run_id,
        .seq = command->seq,
        .utime_us = command->utime_us,
        .command = command->command,
    };
    _Static_assert(sizeof m.mac == EXK_MAC_BYTES, "length of the keyed hash on the wire");
    memcpy(m.mac, command->mac, sizeof m.mac);
    return exk_command_t_encode(buffer, 0, (int)size, &m);
}

bool exk_wire_command_decode(const void *data, size_t bytes, exk_wire_command *out)
{
    exk_command_t m;
    if (bytes > EXK_WIRE_COMMAND_MAX ||
        exk_command_t_decode(data, 0, (int)bytes, &m) != (int)bytes) {
        return false;
    }
    *out = (exk_wire_command){
        .run_id = m.run_id, .seq = m.seq, .utime_us = m.utime_us, .command = m.command};
    memcpy(out->mac, m.mac, sizeof m.mac);
    return true;
}
