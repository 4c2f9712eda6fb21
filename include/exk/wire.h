/** The messages of the bus as plain structs: encoding, decoding, and nothing of LCM in sight.
 *
 *  Types    lcm_types/ has every field with unit and frame; here each becomes a struct whose values
 *           are those of the core. Doubles survive both ways bit for bit.
 *  Encode   into the caller's buffer; returns the bytes used, or -1 when they do not fit.
 *  Decode   accepts any bytes whatever. False, and nothing written, unless they are exactly one
 *           message of this type: fingerprint, length, counts inside the message, every string
 *           terminated, phase and state known.
 *  Memory   nothing is allocated but by exk_wire_job_decode; exk_wire_job_free releases it.
 */
#ifndef EXK_WIRE_H
#define EXK_WIRE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "exk/accuracy.h"
#include "exk/bus_counts.h"
#include "exk/fault_text.h"
#include "exk/loop.h"
#include "exk/loop_report.h"
#include "exk/profile.h"

#define EXK_CHANNEL_JOB "EXK_JOB"
#define EXK_CHANNEL_POSE "EXK_POSE"
#define EXK_CHANNEL_HOLE "EXK_HOLE"
#define EXK_CHANNEL_STATUS "EXK_STATUS"
#define EXK_CHANNEL_COMMAND "EXK_COMMAND"
#define EXK_CHANNEL_DRIVE "EXK_DRIVE"
#define EXK_CHANNEL_SENSOR "EXK_SENSOR"
#define EXK_CHANNEL_ALL "EXK_.*" /* pattern for exk_bus_subscribe */

enum { EXK_WIRE_POSE_MAX = 512, EXK_WIRE_HOLE_MAX = 256, EXK_WIRE_STATUS_MAX = 1536 };
enum { EXK_WIRE_DRIVE_MAX = 192, EXK_WIRE_SENSOR_MAX = 128, EXK_WIRE_COMMAND_MAX = 96 };
enum { EXK_WIRE_TEXT_MAX = 128 };

/** Which message of which run; the first fields of every message. */
typedef struct {
    int64_t run_id;
    int64_t seq;
    int64_t k;
    int64_t time_us;
} exk_wire_stamp;

typedef struct {
    int64_t run_id;
    int64_t seq;
    exk_sample sample; /* holds k and time_us */
    int64_t lateness_ns;
    int64_t step_ns;
} exk_wire_pose;

typedef struct {
    exk_wire_stamp stamp; /* k: of the sample that counted */
    int32_t hole;
    exk_hole target;
    exk_hole_result result;
    double tolerance_m;
    bool on_true;
} exk_wire_hole;

typedef struct {
    exk_wire_stamp stamp;
    int64_t utime_us;
    exk_state state;
    bool last;
    int32_t fault; /* exk_err */
    int64_t n_steps;
    int64_t n_overruns;
    int64_t n_bad;
    int64_t n_poses;
    int64_t n_dropped;
    int64_t ring_deepest;
    int32_t n_drilled;
    int32_t n_inside;
    int64_t lateness_ns[3]; /* median, 99 %, largest */
    int64_t step_ns[3];     /* the same */
    exk_bus_counts bus;
    exk_loop_report
        loop; /* of the fault: cause, quantity, index, value, limit, sample, k, hole */
    char reason[EXK_FAULT_TEXT_MAX];
    char rights[EXK_WIRE_TEXT_MAX];
} exk_wire_status;

typedef struct {
    exk_wire_stamp stamp;
    int64_t start_utime_us;
    uint64_t job_hash;
    uint64_t seed;
    uint32_t series;
    uint32_t run;
    int64_t n_ticks;
    int32_t every;
    double dt_s;
    double tolerance_m;
    exk_hole *holes;
    size_t n_holes;
    char profile_name[EXK_NAME_MAX];
    char kinematics[EXK_NAME_MAX];
    char controller[EXK_NAME_MAX];
    char *profile_text;
} exk_wire_job;

typedef enum { EXK_DRIVE_HELLO, EXK_DRIVE_STEP, EXK_DRIVE_BYE, EXK_DRIVE_COUNT } exk_drive_kind;

typedef struct {
    exk_wire_stamp stamp; /* k: -1 hello, -2 bye */
    int64_t session_id;
    exk_realisation which;
    exk_drive_kind kind;
    exk_drive drive;
} exk_wire_drive;

typedef struct {
    exk_wire_stamp stamp;
    int64_t drive_seq;
    int64_t session_id;
    int64_t machine_id;
    exk_reading reading; /* anything, NaN included: the loop's guard judges it */
} exk_wire_sensor;

enum { EXK_MAC_BYTES = 32 };

typedef struct {
    int64_t run_id;
    int64_t seq;
    int64_t utime_us;
    int8_t command; /* exk_command; any value may come */
    unsigned char mac[EXK_MAC_BYTES];
} exk_wire_command;

/** Room that encoding a job needs: n_holes ids and 2 n_holes row pointers, lent by the caller. */
typedef struct {
    int32_t *ids;
    double **rows;
} exk_wire_scratch;

int exk_wire_pose_encode(const exk_wire_pose *pose, void *buffer, size_t size);
bool exk_wire_pose_decode(const void *data, size_t bytes, exk_wire_pose *out);

int exk_wire_hole_encode(const exk_wire_hole *hole, void *buffer, size_t size);
bool exk_wire_hole_decode(const void *data, size_t bytes, exk_wire_hole *out);

int exk_wire_status_encode(const exk_wire_status *status, void *buffer, size_t size);
bool exk_wire_status_decode(const void *data, size_t bytes, exk_wire_status *out);

size_t exk_wire_job_bytes(const exk_wire_job *job);
int exk_wire_job_encode(const exk_wire_job *job, const exk_wire_scratch *scratch, void *buffer,
                        size_t size);
bool exk_wire_job_decode(const void *data, size_t bytes, exk_wire_job *out);
void exk_wire_job_free(exk_wire_job *job);

int exk_wire_drive_encode(const exk_wire_drive *drive, void *buffer, size_t size);
bool exk_wire_drive_decode(const void *data, size_t bytes, exk_wire_drive *out);

int exk_wire_sensor_encode(const exk_wire_sensor *sensor, void *buffer, size_t size);
bool exk_wire_sensor_decode(const void *data, size_t bytes, exk_wire_sensor *out);

int exk_wire_command_encode(const exk_wire_command *command, void *buffer, size_t size);
bool exk_wire_command_decode(const void *data, size_t bytes, exk_wire_command *out);

#endif
