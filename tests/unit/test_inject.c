/* What each injected fault makes of a reading, and when. */
#include "exk/inject.h"

#include <math.h>

#include "unity.h"

static const double dt_s = 0.001;
static const exk_realisation which = {.seed = 3, .series = 1, .run = 2};
static exk_inject inject;
static exk_inject_config cfg;

void setUp(void)
{
    cfg = (exk_inject_config){.n_faults = 1};
    cfg.fault[0] = exk_inject_default();
}

void tearDown(void)
{
}

static void start(void)
{
    TEST_ASSERT_EQUAL(EXK_OK, exk_inject_init(&inject, &cfg, dt_s, which));
}

/* Angles that tell their tick: alpha k/1000, beta -k/1000. */
static exk_reading whole(int64_t k)
{
    const double a = 1e-3 * (double)k;
    return (exk_reading){
        .measured_rad = {a, -a}, .true_rad = {a, -a}, .has_true = true, .fresh = true};
}

static exk_reading at(int64_t k)
{
    exk_reading reading = whole(k);
    exk_inject_apply(&inject, k, &reading);
    TEST_ASSERT_TRUE(reading.true_rad[EXK_ALPHA] == 1e-3 * (double)k);
    return reading;
}

static void set(exk_inject_kind kind, double at_s, double for_s)
{
    cfg.fault[0].kind = kind;
    cfg.fault[0].at_s = at_s;
    cfg.fault[0].for_s = for_s;
    start();
}

static bool untouched(const exk_reading *r, int64_t k)
{
    const exk_reading want = whole(k);
    return r->fresh && r->age == 0 && r->measured_rad[0] == want.measured_rad[0] &&
           r->measured_rad[1] == want.measured_rad[1];
}

/* at 5 ms for 3 ms: the ticks 5, 6, 7. */
static void each_fault_acts_in_its_own_time_only(void)
{
    for (int kind = 0; kind < EXK_INJECT_COUNT; kind++) {
        setUp();
        set((exk_inject_kind)kind, 0.005, 0.003);
        for (int64_t k = 0; k < 20; k++) {
            const exk_reading r = at(k);
            const bool acts = kind != EXK_INJECT_NONE && k >= 5 && k < 8;
            TEST_ASSERT_EQUAL_MESSAGE(acts, !untouched(&r, k),
                                      exk_inject_name((exk_inject_kind)kind));
        }
    }
}

static void a_fault_of_no_length_acts_once(void)
{
    set(EXK_INJECT_NAN, 0.002, 0.0);
    for (int64_t k = 0; k < 5; k++) {
        TEST_ASSERT_EQUAL(k == 2, isnan(at(k).measured_rad[EXK_BETA]) != 0);
    }
}

static void values_are_those_of_the_header(void)
{
    set(EXK_INJECT_INF, 0.0, 1.0);
    TEST_ASSERT_TRUE(at(0).measured_rad[0] == (double)INFINITY);
    TEST_ASSERT_TRUE(at(1).measured_rad[0] == -(double)INFINITY);
    set(EXK_INJECT_RANGE, 0.0, 1.0);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 10.003, at(3).measured_rad[0]);
    cfg.fault[0].size_rad = 0.25;
    set(EXK_INJECT_SPIKE, 0.0, 1.0);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.253, at(3).measured_rad[0]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.246, at(4).measured_rad[1]);
}

static void one_channel_leaves_the_other_alone(void)
{
    cfg.fault[0].channel[EXK_ALPHA] = false;
    set(EXK_INJECT_NAN, 0.0, 1.0);
    const exk_reading r = at(7);
    TEST_ASSERT_TRUE(r.measured_rad[EXK_ALPHA] == 0.007);
    TEST_ASSERT_TRUE(isnan(r.measured_rad[EXK_BETA]));
}

static void stuck_is_the_value_of_the_tick_before(void)
{
    set(EXK_INJECT_STUCK, 0.005, 0.01);
    for (int64_t k = 0; k < 15; k++) {
        TEST_ASSERT_TRUE(at(k).measured_rad[0] == 1e-3 * (double)(k < 5 ? k : 4));
    }
    set(EXK_INJECT_STUCK, 0.0, 0.01); /* from the first tick on: that one */
    TEST_ASSERT_TRUE(at(0).measured_rad[0] == 0.0);
    TEST_ASSERT_TRUE(at(1).measured_rad[0] == 0.0);
}

static void dropout_and_delay_say_so(void)
{
    set(EXK_INJECT_DROPOUT, 0.0, 1.0);
    TEST_ASSERT_FALSE(at(3).fresh);
    cfg.fault[0].delay_s = 0.004;
    set(EXK_INJECT_DELAY, 0.0, 1.0);
    TEST_ASSERT_FALSE(at(0).fresh); /* nothing came before tick 0 */
    for (int64_t k = 1; k < 600; k++) {
        const exk_reading r = at(k);
        TEST_ASSERT_EQUAL(k >= 4, r.fresh);
        if (k >= 4) {
            TEST_ASSERT_EQUAL_INT64(4, r.age);
            TEST_ASSERT_TRUE(r.measured_rad[0] == 1e-3 * (double)(k - 4));
        }
    }
    TEST_ASSERT_FALSE(at(900).fresh); /* tick 896 was skipped */
}

static void ticks_before_zero_are_taken(void)
{
    set(EXK_INJECT_DELAY, 0.0, 1.0);
    exk_reading r = whole(-3);
    exk_inject_apply(&inject, -3, &r);
    TEST_ASSERT_TRUE(r.fresh);
}

/* The same bits again for the same realisation, others for another; half of them within 0.5 rad. */
static void garbage_is_drawn(void)
{
    enum { N = 100 };
    double first[N];
    set(EXK_INJECT_GARBAGE, 0.0, 1.0);
    for (int64_t k = 0; k < N; k++) {
        first[k] = at(k).measured_rad[0];
        TEST_ASSERT_TRUE(k % 2 == 0 || fabs(first[k]) <= 0.5);
    }
    start();
    int n_other = 0;
    for (int64_t k = 0; k < N; k++) {
        const exk_reading r = at(k);
        TEST_ASSERT_TRUE(r.measured_rad[0] == first[k] || (isnan(first[k]) != 0));
        n_other += r.measured_rad[0] != r.measured_rad[1] ? 1 : 0;
    }
    TEST_ASSERT_EQUAL_INT(N, n_other);
    const exk_realisation other = {.seed = 4, .series = 1, .run = 2};
    TEST_ASSERT_EQUAL(EXK_OK, exk_inject_init(&inject, &cfg, dt_s, other));
    TEST_ASSERT_TRUE(at(1).measured_rad[0] != first[1]);
}

static void faults_act_in_their_order(void)
{
    cfg.n_faults = 2;
    cfg.fault[1] = cfg.fault[0];
    cfg.fault[1].kind = EXK_INJECT_SPIKE;
    cfg.fault[1].for_s = 1.0;
    cfg.fault[1].size_rad = 0.5;
    set(EXK_INJECT_STUCK, 0.003, 1.0);
    at(2);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.502, at(3).measured_rad[0]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.502, at(4).measured_rad[0]);
}

static exk_err inner(void *ctx, int64_t k, const exk_drive *drive, exk_reading *out)
{
    (void)drive;
    *out = whole(k);
    return *(exk_err *)ctx;
}

static void a_source_has_the_faults_in_it(void)
{
    exk_err answer = EXK_OK;
    exk_reading r;
    const exk_drive drive = {.angle_rad = {0.0, 0.0}};
    const exk_source plain = {.exchange = inner, .ctx = &answer};
    set(EXK_INJECT_NAN, 0.0, 1.0);
    const exk_source spoilt = exk_inject_source(&inject, plain);
    TEST_ASSERT_EQUAL(EXK_OK, spoilt.exchange(spoilt.ctx, 3, &drive, &r));
    TEST_ASSERT_TRUE(isnan(r.measured_rad[0]));
    answer = EXK_ERR_END;
    TEST_ASSERT_EQUAL(EXK_ERR_END, spoilt.exchange(spoilt.ctx, 4, &drive, &r));
    TEST_ASSERT_TRUE(r.measured_rad[0] == 0.004);
    cfg.n_faults = 0;
    start();
    TEST_ASSERT_TRUE(exk_inject_source(&inject, plain).ctx == &answer);
}

static const struct {
    const char *name;
    exk_err want;
    int kind;
    double at_s, for_s, size_rad, delay_s, dt;
} rows[] = {
    {"good", EXK_OK, EXK_INJECT_NAN, 1.0, 1.0, 1.0, 0.255, 0.001},
    {"delay longer than kept", EXK_ERR_ARG, EXK_INJECT_DELAY, 0.0, 0.0, 0.0, 0.2561, 0.001},
    {"delay negative", EXK_ERR_ARG, EXK_INJECT_DELAY, 0.0, 0.0, 0.0, -1e-9, 0.001},
    {"delay NaN", EXK_ERR_ARG, EXK_INJECT_DELAY, 0.0, 0.0, 0.0, (double)NAN, 0.001},
    {"kind", EXK_ERR_ARG, EXK_INJECT_COUNT, 0.0, 0.0, 0.0, 0.0, 0.001},
    {"kind negative", EXK_ERR_ARG, -1, 0.0, 0.0, 0.0, 0.0, 0.001},
    {"at negative", EXK_ERR_ARG, 1, -1.0, 0.0, 0.0, 0.0, 0.001},
    {"at NaN", EXK_ERR_ARG, 1, (double)NAN, 0.0, 0.0, 0.0, 0.001},
    {"at too late", EXK_ERR_ARG, 1, 1e13, 0.0, 0.0, 0.0, 0.001},
    {"for negative", EXK_ERR_ARG, 1, 0.0, -1.0, 0.0, 0.0, 0.001},
    {"for infinite", EXK_ERR_ARG, 1, 0.0, (double)INFINITY, 0.0, 0.0, 0.001},
    {"size NaN", EXK_ERR_ARG, 1, 0.0, 0.0, (double)NAN, 0.0, 0.001},
    {"dt zero", EXK_ERR_ARG, 1, 0.0, 0.0, 0.0, 0.0, 0.0},
    {"dt NaN", EXK_ERR_ARG, 1, 0.0, 0.0, 0.0, 0.0, (double)NAN},
    {"dt infinite", EXK_ERR_ARG, 1, 0.0, 0.0, 0.0, 0.0, (double)INFINITY},
};

static void configurations_are_refused_by_the_table(void)
{
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        cfg.fault[0].kind = (exk_inject_kind)rows[i].kind;
        cfg.fault[0].at_s = rows[i].at_s;
        cfg.fault[0].for_s = rows[i].for_s;
        cfg.fault[0].size_rad = rows[i].size_rad;
        cfg.fault[0].delay_s = rows[i].delay_s;
        TEST_ASSERT_EQUAL_MESSAGE(
            rows[i].want, exk_inject_init(&inject, &cfg, rows[i].dt, which), rows[i].name);
    }
    cfg.n_faults = EXK_MAX_INJECTED + 1;
    TEST_ASSERT_EQUAL(EXK_ERR_SIZE, exk_inject_init(&inject, &cfg, dt_s, which));
}

static void names_are_never_null(void)
{
    for (int i = -1; i <= EXK_INJECT_COUNT; i++) {
        TEST_ASSERT_NOT_NULL(exk_inject_name((exk_inject_kind)i));
    }
    TEST_ASSERT_EQUAL_STRING("delay", exk_inject_name(EXK_INJECT_DELAY));
    TEST_ASSERT_EQUAL_STRING("unknown", exk_inject_name(EXK_INJECT_COUNT));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(each_fault_acts_in_its_own_time_only);
    RUN_TEST(a_fault_of_no_length_acts_once);
    RUN_TEST(values_are_those_of_the_header);
    RUN_TEST(one_channel_leaves_the_other_alone);
    RUN_TEST(stuck_is_the_value_of_the_tick_before);
    RUN_TEST(dropout_and_delay_say_so);
    RUN_TEST(ticks_before_zero_are_taken);
    RUN_TEST(garbage_is_drawn);
    RUN_TEST(faults_act_in_their_order);
    RUN_TEST(a_source_has_the_faults_in_it);
    RUN_TEST(configurations_are_refused_by_the_table);
    RUN_TEST(names_are_never_null);
    return UNITY_END();
}
