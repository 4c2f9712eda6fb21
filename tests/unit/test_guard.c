/* Sensor guard: every kind of bad sample, its neighbours that are good, and the limits it works out. */
#include "exk/guard.h"

#include <math.h>

#include "unity.h"

static exk_guard guard;
static exk_guard_config cfg;

void setUp(void)
{
    cfg = exk_guard_default();
    cfg.angle_max_rad = 0.5;
    cfg.stuck_s = 0.0;
}

void tearDown(void)
{
}

static void start(void)
{
    TEST_ASSERT_EQUAL(EXK_OK, exk_guard_init(&guard, &cfg));
}

static exk_reading reading(double alpha, double beta)
{
    return (exk_reading){.measured_rad = {alpha, beta}, .fresh = true};
}

/* Reference and command the same: the machine is asked to stand at (q, -q). */
static exk_sample_kind judge(int64_t k, double q, exk_reading r)
{
    const double q_rad[EXK_N_AXES] = {q, -q};
    return exk_guard_check(&guard, k, q_rad, q_rad, &r);
}

static void numbers_are_judged_in_both_angles(void)
{
    static const struct {
        double value;
        exk_sample_kind want;
    } rows[] = {
        {0.5, EXK_SAMPLE_GOOD},
        {-0.5, EXK_SAMPLE_GOOD},
        {0.5000001, EXK_SAMPLE_RANGE},
        {-1e300, EXK_SAMPLE_RANGE},
        {(double)NAN, EXK_SAMPLE_NAN},
        {(double)INFINITY, EXK_SAMPLE_INFINITE},
        {-(double)INFINITY, EXK_SAMPLE_INFINITE},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        start();
        TEST_ASSERT_EQUAL(rows[i].want, judge(0, 0.0, reading(rows[i].value, 0.0)));
        TEST_ASSERT_EQUAL(rows[i].want, judge(1, 0.0, reading(0.0, rows[i].value)));
        TEST_ASSERT_EQUAL_INT64(2, guard.n[rows[i].want]);
        if (rows[i].want != EXK_SAMPLE_GOOD) {
            TEST_ASSERT_EQUAL_INT(1, guard.bad_axis);
            TEST_ASSERT_EQUAL_DOUBLE(0.5, guard.bad_limit);
        }
    }
}

/* age: how many ticks before the one asked for the sample belongs to. */
static void arrivals_are_judged_by_the_tick_they_belong_to(void)
{
    static const struct {
        int64_t k, age;
        bool fresh;
        exk_sample_kind want;
    } rows[] = {
        {0, 0, true, EXK_SAMPLE_GOOD},
        {1, 0, false, EXK_SAMPLE_MISSING},
        {2, 1, true, EXK_SAMPLE_LATE},      /* of tick 1: newer than tick 0 */
        {3, 2, true, EXK_SAMPLE_REPEATED},  /* of tick 1 again */
        {4, 4, true, EXK_SAMPLE_REORDERED}, /* of tick 0 */
        {5, -1, true, EXK_SAMPLE_REORDERED},
        {6, 7, true, EXK_SAMPLE_REORDERED}, /* of before the run */
        {7, INT64_MAX, true, EXK_SAMPLE_REORDERED},
        {8, INT64_MIN, true, EXK_SAMPLE_REORDERED},
        {9, 0, true, EXK_SAMPLE_GOOD},
        {10, 1, true, EXK_SAMPLE_REPEATED},
    };
    start();
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        exk_reading r = reading(0.0, 0.0);
        r.age = rows[i].age;
        r.fresh = rows[i].fresh;
        TEST_ASSERT_EQUAL_STRING(exk_sample_kind_name(rows[i].want),
                                 exk_sample_kind_name(judge(rows[i].k, 0.0, r)));
    }
    TEST_ASSERT_EQUAL_INT64(2, guard.n[EXK_SAMPLE_GOOD]);
    TEST_ASSERT_EQUAL_INT64(5, guard.n[EXK_SAMPLE_REORDERED]);
}

/* White noise alone: the gain is the least, 0.1, and the variance R + R/0.95 + ... as the header says. */
static void a_spike_is_beyond_the_limit_of_the_header(void)
{
    cfg.white_rad = 1e-4;
    cfg.n_sigmas = 6.0;
    start();
    TEST_ASSERT_EQUAL_DOUBLE(0.1, guard.gain);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 6.0 * sqrt(1e-8 / 0.95) + 1e-9, guard.limit_rad);
    for (int64_t k = 0; k < 30; k++) {
        TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(k, 0.0,
                                                 reading(1e-2 + 1e-12 * (double)(k % 2),
                                                         -1e-2 - 1e-12 * (double)(k % 2))));
    }
    const double in = 0.999 * guard.limit_rad;
    const double out = 1.001 * guard.limit_rad;
    TEST_ASSERT_EQUAL(EXK_SAMPLE_SPIKE, judge(30, 0.0, reading(1e-2 + out, -1e-2)));
    TEST_ASSERT_EQUAL_INT(EXK_ALPHA, guard.bad_axis);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, out, guard.bad_value);
    TEST_ASSERT_EQUAL(EXK_SAMPLE_SPIKE, judge(31, 0.0, reading(1e-2, -1e-2 - out)));
    TEST_ASSERT_EQUAL_INT(EXK_BETA, guard.bad_axis);
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(32, 0.0, reading(1e-2 + in, -1e-2 - in)));
}

/* Nothing is learned of the first sample; young guards allow sqrt(2) of it. */
static void a_young_guard_is_more_patient(void)
{
    cfg.white_rad = 1e-4;
    cfg.n_sigmas = 6.0;
    start();
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(0, 0.0, reading(0.4, -0.4)));
    const double young = sqrt(2.0) * guard.limit_rad;
    TEST_ASSERT_EQUAL(EXK_SAMPLE_SPIKE, judge(1, 0.0, reading(0.4 + 1.01 * young, -0.4)));
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(2, 0.0, reading(0.4 + 0.99 * young, -0.4)));
}

/* A walk alone, K = 1: a spike of A is +A and then -A, so A^ = (e1 - e2)/2 with sigma/sqrt(2). */
static void grow_up_at_rest(double walk_rad)
{
    cfg.walk_rad = walk_rad;
    cfg.n_sigmas = 6.0;
    start();
    for (int64_t k = 0; k < 20; k++) {
        judge(k, 0.0, reading(1e-12 * (double)(k % 2), 1e-12 * (double)(k % 2)));
    }
}

static void a_spike_below_the_limit_is_seen_in_the_next_sample(void)
{
    grow_up_at_rest(1e-4);
    TEST_ASSERT_DOUBLE_WITHIN(1e-8, 6e-4 / sqrt(2.0), guard.back_limit_rad);
    const double spike = 0.9 * guard.limit_rad;
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(20, 0.0, reading(0.0, -spike)));
    TEST_ASSERT_EQUAL(EXK_SAMPLE_SPIKE, judge(21, 0.0, reading(0.0, 0.0)));
    TEST_ASSERT_EQUAL_INT(EXK_BETA, guard.bad_axis);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, -spike, guard.bad_value);
    TEST_ASSERT_EQUAL_DOUBLE(guard.back_limit_rad, guard.bad_limit);
    TEST_ASSERT_DOUBLE_WITHIN(1e-11, 0.0, guard.axis[EXK_BETA].offset_rad); /* forgotten */
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(22, 0.0, reading(0.0, 0.0)));
    TEST_ASSERT_EQUAL_INT64(1, guard.n[EXK_SAMPLE_SPIKE]);
}

static void a_new_level_is_no_spike_of_the_sample_before(void)
{
    grow_up_at_rest(1e-4);
    const double level = 0.9 * guard.limit_rad;
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(20, 0.0, reading(level, level)));
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(21, 0.0, reading(level, level + 1e-12)));
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD,
                      judge(23, 0.0, reading(0.0, 0.0))); /* a gap: not looked back over */
}

/* A walk: after n ticks without a good sample the limit has grown, and a new course is taken. */
static void the_limit_grows_while_nothing_is_known(void)
{
    cfg.walk_rad = 1e-4;
    cfg.drift_rad = 1e-5;
    cfg.n_sigmas = 6.0;
    start();
    TEST_ASSERT_EQUAL_DOUBLE(1.0, guard.gain);
    for (int64_t k = 0; k < 20; k++) {
        judge(k, 0.0, reading(1e-12 * (double)(k % 2), 1e-12 * (double)(k % 2)));
    }
    const double n = 9.0;
    const double grown = 6.0 * sqrt(1e-8 * n) + n * 1e-5;
    TEST_ASSERT_EQUAL(EXK_SAMPLE_SPIKE, judge(20, 0.0, reading(0.9 * grown, 0.0)));
    TEST_ASSERT_EQUAL(EXK_SAMPLE_SPIKE, judge(28, 0.0, reading(1.01 * grown, 0.0)));
    exk_guard copy = guard;
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(28, 0.0, reading(0.99 * grown, 0.0)));
    guard = copy;
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(100000, 0.0, reading(0.1, 0.0)));
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(100001, 0.0, reading(0.1, 0.0)));
}

/* x[k] = a x + (1-a) q, also over ticks that nobody saw: the limit is 2 um, the move 0.1 rad. */
static void the_expected_servo_is_that_of_the_profile(void)
{
    for (int step = 1; step <= 3; step++) {
        setUp();
        cfg.servo_tau_s = 0.004;
        cfg.quantum_rad = 1e-6;
        cfg.n_sigmas = 6.0;
        start();
        const double a = exp(-0.001 / 0.004);
        double x = 0.1;
        double q = 0.1;
        for (int64_t k = 0; k < 200; k += step) {
            for (int j = 1; j < step && k > 0; j++) {
                x = a * x + (1.0 - a) * q; /* the ticks skipped, with the old command */
            }
            q = k < 50 ? 0.1 : 0.2;
            x = a * x + (1.0 - a) * q;
            TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(k, q, reading(x, -x)));
        }
        TEST_ASSERT_EQUAL(EXK_SAMPLE_SPIKE, judge(201, q, reading(x + 1e-3, -x)));
        TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(201, q, reading(x, -x))); /* no tick passes */
    }
}

/* 15 ms at 1 kHz: 15 repeats, once the reference moved by more than 1 urad. */
static void stuck_is_judged_while_the_reference_moves(void)
{
    cfg.stuck_s = 0.015;
    start();
    for (int64_t k = 0; k < 100; k++) { /* a dwell is constant by right */
        TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(k, 0.1, reading(0.1, -0.1)));
    }
    TEST_ASSERT_EQUAL(EXK_SAMPLE_STUCK, judge(100, 0.1002, reading(0.1, -0.1001)));
    TEST_ASSERT_EQUAL_INT(EXK_ALPHA, guard.bad_axis);
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(101, 0.1004, reading(0.1004, -0.1004)));
    int n_good = 0;
    while (n_good < 100 && judge(102 + n_good, 0.1005 + 1e-5 * n_good,
                                 reading(0.1004, -0.1004 - 1e-5 * n_good)) == EXK_SAMPLE_GOOD) {
        n_good++;
    }
    TEST_ASSERT_EQUAL_INT(14, n_good);
}

static void ten_quanta_of_movement_are_asked_for(void)
{
    cfg.stuck_s = 0.003;
    cfg.quantum_rad = 1e-4;
    start();
    for (int64_t k = 0; k < 60; k++) {
        const double r = 0.1 + 1e-5 * (double)k; /* 10 quanta after 100 ticks */
        TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(k, r, reading(0.1, -0.1)));
    }
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(60, 0.10099, reading(0.1, -0.1)));
    TEST_ASSERT_EQUAL(EXK_SAMPLE_STUCK, judge(61, 0.10101, reading(0.1, -0.1)));
    cfg.stuck_s = 0.0; /* not judged */
    start();
    for (int64_t k = 0; k < 60; k++) {
        TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD,
                          judge(k, 0.01 * (double)k / 60.0, reading(0.1, 0.1)));
    }
}

/* First feedback holds the command while the reference moves on, then the other way round: the value is constant
 * by right until both have moved. */
static void a_turn_against_the_reference_is_no_stuck_sensor(void)
{
    cfg.stuck_s = 0.003;
    start();
    const exk_reading m = reading(0.1, 0.1);
    for (int64_t k = 0; k < 100; k++) {
        const double moves = 0.1 + 1e-5 * (double)k;
        const double r_rad[EXK_N_AXES] = {moves, 0.1};
        const double q_rad[EXK_N_AXES] = {0.1, moves};
        TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, exk_guard_check(&guard, k, r_rad, q_rad, &m));
    }
    const double r_rad[EXK_N_AXES] = {0.102, 0.1};
    const double q_rad[EXK_N_AXES] = {0.10001, 0.102};
    TEST_ASSERT_EQUAL(EXK_SAMPLE_STUCK, exk_guard_check(&guard, 100, r_rad, q_rad, &m));
    TEST_ASSERT_EQUAL_INT(EXK_ALPHA, guard.bad_axis);
}

/* What drifts by 1e-5 a tick may hold the value of a reference that moves by less. */
static void a_drift_may_cancel_a_slow_reference(void)
{
    for (int fast = 0; fast < 2; fast++) {
        cfg.stuck_s = 0.003;
        cfg.drift_rad = 1e-5;
        start();
        exk_sample_kind kind = EXK_SAMPLE_GOOD;
        for (int64_t k = 0; k < 100 && kind == EXK_SAMPLE_GOOD; k++) {
            kind = judge(k, 0.1 + (fast ? 1.2e-5 : 0.9e-5) * (double)k, reading(0.1, -0.1));
        }
        TEST_ASSERT_EQUAL(fast ? EXK_SAMPLE_STUCK : EXK_SAMPLE_GOOD, kind);
    }
}

/* A noise of one quantum repeats with p <= 1/(2 sqrt(pi)) = 0.28: 17 in a row once in 1e9. */
static void noise_that_stops_is_stuck_at_rest_too(void)
{
    static const struct {
        double noise, quantum;
        int64_t want;
    } rows[] = {
        {1e-5, 1e-5, 17}, {1e-5, 2e-5, 0}, {0.0, 0.0, 0}, {0.0, 1e-5, 0}, {1e-5, 0.0, 3},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        cfg.stuck_s = 0.002;
        cfg.noise_rad = rows[i].noise;
        cfg.quantum_rad = rows[i].quantum;
        start();
        TEST_ASSERT_EQUAL_INT64(rows[i].want, guard.n_stuck_rest);
        const int64_t n = rows[i].want > 0 ? rows[i].want : 200;
        for (int64_t k = 0; k < n; k++) {
            TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(k, 0.1, reading(0.1, -0.1)));
        }
        TEST_ASSERT_EQUAL(rows[i].want > 0 ? EXK_SAMPLE_STUCK : EXK_SAMPLE_GOOD,
                          judge(n, 0.1, reading(0.1, -0.1)));
    }
    cfg.stuck_s = 1.0; /* no fewer repeats at rest than while moving */
    cfg.noise_rad = 1e-5;
    cfg.quantum_rad = 1e-5;
    start();
    TEST_ASSERT_EQUAL_INT64(1000, guard.n_stuck_rest);
    cfg.stuck_s = 1e300;
    start();
    TEST_ASSERT_EQUAL_INT64(INT32_MAX, guard.n_stuck);
}

static void reset_forgets_the_machine_and_keeps_the_counts(void)
{
    cfg.n_sigmas = 6.0;
    start();
    judge(0, 0.1, reading(0.1, -0.1));
    TEST_ASSERT_EQUAL(EXK_SAMPLE_SPIKE, judge(1, 0.1, reading(0.3, -0.1)));
    exk_guard_reset(&guard);
    TEST_ASSERT_EQUAL(EXK_SAMPLE_GOOD, judge(0, 0.1, reading(0.3, -0.1)));
    TEST_ASSERT_EQUAL_INT64(1, guard.n[EXK_SAMPLE_SPIKE]);
    TEST_ASSERT_EQUAL_INT64(2, guard.n[EXK_SAMPLE_GOOD]);
}

static void configurations_are_refused_by_the_table(void)
{
    enum { ZERO = 1, INF = 2, BELOW = 4, NOT_A_NUMBER = 8 };
    double *const numbers[] = {&cfg.dt_s,      &cfg.angle_max_rad, &cfg.servo_tau_s,
                               &cfg.white_rad, &cfg.walk_rad,      &cfg.drift_rad,
                               &cfg.noise_rad, &cfg.quantum_rad,   &cfg.stuck_s,
                               &cfg.n_sigmas,  &cfg.start_rad};
    static const int allowed[] = {0,    0,    ZERO, ZERO, ZERO,      ZERO,
                                  ZERO, ZERO, ZERO, INF,  ZERO | INF};
    static const struct {
        double value;
        int needs;
    } rows[] = {
        {0.0, ZERO}, {(double)INFINITY, INF}, {-1e-9, BELOW}, {(double)NAN, NOT_A_NUMBER}};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        for (size_t j = 0; j < sizeof rows / sizeof rows[0]; j++) {
            setUp();
            *numbers[i] = rows[j].value;
            TEST_ASSERT_EQUAL((allowed[i] & rows[j].needs) != 0 ? EXK_OK : EXK_ERR_ARG,
                              exk_guard_init(&guard, &cfg));
        }
    }
}

/* Waveform x order against the slopes and variances of the header, dt 1 ms, 4 s long, A = 2. */
static void what_is_expected_follows_from_the_twin(void)
{
    static const struct {
        exk_wave wave;
        int order;
        double freq_Hz, white, walk, drift;
    } rows[] = {
        {EXK_WAVE_NONE, 0, 0.0, 0.0, 0.0, 0.0},
        {EXK_WAVE_COUNT, 0, 0.0, 0.0, 0.0, 0.0}, /* no twin takes it */
        {EXK_WAVE_CONSTANT, 0, 0.0, 0.0, 0.0, 0.0},
        {EXK_WAVE_CONSTANT, 1, 0.0, 0.0, 0.0, 2e-3},
        {EXK_WAVE_CONSTANT, 2, 0.0, 0.0, 0.0, 8e-3},
        {EXK_WAVE_SINE, 0, 0.5, 0.0, 0.0, 2.0 * 3.14159265358979 * 1e-3},
        {EXK_WAVE_SINE, 1, 0.5, 0.0, 0.0, 2e-3},
        {EXK_WAVE_SINE, 2, 0.5, 0.0, 0.0, 4.0 / 3.14159265358979 * 1e-3},
        {EXK_WAVE_SINE, 2, 0.01, 0.0, 0.0, 8e-3}, /* too slow to turn round in 4 s */
        {EXK_WAVE_GAUSSIAN, 0, 0.0, 2.0, 0.0, 0.0},
        {EXK_WAVE_GAUSSIAN, 1, 0.0, 0.0, 0.0632455532033676, 0.0},   /* 2 sqrt(dt) */
        {EXK_WAVE_GAUSSIAN, 2, 0.0, 0.0, 3.65148371670111e-5, 0.02}, /* 5 s sqrt(T) dt */
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        exk_twin_config twin = exk_twin_default();
        twin.servo_tau_s = 0.01;
        twin.sensor_quantum_rad = 1e-6;
        twin.n_disturbances = 1;
        twin.disturbance[0] = exk_disturbance_default();
        twin.disturbance[0].wave = rows[i].wave;
        twin.disturbance[0].order = rows[i].order;
        twin.disturbance[0].amplitude = 2.0;
        twin.disturbance[0].freq_Hz = rows[i].freq_Hz;
        exk_guard_expect(&twin, 4.0, &cfg);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, rows[i].white, cfg.white_rad);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, rows[i].walk, cfg.walk_rad);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, rows[i].drift, cfg.drift_rad);
        TEST_ASSERT_EQUAL_DOUBLE(0.01, cfg.servo_tau_s);
        TEST_ASSERT_EQUAL_DOUBLE(1e-6, cfg.quantum_rad);
        twin.sensor_sigma_rad = 1.5;
        twin.n_disturbances = EXK_MAX_DISTURBANCES + 1; /* no twin; only the list is read */
        for (int j = 1; j < EXK_MAX_DISTURBANCES; j++) {
            twin.disturbance[j] = exk_disturbance_default();
        }
        exk_guard_expect(&twin, 4.0, &cfg);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, hypot(rows[i].white, 1.5), cfg.white_rad);
    }
}

static void names_are_never_null(void)
{
    for (int i = -1; i <= EXK_SAMPLE_COUNT; i++) {
        TEST_ASSERT_NOT_NULL(exk_sample_kind_name((exk_sample_kind)i));
    }
    TEST_ASSERT_EQUAL_STRING("stuck", exk_sample_kind_name(EXK_SAMPLE_STUCK));
    TEST_ASSERT_EQUAL_STRING("unknown", exk_sample_kind_name(EXK_SAMPLE_COUNT));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(numbers_are_judged_in_both_angles);
    RUN_TEST(arrivals_are_judged_by_the_tick_they_belong_to);
    RUN_TEST(a_spike_is_beyond_the_limit_of_the_header);
    RUN_TEST(a_young_guard_is_more_patient);
    RUN_TEST(a_spike_below_the_limit_is_seen_in_the_next_sample);
    RUN_TEST(a_new_level_is_no_spike_of_the_sample_before);
    RUN_TEST(the_limit_grows_while_nothing_is_known);
    RUN_TEST(the_expected_servo_is_that_of_the_profile);
    RUN_TEST(stuck_is_judged_while_the_reference_moves);
    RUN_TEST(ten_quanta_of_movement_are_asked_for);
    RUN_TEST(a_turn_against_the_reference_is_no_stuck_sensor);
    RUN_TEST(a_drift_may_cancel_a_slow_reference);
    RUN_TEST(noise_that_stops_is_stuck_at_rest_too);
    RUN_TEST(reset_forgets_the_machine_and_keeps_the_counts);
    RUN_TEST(configurations_are_refused_by_the_table);
    RUN_TEST(what_is_expected_follows_from_the_twin);
    RUN_TEST(names_are_never_null);
    return UNITY_END();
}
