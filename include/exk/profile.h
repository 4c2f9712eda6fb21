/** A profile: one experiment, one INI text, checked as a whole.
 *
 *  Text    [machine] [kinematics] [job] [disturbance.N] [sensor] [control] [loop] [guard] [limits]
 *          [fault.N] [telemetry] [command].
 *          Keys carry their unit (tolerance_mm); values here are SI. One table of keys gives the
 *          parser, the range checks, the defaults, --print, the job hash and the manual page.
 *  Errors  every fault of a text is collected, each with line, key, what was found and what is
 *          allowed; parse returns EXK_ERR_ARG when there is one, and the profile is not usable.
 *  Memory  the caller owns the struct; strings are inside it. This room reads no file.
 */
#ifndef EXK_PROFILE_H
#define EXK_PROFILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/err.h"
#include "exk/feedback.h"
#include "exk/geometry.h"
#include "exk/hole.h"
#include "exk/ilc.h"
#include "exk/inject.h"
#include "exk/job.h"
#include "exk/kinematics.h"
#include "exk/plan.h"
#include "exk/twin.h"

enum { EXK_PATH_MAX = 512, EXK_NAME_MAX = 64 };

typedef enum { EXK_JOB_RECTANGLE, EXK_JOB_GRID, EXK_JOB_CSV, EXK_JOB_COUNT } exk_job_kind;
typedef enum { EXK_ORDER_LISTED, EXK_ORDER_SERPENTINE, EXK_ORDER_COUNT } exk_hole_order;
typedef enum { EXK_FROM_TWIN, EXK_FROM_REPLAY, EXK_FROM_BUS, EXK_FROM_COUNT } exk_joint_from;

typedef struct {
    exk_job_kind kind;
    exk_pattern pattern;
    char file[EXK_PATH_MAX]; /* csv: relative to the profile's folder */
    exk_hole_order order;
    double row_gap_m;
    double tolerance_m;
    exk_plan_config plan; /* dt_s filled from [loop] rate_Hz */
} exk_job_config;

typedef struct {
    double rate_Hz;
    double dt_s; /* 1 / rate_Hz */
    uint64_t seed;
    exk_joint_from from;
    char replay_file[EXK_PATH_MAX];
    double answer_s;  /* longest wait for a machine on the bus */
    int n_missed_max; /* missed deadlines in a row that are a fault */
    int n_bad_max;    /* bad sensor samples in a row that are a fault */
    int priority;     /* SCHED_FIFO, 0: do not ask */
    int cpu;          /* -1: any */
    double spin_s;    /* spin the last part of each wait, 0: sleep only */
} exk_timing_config;

typedef struct {
    char url[EXK_PATH_MAX];
    int every;      /* publish every n-th pose */
    int ring_slots; /* power of two */
    double status_Hz;
} exk_telemetry_config;

typedef struct {
    double sigma_rad; /* of a good sample; 0: what sensor and disturbances give */
    double start_rad; /* offset of the first; 0: what disturbances give, INFINITY: any */
    double n_sigmas;  /* of a spike, INFINITY: not judged */
    double stuck_s;   /* 0: not judged */
    double retract_after_s;
} exk_guard_keys;

typedef struct {
    double following_rad;
    double following_time_s;
    double correction_rad;
    double rate_radps;
    double leg_speed_mps;
    double leg_margin_m; /* kept from both ends of the stroke (machine) */
    double box_min_m[3];
    double box_max_m[3];
} exk_limits_keys;

typedef struct {
    bool allow;
    char key_file[EXK_PATH_MAX]; /* relative to the profile's folder */
    double timeout_s;            /* hold without a valid command for so long; 0: never */
    double fresh_s;              /* oldest command that is taken */
    bool wait;                   /* rest until a valid start */
} exk_command_config;

typedef struct {
    char name[EXK_NAME_MAX]; /* the file's name without folder and .ini; set by the caller */
    exk_geometry geometry;
    exk_wrist_kind wrist;
    exk_kin_model model;
    exk_job_config job;
    exk_twin_config twin;
    exk_feedback_config feedback;
    exk_ilc_config ilc;
    exk_timing_config timing;
    exk_guard_keys guard;
    exk_limits_keys limits;
    exk_inject_config inject;
    exk_telemetry_config telemetry;
    exk_command_config command;
} exk_profile;

/** One fault of a text. line 0: the fault belongs to no line (a missing key). */
typedef struct {
    int line;
    char message[256]; /* what, found, allowed, what to do; no file name, no trailing newline */
} exk_fault;

exk_profile exk_profile_default(void);

/** Default height of the holes: z0 in the models P and U, z0 + e + t in the machine model. */
double exk_profile_plane_z(const exk_profile *profile);

/** Reads a whole text. profile is written on EXK_OK only, its name empty. faults is filled in line
 *  order up to capacity, those of line 0 first; n_faults counts them all. */
exk_err exk_profile_parse(const char *text, exk_profile *profile, exk_fault *faults,
                          size_t capacity, size_t *n_faults);

/** Writes the effective profile as a text that parse reads back to the same bits (as long as no
 *  text in it is longer than a line of 198 characters). Returns the length needed without the final
 *  NUL, like snprintf. */
size_t exk_profile_print(const exk_profile *profile, char *out, size_t size);

/** The canonical text that the job hash covers: [machine], [kinematics], [job] (but for the file,
 *  whose holes stand for it), dt_s and the holes, so that seed, noise, telemetry and gains may
 *  change. Returns the length as above. */
size_t exk_profile_job_text(const exk_profile *profile, const exk_hole *holes, size_t n_holes,
                            char *out, size_t size);

/** The table of keys as a page for people (Markdown): section, key, unit, range, default, meaning.
 *  Returns the length as above. */
size_t exk_profile_manual(char *out, size_t size);

#endif
