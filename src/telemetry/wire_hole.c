#include "exk/wire.h"

#include <string.h>

#include "exk_hole_t.h"

int exk_wire_hole_encode(const exk_wire_hole *hole, void *buffer, size_t size)
{
    const exk_hole_result *r = &hole->result;
    exk_hole_t m = {
        .run_id = hole->stamp.run_id,
        .seq = hole->stamp.seq,
        .k = hole->stamp.k,
        .time_us = hole->stamp.time_us,
        .hole = hole->hole,
        .hole_id = hole->target.id,
        .dx_m = r->dx_m,
        .dy_m = r->dy_m,
        .radial_m = r->radial_m,
        .tilt_rad = r->tilt_rad,
        .tolerance_m = hole->tolerance_m,
        .inside = r->inside,
        .on_true = hole->on_true,
    };
    memcpy(m.target_m, hole->target.target_m, sizeof m.target_m);
    memcpy(m.axis, hole->target.axis, sizeof m.axis);
    memcpy(m.tip_m, r->tip_m, sizeof m.tip_m);
    return exk_hole_t_encode(buffer, 0, (int)size, &m);
}

static void unpack_result(exk_hole_result *r, const exk_hole_t *m)
{
    r->drilled = true;
    r->inside = m->inside;
    r->k = m->k;
    memcpy(r->tip_m, m->tip_m, sizeof r->tip_m);
    r->dx_m = m->dx_m;
    r->dy_m = m->dy_m;
    r->radial_m = m->radial_m;
    r->tilt_rad = m->tilt_rad;
}

bool exk_wire_hole_decode(const void *data, size_t bytes, exk_wire_hole *out)
{
    exk_hole_t m;
    if (bytes > EXK_WIRE_HOLE_MAX || exk_hole_t_decode(data, 0, (int)bytes, &m) != (int)bytes) {
        return false;
    }
    memset(out, 0, sizeof *out);
    out->stamp = (exk_wire_stamp){m.run_id, m.seq, m.k, m.time_us};
    out->hole = m.hole;
    out->target.id = m.hole_id;
    memcpy(out->target.target_m, m.target_m, sizeof m.target_m);
    memcpy(out->target.axis, m.axis, sizeof m.axis);
    unpack_result(&out->result, &m);
    out->tolerance_m = m.tolerance_m;
    out->on_true = m.on_true;
    return true;
}
