#include "exk/limits.h"

typedef enum { NO_PART, AN_ANGLE, A_LEG, A_COORDINATE } part_kind;

static const struct {
    const char *name;
    const char *unit;
    part_kind part;
    const char *advice;
} rows[EXK_QUANTITY_COUNT] = {
    [EXK_QUANTITY_NONE] = {"nothing", "", NO_PART, ""},
    [EXK_QUANTITY_ANGLE] = {"commanded angle", "rad", AN_ANGLE,
                            "look at the stored correction and at [control] c_max_mrad"},
    [EXK_QUANTITY_CORRECTION] = {"correction", "rad", AN_ANGLE,
                                 "look at the stored correction, or raise [limits] "
                                 "correction_mrad"},
    [EXK_QUANTITY_RATE] = {"commanded angle rate", "rad/s", AN_ANGLE,
                           "lower the feeds or the gains, or raise [limits] rate_radps"},
    [EXK_QUANTITY_LEG] = {"commanded leg length", "m", A_LEG,
                          "move the part, or look at [machine] and [limits] leg_margin_mm"},
    [EXK_QUANTITY_LEG_SPEED] = {"commanded leg speed", "m/s", A_LEG,
                                "lower the feeds, or raise [limits] leg_speed_mmps"},
    [EXK_QUANTITY_WORKSPACE] = {"reference tip", "m", A_COORDINATE,
                                "move the hole, or widen the box in [limits]"},
    [EXK_QUANTITY_FOLLOWING] = {"following error", "rad", AN_ANGLE,
                                "look at drives, brakes and load, or raise [limits] "
                                "following_mrad"},
    [EXK_QUANTITY_POSE] = {"pose", "", NO_PART, "move the hole or look at [machine]"},
    [EXK_QUANTITY_SAMPLES] = {"rejected sensor samples in a row", "", NO_PART,
                              "check encoder and cable, on the bus the machine's process and "
                              "the load of its host; status counts them by kind"},
    [EXK_QUANTITY_DEADLINES] = {"missed deadlines in a row", "", NO_PART,
                                "grant real-time rights, lower [loop] rate_Hz, or end other "
                                "programs"},
    [EXK_QUANTITY_CLOCK] = {"waits in a row that did not meet their tick", "", NO_PART,
                            "lower [loop] rate_Hz, or look at the clock of this host"},
};

static const char *const parts[][EXK_N_LEGS] = {
    [NO_PART] = {"", "", ""},
    [AN_ANGLE] = {"alpha", "beta", ""},
    [A_LEG] = {"leg 1", "leg 2", "leg 3"},
    [A_COORDINATE] = {"x", "y", "z"},
};

static exk_quantity known(exk_quantity quantity)
{
    return (unsigned)quantity < EXK_QUANTITY_COUNT ? quantity : EXK_QUANTITY_NONE;
}

const char *exk_quantity_name(exk_quantity quantity)
{
    return rows[known(quantity)].name;
}

const char *exk_quantity_unit(exk_quantity quantity)
{
    return rows[known(quantity)].unit;
}

const char *exk_quantity_part(exk_quantity quantity, int index)
{
    const bool named = index >= 0 && index < EXK_N_LEGS;
    return named ? parts[rows[known(quantity)].part][index] : "";
}

const char *exk_quantity_advice(exk_quantity quantity)
{
    return rows[known(quantity)].advice;
}
