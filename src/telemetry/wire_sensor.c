#include <string.h>

#include "exk/wire.h"
#include "exk_sensor_t.h"

int exk_wire_sensor_encode(const exk_wire_sensor *sensor, void *buffer, size_t size)
{
    exk_sensor_t m = {
        .run_id = sensor->stamp.run_id,
        .seq = sensor->stamp.seq,
        .k = sensor->stamp.k,
        .time_us = sensor->stamp.time_us,
        .drive_seq = sensor->drive_seq,
        .session_id = sensor->session_id,
        .machine_id = sensor->machine_id,
        .fresh = sensor->reading.fresh,
        .age = sensor->reading.age,
        .has_true = sensor->reading.has_true,
    };
    memcpy(m.measured_rad, sensor->reading.measured_rad, sizeof m.measured_rad);
    memcpy(m.true_rad, sensor->reading.true_rad, sizeof m.true_rad);
    return exk_sensor_t_encode(buffer, 0, (int)size, &m);
}

/* A sample older than any run; keeps sums of ages far from overflow. */
static const int64_t age_max = (int64_t)1 << 40;

/* No part of variable length: one length is right and all others are wrong. */
bool exk_wire_sensor_decode(const void *data, size_t bytes, exk_wire_sensor *out)
{
    exk_sensor_t m;
    if (bytes > EXK_WIRE_SENSOR_MAX ||
        exk_sensor_t_decode(data, 0, (int)bytes, &m) != (int)bytes || m.k < -1 || m.seq < 0 ||
        m.age < 0 || m.age > age_max) {
        return false;
    }
    *out = (exk_wire_sensor){
        .stamp = {m.run_id, m.seq, m.k, m.time_us},
        .drive_seq = m.drive_seq,
        .session_id = m.session_id,
        .machine_id = m.machine_id,
        .reading = {.fresh = m.fresh != 0, .age = m.age, .has_true = m.has_true != 0},
    };
    memcpy(out->reading.measured_rad, m.measured_rad, sizeof m.measured_rad);
    memcpy(out->reading.true_rad, m.true_rad, sizeof m.true_rad);
    return true;
}
