#include "exk/fault_text.h"

#include <inttypes.h>
#include <stdio.h>

enum { WHERE_SIZE = 80, WHAT_SIZE = 160 };

static void say_where(const exk_fault_report *r, char out[WHERE_SIZE])
{
    if (r->hole_id < 0) {
        snprintf(out, WHERE_SIZE, "tick %" PRId64, r->k);
    } else {
        snprintf(out, WHERE_SIZE, "tick %" PRId64 ", %s of hole %" PRId32, r->k,
                 exk_phase_name(r->phase), r->hole_id);
    }
}

static void say_samples(const exk_fault_report *r, char out[WHAT_SIZE])
{
    const char *part = exk_quantity_part(EXK_QUANTITY_ANGLE, r->what.index);
    snprintf(out, WHAT_SIZE, "%s: %.0f, limit %.0f, the last one %s%s%s",
             exk_quantity_name(r->what.quantity), r->what.value, r->what.limit,
             exk_sample_kind_name(r->sample), part[0] == '\0' ? "" : " in ", part);
}

static void say_quantity(const exk_fault_report *r, char out[WHAT_SIZE])
{
    const exk_violation *v = &r->what;
    const char *part = exk_quantity_part(v->quantity, v->index);
    const char *unit = exk_quantity_unit(v->quantity);
    const char *space = unit[0] == '\0' ? "" : " ";
    snprintf(out, WHAT_SIZE, "%s%s%s: %.6g%s%s, limit %.6g%s%s", exk_quantity_name(v->quantity),
             part[0] == '\0' ? "" : " of ", part, v->value, space, unit, v->limit, space, unit);
}

static void say_what(const exk_fault_report *r, char out[WHAT_SIZE])
{
    switch (r->what.quantity) {
    case EXK_QUANTITY_SAMPLES:
        say_samples(r, out);
        return;
    case EXK_QUANTITY_NONE:
    case EXK_QUANTITY_POSE:
    case EXK_QUANTITY_COUNT:
        snprintf(out, WHAT_SIZE, "%s", exk_err_name(r->err));
        return;
    case EXK_QUANTITY_ANGLE:
    case EXK_QUANTITY_CORRECTION:
    case EXK_QUANTITY_RATE:
    case EXK_QUANTITY_LEG:
    case EXK_QUANTITY_LEG_SPEED:
    case EXK_QUANTITY_WORKSPACE:
    case EXK_QUANTITY_FOLLOWING:
    case EXK_QUANTITY_DEADLINES:
    case EXK_QUANTITY_CLOCK:
        break;
    }
    say_quantity(r, out);
}

static const char *advice_of(const exk_fault_report *r)
{
    if (r->err == EXK_ERR_SILENT) {
        return "is its process, for example exk-twin, still there, and does it say why? [loop] "
               "answer_s is how long it is waited for";
    }
    return exk_quantity_advice(r->what.quantity);
}

void exk_fault_text(const exk_fault_report *r, char *out, size_t size)
{
    char where[WHERE_SIZE];
    char what[WHAT_SIZE];
    const char *advice = advice_of(r);
    say_where(r, where);
    say_what(r, what);
    snprintf(out, size, "%s; %s%s%s", what, where, advice[0] == '\0' ? "" : "; ", advice);
}
