#include <string.h>

#include "exk/wire.h"
#include "exk_drive_t.h"

_Static_assert(EXK_DRIVE_T_HELLO == (int)EXK_DRIVE_HELLO, "kinds on the wire");
_Static_assert(EXK_DRIVE_T_STEP == (int)EXK_DRIVE_STEP, "kinds on the wire");
_Static_assert(EXK_DRIVE_T_BYE == (int)EXK_DRIVE_BYE, "kinds on the wire");

int exk_wire_drive_encode(const exk_wire_drive *drive, void *buffer, size_t size)
{
    exk_drive_t m = {
        .run_id = drive->stamp.run_id,
        .seq = drive->stamp.seq,
        .k = drive->stamp.k,
        .time_us = drive->stamp.time_us,
        .session_id = drive->session_id,
        .seed = (int64_t)drive->which.seed,
        .series = (int32_t)drive->which.series,
        .run = (int32_t)drive->which.run,
        .kind = (int8_t)drive->kind,
    };
    memcpy(m.angle_rad, drive->drive.angle_rad, sizeof m.angle_rad);
    memcpy(m.legs_m, drive->drive.legs_m, sizeof m.legs_m);
    memcpy(m.wrist_rad, drive->drive.wrist_rad, sizeof m.wrist_rad);
    return exk_drive_t_encode(buffer, 0, (int)size, &m);
}

static bool tick_fits(const exk_drive_t *m)
{
    switch (m->kind) {
    case EXK_DRIVE_T_HELLO:
        return m->k == -1;
    case EXK_DRIVE_T_STEP:
        return m->k >= 0;
    case EXK_DRIVE_T_BYE:
        return m->k == -2;
    default:
        return false;
    }
}

/* No part of variable length: one length is right and all others are wrong. */
bool exk_wire_drive_decode(const void *data, size_t bytes, exk_wire_drive *out)
{
    exk_drive_t m;
    if (bytes > EXK_WIRE_DRIVE_MAX ||
        exk_drive_t_decode(data, 0, (int)bytes, &m) != (int)bytes || !tick_fits(&m)) {
        return false;
    }
    *out = (exk_wire_drive){
        .stamp = {m.run_id, m.seq, m.k, m.time_us},
        .session_id = m.session_id,
        .which = {.seed = (uint64_t)m.seed,
                  .series = (uint32_t)m.series,
                  .run = (uint32_t)m.run},
        .kind = (exk_drive_kind)m.kind,
    };
    memcpy(out->drive.angle_rad, m.angle_rad, sizeof m.angle_rad);
    memcpy(out->drive.legs_m, m.legs_m, sizeof m.legs_m);
    memcpy(out->drive.wrist_rad, m.wrist_rad, sizeof m.wrist_rad);
    return true;
}
