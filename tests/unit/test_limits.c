/* Every limit on what is commanded, from just inside to NaN, and the words of its report. */
#include "exk/limits.h"

#include <math.h>

#include "unity.h"

static exk_limits limits;
static exk_limits_config cfg;
static exk_violation what;

/* One command, in place of the pointers of a step. */
typedef struct {
    double tip_m[3], r_rad[EXK_N_AXES], q_rad[EXK_N_AXES], legs_m[EXK_N_LEGS];
} command;

static const command good = {{0.1, -0.2, 1.0}, {0.30, -0.30}, {0.31, -0.31}, {1.0, 1.1, 1.2}};

void setUp(void)
{
    cfg = exk_limits_default();
    cfg.dt_s = 0.01;
    cfg.angle_max_rad = 0.5;
    cfg.correction_max_rad = 0.02;
    cfg.rate_max_radps = 2.0;
    cfg.leg_min_m = 0.5;
    cfg.leg_max_m = 1.5;
    cfg.leg_speed_max_mps = 3.0;
    cfg.following_rad = 0.01;
    cfg.following_time_s = 0.1;
    for (int i = 0; i < 3; i++) {
        cfg.box_min_m[i] = -2.0;
        cfg.box_max_m[i] = 2.0;
    }
    TEST_ASSERT_EQUAL(EXK_OK, exk_limits_init(&limits, &cfg));
    what = (exk_violation){EXK_QUANTITY_NONE, -1, 0.0, 0.0};
}

void tearDown(void)
{
}

static bool ask(int64_t k, const command *c)
{
    const exk_limits_step step = {c->tip_m, c->r_rad, c->q_rad, c->legs_m};
    return exk_limits_command(&limits, k, &step, &what);
}

static void reported(exk_quantity quantity, int index, double value, double limit)
{
    TEST_ASSERT_EQUAL_STRING(exk_quantity_name(quantity), exk_quantity_name(what.quantity));
    TEST_ASSERT_EQUAL_INT(index, what.index);
    TEST_ASSERT_EQUAL_DOUBLE(limit, what.limit);
    if (isnan(value)) {
        TEST_ASSERT_TRUE(isnan(what.value));
    } else {
        TEST_ASSERT_DOUBLE_WITHIN(1e-9 * fabs(value), value, what.value);
    }
}

/* Angle, both ways; r follows so that the correction stays small. */
static void each_angle_has_its_limit(void)
{
    static const double bad[] = {0.5 * (1.0 + 1e-9), -0.51, (double)INFINITY, -(double)INFINITY,
                                 (double)NAN};
    for (int i = 0; i < EXK_N_AXES; i++) {
        command c = good;
        c.r_rad[i] = 0.5;
        c.q_rad[i] = 0.5;
        setUp();
        TEST_ASSERT_TRUE(ask(0, &c));
        for (size_t j = 0; j < sizeof bad / sizeof bad[0]; j++) {
            setUp();
            c.q_rad[i] = bad[j];
            c.r_rad[i] = isnan(bad[j]) ? 0.0 : bad[j];
            TEST_ASSERT_FALSE(ask(0, &c));
            reported(EXK_QUANTITY_ANGLE, i, bad[j], 0.5);
        }
    }
}

static void each_correction_has_its_limit(void)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        command c = good;
        c.r_rad[i] = 0.25;
        c.q_rad[i] = 0.271;
        TEST_ASSERT_FALSE(ask(0, &c));
        reported(EXK_QUANTITY_CORRECTION, i, 0.021, 0.02);
        c.r_rad[i] = (double)NAN;
        TEST_ASSERT_FALSE(ask(0, &c));
        reported(EXK_QUANTITY_CORRECTION, i, (double)NAN, 0.02);
    }
}

/* rate = step/(ticks dt): 2 rad/s at 10 ms is 0.02 rad a tick; over three ticks 0.06 are fine. */
static void each_rate_has_its_limit_over_the_ticks_that_went_by(void)
{
    for (int i = 0; i < EXK_N_AXES; i++) {
        command c = good;
        setUp();
        TEST_ASSERT_TRUE(ask(10, &c));
        c.q_rad[i] += 0.03;
        c.r_rad[i] += 0.03;
        TEST_ASSERT_FALSE(ask(11, &c));
        reported(EXK_QUANTITY_RATE, i, 3.0, 2.0);
        TEST_ASSERT_FALSE(ask(10, &c)); /* a tick that does not rise counts as one */
        reported(EXK_QUANTITY_RATE, i, 3.0, 2.0);
        TEST_ASSERT_TRUE(ask(12, &c)); /* 1.5 rad/s; what was refused is not remembered */
        exk_limits_reset(&limits);
        c.q_rad[i] = 0.0;
        c.r_rad[i] = 0.0;
        TEST_ASSERT_TRUE(ask(13, &c)); /* nothing is known of speed */
    }
}

static void while_nothing_is_sent_no_time_passes(void)
{
    command c = good;
    TEST_ASSERT_TRUE(ask(0, &c));
    exk_limits_stand(&limits, 100);
    c.q_rad[0] += 0.03;
    c.r_rad[0] += 0.03;
    TEST_ASSERT_FALSE(ask(101, &c));
    reported(EXK_QUANTITY_RATE, 0, 3.0, 2.0);
}

static void each_leg_has_its_limits(void)
{
    for (int i = 0; i < EXK_N_LEGS; i++) {
        static const double bad[] = {1.6, (double)INFINITY, (double)NAN};
        command c = good;
        for (size_t j = 0; j < sizeof bad / sizeof bad[0]; j++) {
            setUp();
            c.legs_m[i] = bad[j];
            TEST_ASSERT_FALSE(ask(0, &c));
            reported(EXK_QUANTITY_LEG, i, bad[j], 1.5);
        }
        c.legs_m[i] = 0.4;
        TEST_ASSERT_FALSE(ask(0, &c));
        reported(EXK_QUANTITY_LEG, i, 0.4, 0.5);
        TEST_ASSERT_TRUE(ask(0, &good));
        c.legs_m[i] = good.legs_m[i] - 0.04;
        TEST_ASSERT_FALSE(ask(1, &c));
        reported(EXK_QUANTITY_LEG_SPEED, i, -4.0, 3.0);
        TEST_ASSERT_TRUE(ask(2, &c));
    }
}

static void each_coordinate_has_its_limits(void)
{
    for (int i = 0; i < 3; i++) {
        static const double high[] = {2.1, (double)INFINITY, (double)NAN};
        command c = good;
        for (size_t j = 0; j < sizeof high / sizeof high[0]; j++) {
            c.tip_m[i] = high[j];
            TEST_ASSERT_FALSE(ask(0, &c));
            reported(EXK_QUANTITY_WORKSPACE, i, high[j], 2.0);
        }
        c.tip_m[i] = -2.1;
        TEST_ASSERT_FALSE(ask(0, &c));
        reported(EXK_QUANTITY_WORKSPACE, i, -2.1, -2.0);
    }
}

/* What is unlimited still has to be a number. */
static void without_limits_numbers_must_be_finite(void)
{
    cfg = exk_limits_default();
    TEST_ASSERT_EQUAL(EXK_OK, exk_limits_init(&limits, &cfg));
    for (int n = 0; n < EXK_N_AXES + EXK_N_LEGS + 3; n++) {
        command c = good;
        double *const all[] = {&c.q_rad[0],  &c.q_rad[1], &c.legs_m[0], &c.legs_m[1],
                               &c.legs_m[2], &c.tip_m[0], &c.tip_m[1],  &c.tip_m[2]};
        *all[n] = (double)INFINITY;
        TEST_ASSERT_FALSE(ask(0, &c));
        *all[n] = (double)NAN;
        TEST_ASSERT_FALSE(ask(0, &c));
        *all[n] = 1e6;
        TEST_ASSERT_TRUE(ask(0, &c));
        exk_limits_reset(&limits);
    }
}

/* 0.01 rad at rest; at 1 rad/s 0.1 s more of it. */
static void the_following_error_may_grow_with_speed(void)
{
    command c = good;
    double m_rad[EXK_N_AXES] = {0.31 + 0.009, -0.31 - 0.009};
    TEST_ASSERT_TRUE(ask(0, &c));
    TEST_ASSERT_TRUE(exk_limits_following(&limits, m_rad, &what));
    m_rad[1] = -0.31 - 0.011;
    TEST_ASSERT_FALSE(exk_limits_following(&limits, m_rad, &what));
    reported(EXK_QUANTITY_FOLLOWING, 1, 0.011, 0.01);
    c.q_rad[0] += 0.01;
    c.r_rad[0] += 0.01;
    TEST_ASSERT_TRUE(ask(1, &c));
    m_rad[0] = c.q_rad[0] - 0.1;
    m_rad[1] = c.q_rad[1];
    TEST_ASSERT_TRUE(exk_limits_following(&limits, m_rad, &what));
    exk_limits_stand(&limits, 2);
    TEST_ASSERT_FALSE(exk_limits_following(&limits, m_rad, &what));
    m_rad[0] = (double)NAN;
    TEST_ASSERT_FALSE(exk_limits_following(&limits, m_rad, &what));
    reported(EXK_QUANTITY_FOLLOWING, 0, (double)NAN, 0.01);
}

static void legs_are_asked_for_when_one_could_be_beyond(void)
{
    cfg = exk_limits_default();
    for (int n = 0; n < 4; n++) {
        exk_limits_config c = cfg;
        c.leg_min_m = n == 1 ? 0.1 : c.leg_min_m;
        c.leg_max_m = n == 2 ? 9.0 : c.leg_max_m;
        c.leg_speed_max_mps = n == 3 ? 9.0 : c.leg_speed_max_mps;
        TEST_ASSERT_EQUAL(EXK_OK, exk_limits_init(&limits, &c));
        TEST_ASSERT_EQUAL(n > 0, exk_limits_ask_legs(&limits));
    }
}

/* Each number of the configuration, one after the other. */
static void configurations_are_refused_by_the_table(void)
{
    enum { ZERO = 1, INF = 2 }; /* allowed beside plain numbers */
    double *const numbers[] = {&cfg.dt_s,
                               &cfg.angle_max_rad,
                               &cfg.correction_max_rad,
                               &cfg.rate_max_radps,
                               &cfg.leg_min_m,
                               &cfg.leg_max_m,
                               &cfg.leg_speed_max_mps,
                               &cfg.following_rad,
                               &cfg.following_time_s};
    static const int allowed[] = {0, 3, 3, 3, ZERO, INF, 3, 3, ZERO};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        static const struct {
            double value;
            int needs;
        } rows[] = {{(double)NAN, 4}, {-1.0, 4}, {0.0, ZERO}, {(double)INFINITY, INF}};
        for (size_t j = 0; j < sizeof rows / sizeof rows[0]; j++) {
            setUp();
            *numbers[i] = rows[j].value;
            TEST_ASSERT_EQUAL((allowed[i] & rows[j].needs) != 0 ? EXK_OK : EXK_ERR_ARG,
                              exk_limits_init(&limits, &cfg));
        }
    }
    for (int i = 0; i < 3; i++) {
        setUp();
        cfg.box_min_m[i] = 2.1;
        TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_limits_init(&limits, &cfg));
        setUp();
        cfg.box_max_m[i] = (double)NAN;
        TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_limits_init(&limits, &cfg));
    }
}

static void every_quantity_has_its_words(void)
{
    for (int i = EXK_QUANTITY_NONE + 1; i < EXK_QUANTITY_COUNT; i++) {
        const exk_quantity q = (exk_quantity)i;
        TEST_ASSERT_TRUE(exk_quantity_name(q)[0] != '\0');
        TEST_ASSERT_TRUE(exk_quantity_advice(q)[0] != '\0');
        TEST_ASSERT_NOT_NULL(exk_quantity_unit(q));
    }
    TEST_ASSERT_EQUAL_STRING("beta", exk_quantity_part(EXK_QUANTITY_RATE, 1));
    TEST_ASSERT_EQUAL_STRING("leg 3", exk_quantity_part(EXK_QUANTITY_LEG, 2));
    TEST_ASSERT_EQUAL_STRING("z", exk_quantity_part(EXK_QUANTITY_WORKSPACE, 2));
    TEST_ASSERT_EQUAL_STRING("", exk_quantity_part(EXK_QUANTITY_DEADLINES, 0));
    TEST_ASSERT_EQUAL_STRING("", exk_quantity_part(EXK_QUANTITY_LEG, 3));
    TEST_ASSERT_EQUAL_STRING("", exk_quantity_part(EXK_QUANTITY_LEG, -1));
    TEST_ASSERT_EQUAL_STRING("m/s", exk_quantity_unit(EXK_QUANTITY_LEG_SPEED));
    TEST_ASSERT_EQUAL_STRING("nothing", exk_quantity_name(EXK_QUANTITY_COUNT));
    TEST_ASSERT_EQUAL_STRING("nothing", exk_quantity_name((exk_quantity)-1));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(each_angle_has_its_limit);
    RUN_TEST(each_correction_has_its_limit);
    RUN_TEST(each_rate_has_its_limit_over_the_ticks_that_went_by);
    RUN_TEST(while_nothing_is_sent_no_time_passes);
    RUN_TEST(each_leg_has_its_limits);
    RUN_TEST(each_coordinate_has_its_limits);
    RUN_TEST(without_limits_numbers_must_be_finite);
    RUN_TEST(the_following_error_may_grow_with_speed);
    RUN_TEST(legs_are_asked_for_when_one_could_be_beyond);
    RUN_TEST(configurations_are_refused_by_the_table);
    RUN_TEST(every_quantity_has_its_words);
    return UNITY_END();
}
