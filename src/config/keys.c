#include "keys.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "exk/job_csv.h"
#include "exk/units.h"

static const exk_unit mm = {"mm", "mm", -3, false};
static const exk_unit mmps = {"mmps", "mm/s", -3, false};
static const exk_unit mmps2 = {"mmps2", "mm/s^2", -3, false};
static const exk_unit mrad = {"mrad", "mrad", -3, false};
static const exk_unit rad = {"rad", "rad", 0, false};
static const exk_unit radps = {"radps", "rad/s", 0, false};
static const exk_unit radps2 = {"radps2", "rad/s^2", 0, false};
static const exk_unit rad_per_sqrt_s = {"rad_per_sqrt_s", "rad/s^0.5", 0, false};
static const exk_unit rad_per_s_sqrt_s = {"rad_per_s_sqrt_s", "rad/s^1.5", 0, false};
static const exk_unit deg = {"deg", "deg", 0, true};
static const exk_unit sec = {"s", "s", 0, false};
static const exk_unit us = {"us", "us", -6, false};
static const exk_unit per_s = {"per_s", "1/s", 0, false};
static const exk_unit hertz = {"Hz", "Hz", 0, false};

static const char *const wrist_words[] = {"AB", "CA", NULL};
static const char *const model_words[] = {"pendulum", "universal", "machine", NULL};
static const char *const kind_words[] = {"rectangle", "grid", "csv", NULL};
static const char *const order_words[] = {"listed", "serpentine", NULL};
static const char *const yes_words[] = {"no", "yes", NULL};
static const char *const wave_words[] = {"none", "constant", "sine", "gaussian", NULL};
static const char *const channel_words[] = {"alpha", "beta", "both", NULL};
static const char *const repeat_words[] = {"fresh", "frozen", NULL};
static const char *const feedback_words[] = {"none", "pid", NULL};
static const char *const source_words[] = {"twin", "replay", "bus", NULL};

static const char *const inject_words[] = {"none",  "nan",     "inf",   "range",   "spike",
                                           "stuck", "dropout", "delay", "garbage", NULL};

static const exk_section sections[EXK_IN_COUNT] = {
    [EXK_IN_NOTHING] = {"", false, "", NULL},
    [EXK_IN_MACHINE] = {"machine", false, "The dimensions of the machine, and its servo.",
                        NULL},
    [EXK_IN_KINEMATICS] = {"kinematics", true, "How angles and tool point belong together.",
                           NULL},
    [EXK_IN_JOB] = {"job", true, "What is drilled, and how the tool moves.", NULL},
    [EXK_IN_DISTURBANCE] = {"disturbance.N", false,
                            "What pushes the angles, N = 1 to 8; the sum of all sections acts. "
                            "Give exactly the one amplitude or sigma that fits wave and order.",
                            "disturbance."},
    [EXK_IN_SENSOR] = {"sensor", false, "What the measured angles add to the true ones.", NULL},
    [EXK_IN_CONTROL] = {"control", false, "Feedback within a run and learning between runs.",
                        NULL},
    [EXK_IN_LOOP] = {"loop", false, "Rate, randomness, and when to give up.", NULL},
    [EXK_IN_GUARD] = {"guard", false,
                      "Which samples are believed, and what is done when none is.", NULL},
    [EXK_IN_LIMITS] = {"limits", false,
                       "What no command may pass; asked at every step before it is sent.",
                       NULL},
    [EXK_IN_FAULT] = {"fault.N", false,
                      "Faults put into the measured angles on purpose, N = 1 to 8.", "fault."},
    [EXK_IN_TELEMETRY] = {"telemetry", false, "What goes out on the bus.", NULL},
    [EXK_IN_COMMAND] = {"command", false,
                        "Who may start, stop, abort and clear a real-time run over the bus.",
                        NULL},
};

/* Bounds of a row: min, max, above, required, words, shown_default. */
#define FREE -DBL_MAX, DBL_MAX, false, false, NULL, NULL
#define AT_LEAST_0 0.0, DBL_MAX, false, false, NULL, NULL
#define ABOVE_0 0.0, DBL_MAX, true, false, NULL, NULL
#define ABOVE_0_TO(max) 0.0, max, true, false, NULL, NULL
#define RANGE(min, max) min, max, false, false, NULL, NULL
#define WORDS(words) 0.0, 0.0, false, false, words, NULL
#define NEEDED(words) 0.0, 0.0, false, true, words, NULL
#define LENGTH RANGE(EXK_LENGTH_MIN_M *EXK_MM_PER_M, MAX_MM)
#define MAX_MM (EXK_LENGTH_MAX_M * EXK_MM_PER_M)
#define COORDINATE RANGE(-MAX_MM, MAX_MM)
#define ANY_TEXT 0.0, 0.0, false, false, NULL, NULL

#define P(field) offsetof(exk_profile, field)
#define D(field) offsetof(exk_disturbance_config, field)
#define F(field) offsetof(exk_inject_fault, field)
#define NUM(key, unit, at, bounds, meaning)                                                    \
    {IN, key, EXK_KEY_NUMBER, &unit, at, bounds, meaning}
#define ROW(key, type, at, bounds, meaning)                                                    \
    {IN, key, EXK_KEY_##type, &exk_unit_none, at, bounds, meaning}

/* clang-format off: one key a line */
static const exk_key keys[] = {
#define IN EXK_IN_MACHINE
    NUM("d1_mm", mm, P(geometry.d1_m), LENGTH,
        "distance of the base joints of legs 1 and 3; p1 = d1/(2 d5) in 0.5 to 0.8"),
    NUM("d2_mm", mm, P(geometry.d2_m), LENGTH,
        "base joint of leg 2 from the middle of legs 1 and 3; p2 = d2/d1 in 0.5 to 1"),
    NUM("d3_mm", mm, P(geometry.d3_m), LENGTH,
        "distance of the platform joints of legs 1 and 3; p3 = 2 d3/d1 in 0.5 to 1"),
    NUM("d4_mm", mm, P(geometry.d4_m), LENGTH,
        "platform joint of leg 2 from the middle of legs 1 and 3; p4 = d4/d3 = 0.75"),
    NUM("d5_mm", mm, P(geometry.d5_m), LENGTH, "stroke of a leg"),
    NUM("l_min_mm", mm, P(geometry.l_min_m), LENGTH, "shortest leg; the longest is l_min + d5"),
    NUM("angle_max_deg", deg, P(geometry.angle_max_rad), ABOVE_0_TO(60.0),
        "limit of alpha and beta, both ways"),
    NUM("z0_mm", mm, P(geometry.z0_m), LENGTH,
        "working height of the plate (pendulum, universal), home height (machine)"),
    NUM("e_mm", mm, P(geometry.e_m), RANGE(0.0, MAX_MM),
        "platform to wrist centre, along the platform normal"),
    NUM("f_mm", mm, P(geometry.f_m), RANGE(-MAX_MM, MAX_MM),
        "platform to wrist centre, along O1-B2"),
    NUM("t_mm", mm, P(geometry.t_m), RANGE(0.0, MAX_MM), "wrist centre to tool tip"),
    ROW("wrist", WORD, P(wrist), WORDS(wrist_words),
        "axes of the wrist (machine); CA is singular with the tool along the platform normal"),
    NUM("servo_tau_s", sec, P(twin.servo_tau_s), AT_LEAST_0,
        "time constant of the drives' first-order lag; 0: none"),
#undef IN
#define IN EXK_IN_KINEMATICS
    ROW("model", WORD, P(model), NEEDED(model_words),
        "pendulum: the study's two angles; universal: its alternative; machine: tripod and "
        "wrist"),
#undef IN
#define IN EXK_IN_JOB
    ROW("kind", WORD, P(job.kind), NEEDED(kind_words),
        "four corners, rows and columns, or holes from a file"),
    NUM("width_mm", mm, P(job.pattern.width_m), ABOVE_0, "size along X (rectangle, grid)"),
    NUM("height_mm", mm, P(job.pattern.height_m), ABOVE_0, "size along Y (rectangle, grid)"),
    ROW("rows", INTEGER, P(job.pattern.rows), RANGE(1, EXK_MAX_HOLES), "rows along Y (grid)"),
    ROW("columns", INTEGER, P(job.pattern.columns), RANGE(1, EXK_MAX_HOLES),
        "columns along X (grid)"),
    NUM("center_x_mm", mm, P(job.pattern.center_m[EXK_X]), FREE, "middle of the pattern"),
    NUM("center_y_mm", mm, P(job.pattern.center_m[EXK_Y]), FREE, "middle of the pattern"),
    {IN, "plane_z_mm", EXK_KEY_NUMBER, &mm, P(job.pattern.center_m[EXK_Z]), -DBL_MAX, DBL_MAX,
     false, false, NULL, "z0; machine: z0 + e + t",
     "height of the holes; a CSV may give its own"},
    ROW("file", TEXT, P(job.file), ANY_TEXT, "CSV of holes, beside the profile (kind csv)"),
    ROW("order", WORD, P(job.order), WORDS(order_words),
        "as listed, or row by row there and back"),
    NUM("row_gap_mm", mm, P(job.row_gap_m), AT_LEAST_0,
        "serpentine: a step in Y above this starts a row"),
    NUM("tolerance_mm", mm, P(job.tolerance_m), ABOVE_0,
        "radius round the target that counts as inside"),
    ROW("closed", FLAG, P(job.plan.closed), WORDS(yes_words),
        "travel back over the first hole at the end"),
    NUM("feed_mmps", mmps, P(job.plan.feed_mps), ABOVE_0, "speed between holes"),
    NUM("approach_mmps", mmps, P(job.plan.approach_mps), ABOVE_0,
        "speed over the clearance, towards the part"),
    NUM("drill_mmps", mmps, P(job.plan.drill_mps), ABOVE_0,
        "speed of the stroke into the part"),
    NUM("retract_mmps", mmps, P(job.plan.retract_mps), ABOVE_0, "speed out of the part"),
    NUM("accel_mmps2", mmps2, P(job.plan.accel_mps2), ABOVE_0_TO((double)INFINITY),
        "acceleration along each move; inf: constant speed, no ramp"),
    NUM("clearance_mm", mm, P(job.plan.clearance_m), AT_LEAST_0,
        "distance kept from the part while travelling"),
    NUM("stroke_mm", mm, P(job.plan.stroke_m), AT_LEAST_0, "depth drilled"),
    NUM("dwell_s", sec, P(job.plan.dwell_s), AT_LEAST_0,
        "rest over the hole before the stroke; its last sample is judged"),
#undef IN
#define IN EXK_IN_DISTURBANCE
    ROW("wave", WORD, D(wave), NEEDED(wave_words), "form of the disturbance"),
    ROW("order", INTEGER, D(order), RANGE(0, 2),
        "0: acts on the angle, 1: on its rate, 2: on its acceleration"),
    ROW("channel", CHANNEL, D(channel), WORDS(channel_words),
        "which angle; gaussian draws each its own"),
    NUM("amplitude_rad", rad, D(amplitude), FREE, "constant, sine, order 0"),
    NUM("amplitude_radps", radps, D(amplitude), FREE, "constant, sine, order 1"),
    NUM("amplitude_radps2", radps2, D(amplitude), FREE, "constant, sine, order 2"),
    NUM("sigma_rad", rad, D(amplitude), AT_LEAST_0,
        "gaussian, order 0; per sample, so that results depend on the rate"),
    NUM("sigma_rad_per_sqrt_s", rad_per_sqrt_s, D(amplitude), AT_LEAST_0, "gaussian, order 1"),
    NUM("sigma_rad_per_s_sqrt_s", rad_per_s_sqrt_s, D(amplitude), AT_LEAST_0,
        "gaussian, order 2"),
    NUM("freq_Hz", hertz, D(freq_Hz), AT_LEAST_0, "sine: needed"),
    NUM("phase_deg", deg, D(phase_rad), FREE, "sine: phase at the start of a run"),
    ROW("repeat", FLAG, D(frozen), WORDS(repeat_words),
        "gaussian: frozen draws the same in every run of a series, fresh a new one"),
#undef IN
#define IN EXK_IN_SENSOR
    NUM("sigma_rad", rad, P(twin.sensor_sigma_rad), AT_LEAST_0, "normal noise of each sample"),
    NUM("quantum_rad", rad, P(twin.sensor_quantum_rad), AT_LEAST_0,
        "step of the encoder; 0: none"),
    ROW("repeat", FLAG, P(twin.sensor_frozen), WORDS(repeat_words), "as for a disturbance"),
#undef IN
#define IN EXK_IN_CONTROL
    ROW("feedback", WORD, P(feedback.kind), WORDS(feedback_words), "correction within a run"),
    NUM("kp", exk_unit_none, P(feedback.pid.kp), RANGE(0.0, 1.0), "proportional gain, below 1"),
    NUM("ki_per_s", per_s, P(feedback.pid.ki), AT_LEAST_0,
        "integral gain, ki dt below 2 (1 - kp)"),
    NUM("kd_s", sec, P(feedback.pid.kd), AT_LEAST_0, "derivative gain"),
    NUM("d_filter_s", sec, P(feedback.pid.d_filter_s), AT_LEAST_0,
        "time constant of the derivative's filter; 0: none"),
    NUM("c_max_mrad", mrad, P(feedback.pid.c_max_rad), ABOVE_0,
        "limit of the correction, both ways"),
    NUM("ilc_gain", exk_unit_none, P(ilc.gain), ABOVE_0_TO(2.0),
        "share of the error learned from a run"),
    NUM("ilc_d_gain_s", sec, P(ilc.d_gain_s), AT_LEAST_0,
        "learning from the error's slope; 0: none"),
    ROW("ilc_lead", INTEGER, P(ilc.lead), RANGE(0, EXK_ILC_LEAD_MAX),
        "samples that the error is read ahead, for a servo lag"),
    NUM("ilc_cutoff_Hz", hertz, P(ilc.cutoff_Hz), AT_LEAST_0,
        "zero-phase low-pass of what was learned, below rate/4; 0: none"),
    NUM("ilc_max_mrad", mrad, P(ilc.u_max_rad), ABOVE_0,
        "limit of the stored correction, both ways"),
#undef IN
#define IN EXK_IN_LOOP
    NUM("rate_Hz", hertz, P(timing.rate_Hz), RANGE(1.0, 40000.0), "steps a second"),
    ROW("seed", SEED, P(timing.seed), ANY_TEXT, "names the realisation of all random numbers"),
    ROW("source", WORD, P(timing.from), WORDS(source_words),
        "where the measured angles come from; bus: a machine, or exk-twin, on [telemetry] url"),
    NUM("answer_s", sec, P(timing.answer_s), RANGE(1e-3, 60.0),
        "longest wait for a machine on the bus: at the start, and each tick of --fast"),
    ROW("replay_file", TEXT, P(timing.replay_file), ANY_TEXT,
        "log to read them from (source replay)"),
    ROW("missed_max", INTEGER, P(timing.n_missed_max), RANGE(1, 1000000),
        "missed deadlines in a row that are a fault"),
    ROW("bad_max", INTEGER, P(timing.n_bad_max), RANGE(1, 1000000),
        "rejected sensor samples in a row that are a fault"),
    ROW("priority", INTEGER, P(timing.priority), RANGE(0, 99),
        "real-time priority (SCHED_FIFO); 0: ordinary"),
    ROW("cpu", INTEGER, P(timing.cpu), RANGE(-1, 1023), "processor the loop stays on; -1: any"),
    NUM("spin_us", us, P(timing.spin_s), RANGE(0.0, 1e6),
        "end of each wait that is spun, not slept"),
#undef IN
#define IN EXK_IN_GUARD
    {IN, "sigma_rad", EXK_KEY_NUMBER, &rad, P(guard.sigma_rad), 0.0, 1.0, false, false, NULL,
     "0: from [sensor] and [disturbance.N]",
     "how far a good sample is from what was expected, one sigma"},
    {IN, "start_mrad", EXK_KEY_NUMBER, &mrad, P(guard.start_rad), 0.0, (double)INFINITY, false,
     false, NULL, "0: from [disturbance.N]",
     "how far the first sample may be from the command beside its noise; inf: any"},
    NUM("spike_sigmas", exk_unit_none, P(guard.n_sigmas), ABOVE_0_TO((double)INFINITY),
        "a sample farther off than this is a spike; inf: none is. A replay is judged only with "
        "sigma_rad"),
    NUM("stuck_s", sec, P(guard.stuck_s), AT_LEAST_0,
        "the same value for so long is stuck, while the reference moves or noise should show; "
        "0: never"),
    NUM("retract_after_s", sec, P(guard.retract_after_s), RANGE(0.0, 3600.0),
        "rest between a sensor fault and the way out of the part"),
#undef IN
#define IN EXK_IN_LIMITS
    NUM("following_mrad", mrad, P(limits.following_rad), ABOVE_0_TO((double)INFINITY),
        "commanded less measured angle, at rest; set it on a machine"),
    NUM("following_s", sec, P(limits.following_time_s), AT_LEAST_0,
        "what the commanded rate adds to it: the lag that is allowed"),
    NUM("correction_mrad", mrad, P(limits.correction_rad), ABOVE_0_TO((double)INFINITY),
        "feedback and stored correction together"),
    NUM("rate_radps", radps, P(limits.rate_radps), ABOVE_0_TO((double)INFINITY),
        "commanded angle rate"),
    NUM("leg_speed_mmps", mmps, P(limits.leg_speed_mps), ABOVE_0_TO((double)INFINITY),
        "commanded leg speed"),
    NUM("leg_margin_mm", mm, P(limits.leg_margin_m), AT_LEAST_0,
        "kept from both ends of the stroke (machine)"),
    NUM("x_min_mm", mm, P(limits.box_min_m[EXK_X]), COORDINATE, "box round the tool tip"),
    NUM("x_max_mm", mm, P(limits.box_max_m[EXK_X]), COORDINATE, "box round the tool tip"),
    NUM("y_min_mm", mm, P(limits.box_min_m[EXK_Y]), COORDINATE, "box round the tool tip"),
    NUM("y_max_mm", mm, P(limits.box_max_m[EXK_Y]), COORDINATE, "box round the tool tip"),
    NUM("z_min_mm", mm, P(limits.box_min_m[EXK_Z]), COORDINATE, "box round the tool tip"),
    NUM("z_max_mm", mm, P(limits.box_max_m[EXK_Z]), COORDINATE, "box round the tool tip"),
#undef IN
#define IN EXK_IN_FAULT
    ROW("kind", WORD, F(kind), NEEDED(inject_words), "what becomes of the sample"),
    ROW("channel", CHANNEL, F(channel), WORDS(channel_words),
        "which angle; dropout and delay: always both"),
    NUM("at_s", sec, F(at_s), RANGE(0.0, 1e6), "begin, from tick 0"),
    NUM("for_s", sec, F(for_s), RANGE(0.0, 1e6), "how long; one sample at least"),
    NUM("size_mrad", mrad, F(size_rad), FREE, "height (spike)"),
    NUM("delay_s", sec, F(delay_s), RANGE(0.0, 1e3), "how late (delay), at most 255 ticks"),
#undef IN
#define IN EXK_IN_TELEMETRY
    ROW("url", TEXT, P(telemetry.url), ANY_TEXT,
        "LCM provider; ttl=0 keeps the traffic on this host"),
    ROW("every", INTEGER, P(telemetry.every), RANGE(1, 1000000), "publish every n-th pose"),
    ROW("ring_slots", INTEGER, P(telemetry.ring_slots), RANGE(2, 4194304),
        "samples between loop and publisher, a power of two"),
    NUM("status_Hz", hertz, P(telemetry.status_Hz), ABOVE_0_TO(1000.0),
        "status messages a second"),
#undef IN
#define IN EXK_IN_COMMAND
    ROW("allow", FLAG, P(command.allow), WORDS(yes_words),
        "take commands that carry the right keyed hash; no: none is looked at"),
    ROW("key_file", TEXT, P(command.key_file), ANY_TEXT,
        "key of the hash, beside the profile, readable by its owner alone; exk-command keygen "
        "makes one"),
    NUM("timeout_s", sec, P(command.timeout_s), RANGE(0.0, 3600.0),
        "hold when no valid command came for so long; 0: no stream is asked for"),
    NUM("fresh_s", sec, P(command.fresh_s), RANGE(1e-3, 60.0),
        "oldest command that is taken, by the wall clocks of both ends"),
    ROW("wait", FLAG, P(command.wait), WORDS(yes_words), "rest until a valid start"),
#undef IN
};
/* clang-format on */

_Static_assert(sizeof(keys) / sizeof(keys[0]) <= EXK_KEYS_MAX, "raise EXK_KEYS_MAX");
_Static_assert((int)EXK_MAX_DISTURBANCES <= (int)EXK_INSTANCES_MAX &&
                   (int)EXK_MAX_INJECTED <= (int)EXK_INSTANCES_MAX,
               "raise EXK_INSTANCES_MAX");
_Static_assert(sizeof(exk_inject_kind) == sizeof(int), "value.c reads and writes enums as int");
_Static_assert(sizeof(exk_wave) == sizeof(int) && sizeof(exk_job_kind) == sizeof(int),
               "value.c reads and writes enums as int");

size_t exk_key_count(void)
{
    return sizeof(keys) / sizeof(keys[0]);
}

const exk_key *exk_key_at(size_t i)
{
    return &keys[i];
}

const exk_section *exk_section_of(exk_section_id id)
{
    return &sections[id];
}

size_t exk_key_find(exk_section_id section, const char *name)
{
    size_t i = 0;
    while (i < exk_key_count() &&
           (keys[i].section != section || strcmp(keys[i].name, name) != 0)) {
        i++;
    }
    return i;
}

const void *exk_key_base(const exk_profile *profile, exk_section_id section, int instance)
{
    if (section == EXK_IN_DISTURBANCE) {
        return &profile->twin.disturbance[instance];
    }
    return section == EXK_IN_FAULT ? (const void *)&profile->inject.fault[instance]
                                   : (const void *)profile;
}

int exk_section_instances(const exk_profile *profile, exk_section_id section)
{
    if (section == EXK_IN_DISTURBANCE) {
        return (int)profile->twin.n_disturbances;
    }
    return section == EXK_IN_FAULT ? (int)profile->inject.n_faults : 1;
}

bool exk_key_is_amplitude(const exk_key *key)
{
    return key->section == EXK_IN_DISTURBANCE && key->offset == D(amplitude);
}

const char *exk_amplitude_name(exk_wave wave, int order)
{
    static const char *const amplitude[] = {"amplitude_rad", "amplitude_radps",
                                            "amplitude_radps2"};
    static const char *const sigma[] = {"sigma_rad", "sigma_rad_per_sqrt_s",
                                        "sigma_rad_per_s_sqrt_s"};
    if (order < 0 || order > 2 || wave == EXK_WAVE_NONE) {
        return NULL;
    }
    return wave == EXK_WAVE_GAUSSIAN ? sigma[order] : amplitude[order];
}
