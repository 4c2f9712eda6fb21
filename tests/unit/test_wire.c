#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exk/wire.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* Numbers that text or float formats would damage, NaN with a payload among them. */
static double awkward(int i)
{
    static const uint64_t bits[] = {
        0x3FB999999999999AU, /* 0.1 */
        0x8000000000000000U, /* -0 */
        0x0000000000000001U, /* smallest denormal */
        0x7FEFFFFFFFFFFFFFU, /* largest */
        0x7FF0000000000000U, /* infinity */
        0x7FF80000DEADBEEFU, /* NaN with a payload */
        0x3FF0000000000001U, /* 1 and one bit */
        0xC00921FB54442D18U, /* -pi */
    };
    const uint64_t b = bits[i % 8] ^ (i % 8 == 6 ? (uint64_t)i << 4 : 0);
    double out;
    memcpy(&out, &b, sizeof out);
    return out;
}

/* Fills n doubles from number *i on: each field differs from its neighbours. */
static void fill(double *to, int n, int *i)
{
    for (int j = 0; j < n; j++) {
        to[j] = awkward((*i)++);
    }
}

static exk_wire_pose some_pose(void)
{
    exk_wire_pose p;
    int i = 0;
    memset(&p, 0, sizeof p);
    p.run_id = INT64_MIN;
    p.seq = INT64_MAX;
    p.lateness_ns = -5;
    p.step_ns = 123456789012345;
    exk_sample *s = &p.sample;
    s->k = 0x0102030405060708;
    s->time_us = -2;
    s->phase = EXK_PHASE_RETRACT;
    s->hole = INT32_MIN;
    s->hole_id = INT32_MAX;
    s->judged = true;
    s->sensor_ok = false;
    s->has_true = true;
    exk_tool *tools[3] = {&s->ref, &s->est, &s->real};
    for (int t = 0; t < 3; t++) {
        fill(tools[t]->tip_m, 3, &i);
        fill(tools[t]->axis, 3, &i);
    }
    double *pairs[7] = {s->r_rad, s->m_rad, s->theta_rad, s->q_rad,
                        s->c_rad, s->u_rad, s->wrist_rad};
    for (int t = 0; t < 7; t++) {
        fill(pairs[t], 2, &i);
    }
    fill(&s->h_m, 1, &i);
    fill(s->legs_m, 3, &i);
    return p;
}

static void a_pose_survives_bit_for_bit(void)
{
    unsigned char buffer[EXK_WIRE_POSE_MAX];
    const exk_wire_pose in = some_pose();
    exk_wire_pose out;
    memset(&out, 0, sizeof out);
    const int bytes = exk_wire_pose_encode(&in, buffer, sizeof buffer);
    TEST_ASSERT_GREATER_THAN(0, bytes);
    TEST_ASSERT_LESS_THAN(400, bytes);
    TEST_ASSERT_TRUE(exk_wire_pose_decode(buffer, (size_t)bytes, &out));
    TEST_ASSERT_EQUAL_MEMORY(&in, &out, sizeof in); /* both were zeroed: padding is equal too */
}

static void each_flag_has_its_own_place(void)
{
    for (int flag = 0; flag < 3; flag++) {
        unsigned char buffer[EXK_WIRE_POSE_MAX];
        exk_wire_pose in = some_pose();
        exk_wire_pose out;
        in.sample.judged = flag == 0;
        in.sample.sensor_ok = flag == 1;
        in.sample.has_true = flag == 2;
        const int bytes = exk_wire_pose_encode(&in, buffer, sizeof buffer);
        TEST_ASSERT_TRUE(exk_wire_pose_decode(buffer, (size_t)bytes, &out));
        TEST_ASSERT_EQUAL(flag == 0, out.sample.judged);
        TEST_ASSERT_EQUAL(flag == 1, out.sample.sensor_ok);
        TEST_ASSERT_EQUAL(flag == 2, out.sample.has_true);
    }
}

static void a_pose_of_another_length_or_kind_is_refused(void)
{
    unsigned char buffer[EXK_WIRE_POSE_MAX + 1] = {0};
    const exk_wire_pose in = some_pose();
    exk_wire_pose out;
    memset(&out, 0x5A, sizeof out);
    const exk_wire_pose before = out;
    const int bytes = exk_wire_pose_encode(&in, buffer, EXK_WIRE_POSE_MAX);
    for (size_t n = 0; n < sizeof buffer; n++) {
        TEST_ASSERT_EQUAL(n == (size_t)bytes, exk_wire_pose_decode(buffer, n, &out));
        if (n == (size_t)bytes) {
            out = before;
        }
    }
    buffer[0] ^= 1; /* fingerprint */
    TEST_ASSERT_FALSE(exk_wire_pose_decode(buffer, (size_t)bytes, &out));
    TEST_ASSERT_EQUAL_MEMORY(&before, &out, sizeof out);
    TEST_ASSERT_LESS_THAN(0, exk_wire_pose_encode(&in, buffer, (size_t)bytes - 1));
}

static void a_phase_that_does_not_exist_is_refused(void)
{
    unsigned char buffer[EXK_WIRE_POSE_MAX];
    exk_wire_pose in = some_pose();
    exk_wire_pose out;
    in.sample.phase = EXK_PHASE_COUNT;
    const int bytes = exk_wire_pose_encode(&in, buffer, sizeof buffer);
    TEST_ASSERT_FALSE(exk_wire_pose_decode(buffer, (size_t)bytes, &out));
}

static void a_hole_survives(void)
{
    unsigned char buffer[EXK_WIRE_HOLE_MAX];
    int i = 0;
    exk_wire_hole in;
    exk_wire_hole out;
    memset(&in, 0, sizeof in);
    in.stamp = (exk_wire_stamp){1, 2, 3, 4};
    in.hole = 5;
    in.target.id = 6;
    fill(in.target.target_m, 3, &i);
    fill(in.target.axis, 3, &i);
    fill(in.result.tip_m, 3, &i);
    fill(&in.result.dx_m, 1, &i);
    fill(&in.result.dy_m, 1, &i);
    fill(&in.result.radial_m, 1, &i);
    fill(&in.result.tilt_rad, 1, &i);
    fill(&in.tolerance_m, 1, &i);
    in.result.k = 3;
    in.result.drilled = true;
    in.result.inside = true;
    const int bytes = exk_wire_hole_encode(&in, buffer, sizeof buffer);
    TEST_ASSERT_GREATER_THAN(0, bytes);
    TEST_ASSERT_TRUE(exk_wire_hole_decode(buffer, (size_t)bytes, &out));
    TEST_ASSERT_EQUAL_MEMORY(&in, &out, sizeof in);
    TEST_ASSERT_FALSE(exk_wire_hole_decode(buffer, (size_t)bytes - 1, &out));
}

static exk_wire_status some_status(void)
{
    exk_wire_status s;
    memset(&s, 0, sizeof s);
    s.stamp = (exk_wire_stamp){11, 12, 13, 14};
    s.utime_us = 15;
    s.state = EXK_STATE_FAULT;
    s.last = true;
    s.fault = EXK_ERR_SENSOR;
    int64_t *counts[6] = {&s.n_steps, &s.n_overruns, &s.n_bad,
                          &s.n_poses, &s.n_dropped,  &s.ring_deepest};
    for (int i = 0; i < 6; i++) {
        *counts[i] = 20 + i;
    }
    s.n_drilled = 30;
    s.n_inside = 31;
    for (int i = 0; i < 3; i++) {
        s.lateness_ns[i] = 40 + i;
        s.step_ns[i] = 50 + i;
    }
    s.bus.link = (exk_link_counts){60, 61, 62, 63, 64};
    s.bus.command = (exk_command_counts){65, 66, {70, 71, 72, 73, 74, 75, 76}};
    s.bus.n_dropped = 80;
    s.loop.cause = EXK_CAUSE_SENSOR;
    s.loop.motion = EXK_MOTION_RETRACT;
    s.loop.k_cause = 81;
    s.loop.n_transitions = 82;
    s.loop.n_refused = 83;
    s.loop.n_held = 84;
    s.loop.fault.what.quantity = EXK_QUANTITY_SAMPLES;
    s.loop.fault.what.index = -1;
    s.loop.fault.what.value = 85.5;
    s.loop.fault.what.limit = 86.5;
    s.loop.fault.k = 87;
    s.loop.fault.hole_id = 88;
    for (int i = 0; i < EXK_SAMPLE_COUNT; i++) {
        s.loop.n_rejected[i] = 90 + i;
    }
    memcpy(s.reason, "sensor", 7);
    memset(s.rights, 'r', sizeof s.rights - 1); /* as long as it can be */
    return s;
}

static void a_status_survives(void)
{
    unsigned char buffer[EXK_WIRE_STATUS_MAX];
    const exk_wire_status in = some_status();
    exk_wire_status out;
    const int bytes = exk_wire_status_encode(&in, buffer, sizeof buffer);
    TEST_ASSERT_GREATER_THAN(0, bytes);
    TEST_ASSERT_TRUE(exk_wire_status_decode(buffer, (size_t)bytes, &out));
    TEST_ASSERT_EQUAL_MEMORY(&in, &out, sizeof in);
    for (size_t n = 0; n < (size_t)bytes; n++) {
        TEST_ASSERT_FALSE(exk_wire_status_decode(buffer, n, &out));
    }
}

static void a_state_that_does_not_exist_is_refused(void)
{
    unsigned char buffer[EXK_WIRE_STATUS_MAX];
    exk_wire_status in = some_status();
    exk_wire_status out;
    in.state = EXK_STATE_COUNT;
    const int bytes = exk_wire_status_encode(&in, buffer, sizeof buffer);
    TEST_ASSERT_FALSE(exk_wire_status_decode(buffer, (size_t)bytes, &out));
}

static void a_drive_survives_and_its_tick_fits_its_kind(void)
{
    static const struct {
        exk_drive_kind kind;
        int64_t k;
        bool good;
    } rows[] = {
        {EXK_DRIVE_HELLO, -1, true},  {EXK_DRIVE_HELLO, 0, false},
        {EXK_DRIVE_STEP, 0, true},    {EXK_DRIVE_STEP, -1, false},
        {EXK_DRIVE_BYE, -2, true},    {EXK_DRIVE_BYE, 7, false},
        {EXK_DRIVE_COUNT, -1, false}, {EXK_DRIVE_STEP, 1LL << 40, true},
    };
    unsigned char buffer[EXK_WIRE_DRIVE_MAX];
    for (size_t r = 0; r < sizeof rows / sizeof rows[0]; r++) {
        exk_wire_drive in;
        exk_wire_drive out;
        int i = 0;
        memset(&in, 0, sizeof in);
        memset(&out, 0, sizeof out);
        in.stamp = (exk_wire_stamp){1, 2, rows[r].k, 4};
        in.which = (exk_realisation){0xfedcba9876543210U, 0xfffffffeU, 7};
        in.kind = rows[r].kind;
        fill(in.drive.angle_rad, EXK_N_AXES, &i);
        fill(in.drive.legs_m, EXK_N_LEGS, &i);
        fill(in.drive.wrist_rad, EXK_N_WRIST, &i);
        const int bytes = exk_wire_drive_encode(&in, buffer, sizeof buffer);
        TEST_ASSERT_GREATER_THAN(0, bytes);
        TEST_ASSERT_EQUAL(rows[r].good, exk_wire_drive_decode(buffer, (size_t)bytes, &out));
        TEST_ASSERT_FALSE(exk_wire_drive_decode(buffer, (size_t)bytes - 1, &out));
        if (rows[r].good) {
            TEST_ASSERT_EQUAL_MEMORY(&in.drive, &out.drive, sizeof in.drive);
            TEST_ASSERT_EQUAL_MEMORY(&in.stamp, &out.stamp, sizeof in.stamp);
            TEST_ASSERT_EQUAL_MEMORY(&in.which, &out.which, sizeof in.which);
        }
    }
}

static void an_answer_survives_bit_for_bit(void)
{
    unsigned char buffer[EXK_WIRE_SENSOR_MAX];
    exk_wire_sensor in;
    exk_wire_sensor out;
    memset(&in, 0, sizeof in);
    memset(&out, 0, sizeof out);
    in.stamp = (exk_wire_stamp){1, 2, -1, 4};
    in.drive_seq = 5;
    in.session_id = 7;
    in.machine_id = 6;
    in.reading.has_true = true;
    in.reading.fresh = true;
    in.reading.age = 9;
    for (int i = 0; i < 8; i++) {
        int at = i;
        fill(in.reading.measured_rad, EXK_N_AXES, &at);
        fill(in.reading.true_rad, EXK_N_AXES, &at);
        const int bytes = exk_wire_sensor_encode(&in, buffer, sizeof buffer);
        TEST_ASSERT_TRUE(exk_wire_sensor_decode(buffer, (size_t)bytes, &out));
        TEST_ASSERT_EQUAL_MEMORY(&in, &out, sizeof in);
        TEST_ASSERT_FALSE(exk_wire_sensor_decode(buffer, (size_t)bytes - 1, &out));
    }
    in.reading.age = -1;
    int bytes = exk_wire_sensor_encode(&in, buffer, sizeof buffer);
    TEST_ASSERT_FALSE(exk_wire_sensor_decode(buffer, (size_t)bytes, &out));
    in.reading.age = 0;
    in.stamp.k = -2;
    bytes = exk_wire_sensor_encode(&in, buffer, sizeof buffer);
    TEST_ASSERT_FALSE(exk_wire_sensor_decode(buffer, (size_t)bytes, &out));
}

static void a_command_survives(void)
{
    unsigned char buffer[EXK_WIRE_COMMAND_MAX];
    exk_wire_command in;
    exk_wire_command out;
    memset(&in, 0, sizeof in);
    memset(&out, 0, sizeof out);
    in = (exk_wire_command){.run_id = -1, .seq = 2, .utime_us = INT64_MAX, .command = -128};
    for (int i = 0; i < EXK_MAC_BYTES; i++) {
        in.mac[i] = (unsigned char)(255 - i);
    }
    const int bytes = exk_wire_command_encode(&in, buffer, sizeof buffer);
    TEST_ASSERT_GREATER_THAN(0, bytes);
    TEST_ASSERT_TRUE(exk_wire_command_decode(buffer, (size_t)bytes, &out));
    TEST_ASSERT_EQUAL_INT64(in.utime_us, out.utime_us);
    TEST_ASSERT_EQUAL_INT8(in.command, out.command);
    TEST_ASSERT_EQUAL_MEMORY(in.mac, out.mac, sizeof in.mac);
    for (size_t n = 0; n < (size_t)bytes; n++) {
        TEST_ASSERT_FALSE(exk_wire_command_decode(buffer, n, &out));
    }
}

typedef struct {
    exk_wire_job job;
    exk_hole holes[120];
    int32_t ids[120];
    double *rows[240];
    char text[64];
    unsigned char buffer[8192];
    int bytes;
} job_case;

static void encode_job(job_case *c, size_t n_holes)
{
    int number = 0;
    memset(c, 0, sizeof *c);
    c->job = (exk_wire_job){.stamp = {1, 2, 3, 4},
                            .start_utime_us = 5,
                            .job_hash = 0xFEDCBA9876543210U,
                            .seed = UINT64_MAX,
                            .series = UINT32_MAX,
                            .run = 7,
                            .n_ticks = 8,
                            .every = 9,
                            .dt_s = 0.001,
                            .tolerance_m = 3e-5,
                            .holes = c->holes,
                            .n_holes = n_holes,
                            .profile_name = "rectangle",
                            .kinematics = "machine",
                            .controller = "pid",
                            .profile_text = c->text};
    strcpy(c->text, "[machine]\nd1_mm = 1\n");
    for (size_t i = 0; i < n_holes; i++) {
        c->holes[i].id = 1000 - (int32_t)i;
        fill(c->holes[i].target_m, 3, &number);
        fill(c->holes[i].axis, 3, &number);
    }
    const exk_wire_scratch scratch = {c->ids, c->rows};
    c->bytes = exk_wire_job_encode(&c->job, &scratch, c->buffer, sizeof c->buffer);
}

static void check_job(const job_case *c, const exk_wire_job *out)
{
    TEST_ASSERT_EQUAL_UINT64(c->job.job_hash, out->job_hash);
    TEST_ASSERT_EQUAL_UINT64(c->job.seed, out->seed);
    TEST_ASSERT_EQUAL_UINT32(c->job.series, out->series);
    TEST_ASSERT_EQUAL_UINT32(7, out->run);
    TEST_ASSERT_EQUAL_INT64(8, out->n_ticks);
    TEST_ASSERT_EQUAL(9, out->every);
    TEST_ASSERT_EQUAL_MEMORY(&c->job.dt_s, &out->dt_s, sizeof(double));
    TEST_ASSERT_EQUAL_MEMORY(&c->job.tolerance_m, &out->tolerance_m, sizeof(double));
    TEST_ASSERT_EQUAL_STRING("rectangle", out->profile_name);
    TEST_ASSERT_EQUAL_STRING("machine", out->kinematics);
    TEST_ASSERT_EQUAL_STRING("pid", out->controller);
    TEST_ASSERT_EQUAL_STRING(c->text, out->profile_text);
}

static void a_job_survives_with_and_without_holes(void)
{
    static const size_t counts[] = {0, 1, 4, 120};
    static job_case c;
    for (size_t i = 0; i < 4; i++) {
        exk_wire_job out;
        encode_job(&c, counts[i]);
        TEST_ASSERT_EQUAL((int)exk_wire_job_bytes(&c.job), c.bytes);
        TEST_ASSERT_TRUE(exk_wire_job_decode(c.buffer, (size_t)c.bytes, &out));
        check_job(&c, &out);
        TEST_ASSERT_EQUAL(counts[i], out.n_holes);
        for (size_t h = 0; h < counts[i]; h++) {
            TEST_ASSERT_EQUAL_MEMORY(&c.holes[h].target_m, &out.holes[h].target_m, 24);
            TEST_ASSERT_EQUAL_MEMORY(&c.holes[h].axis, &out.holes[h].axis, 24);
            TEST_ASSERT_EQUAL(c.holes[h].id, out.holes[h].id);
        }
        exk_wire_job_free(&out);
    }
}

static void a_job_cut_anywhere_is_refused(void)
{
    static job_case c;
    exk_wire_job out;
    encode_job(&c, 3);
    for (size_t n = 0; n < (size_t)c.bytes; n++) {
        TEST_ASSERT_FALSE(exk_wire_job_decode(c.buffer, n, &out));
    }
}

/* Counts and lengths that would make a trusting decoder allocate gigabytes or run off the end. */
static void a_job_that_lies_about_its_lengths_is_refused(void)
{
    static const unsigned char lies[][4] = {{0x7F, 0xFF, 0xFF, 0xFF}, {0xFF, 0xFF, 0xFF, 0xFF},
                                            {0x40, 0, 0, 0},          {0x80, 0, 0, 0},
                                            {0, 0x0F, 0x42, 0x40},    {0, 0, 0, 0}};
    static job_case c;
    exk_wire_job out;
    encode_job(&c, 3);
    const size_t at_count = exk_wire_job_bytes(&c.job) - 3 * 52 - 4 * 5 - strlen("rectangle") -
                            strlen("machine") - strlen("pid") - strlen(c.text) - 4;
    const size_t at_name = at_count + 4 + 3 * 52;
    TEST_ASSERT_EQUAL(3, c.buffer[at_count + 3]);
    TEST_ASSERT_EQUAL(strlen("rectangle") + 1, c.buffer[at_name + 3]);
    for (size_t i = 0; i < sizeof lies / sizeof lies[0]; i++) {
        encode_job(&c, 3);
        memcpy(c.buffer + at_count, lies[i], 4);
        TEST_ASSERT_FALSE(exk_wire_job_decode(c.buffer, (size_t)c.bytes, &out));
        encode_job(&c, 3);
        memcpy(c.buffer + at_name, lies[i], 4);
        TEST_ASSERT_FALSE(exk_wire_job_decode(c.buffer, (size_t)c.bytes, &out));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_pose_survives_bit_for_bit);
    RUN_TEST(each_flag_has_its_own_place);
    RUN_TEST(a_pose_of_another_length_or_kind_is_refused);
    RUN_TEST(a_phase_that_does_not_exist_is_refused);
    RUN_TEST(a_hole_survives);
    RUN_TEST(a_status_survives);
    RUN_TEST(a_state_that_does_not_exist_is_refused);
    RUN_TEST(a_drive_survives_and_its_tick_fits_its_kind);
    RUN_TEST(an_answer_survives_bit_for_bit);
    RUN_TEST(a_command_survives);
    RUN_TEST(a_job_survives_with_and_without_holes);
    RUN_TEST(a_job_cut_anywhere_is_refused);
    RUN_TEST(a_job_that_lies_about_its_lengths_is_refused);
    return UNITY_END();
}
