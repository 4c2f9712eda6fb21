/* Which gains init accepts, against the closed loop itself run forward: e[k] = -c[k], c one step
 * later. The simulation below is written from the equations in the header, not from the source. */
#include <math.h>
#include <stdbool.h>

#include "exk/pid.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { N_STEPS = 2000 };

typedef struct {
    double c, i, d, e_last;
} state;

static double size(const state *s)
{
    return fabs(s->c) + fabs(s->i) + fabs(s->d) + fabs(s->e_last);
}

static double pole_of(const exk_pid_config *cfg)
{
    return cfg->d_filter_s > 0.0 ? exp(-cfg->dt_s / cfg->d_filter_s) : 0.0;
}

static void advance(state *s, const exk_pid_config *cfg)
{
    const double b = pole_of(cfg);
    const double e = -s->c;
    s->i += cfg->ki * cfg->dt_s * e;
    s->d = b * s->d + (1.0 - b) * cfg->kd * (e - s->e_last) / cfg->dt_s;
    s->c = cfg->kp * e + s->i + s->d;
    s->e_last = e;
}

/* Mean growth of the state in a step, from an arbitrary start: below 0 the loop settles. Without
 * integral action the integral stays what it is, so it starts at 0 there. */
static double growth(const exk_pid_config *cfg)
{
    state s = {1.0, cfg->ki > 0.0 ? -0.6 : 0.0, 0.3, 0.7};
    const double first = size(&s);
    int k = 0;
    while (k < N_STEPS && size(&s) < 1e100 && size(&s) > 1e-100) {
        advance(&s, cfg);
        k++;
    }
    return log(size(&s) / first) / k;
}

static bool pi_rule(const exk_pid_config *cfg)
{
    return cfg->kp < 1.0 && cfg->ki * cfg->dt_s < 2.0 * (1.0 - cfg->kp);
}

static bool accepted(const exk_pid_config *cfg)
{
    exk_pid pid;
    return exk_pid_init(&pid, cfg) == EXK_OK;
}

/* Loops this near the border are left to the border test: 2000 steps cannot tell them. */
static const double UNDECIDED = 5e-3;

static struct {
    int accepted, refused, by_derivative, undecided;
} count;

static void check(const exk_pid_config *cfg)
{
    const double rate = growth(cfg);
    if (fabs(rate) < UNDECIDED) {
        count.undecided++;
        return;
    }
    const bool want = pi_rule(cfg) && rate < 0.0;
    TEST_ASSERT_EQUAL(want, accepted(cfg));
    count.accepted += want;
    count.refused += !want;
    count.by_derivative += !want && pi_rule(cfg);
}

static void accepted_gains_settle_and_refused_ones_do_not(void)
{
    static const double kd_over_dt[] = {0.0, 0.02, 0.1, 0.3, 0.6, 1.1};
    static const double filter_over_dt[] = {0.0, 0.5, 3.0, 20.0};
    const double dt_s = 1e-3;
    for (int p = 0; p <= 11; p++) {
        for (int i = 0; i <= 11; i++) {
            for (int j = 0; j < 6 * 4; j++) {
                check(&(exk_pid_config){.kp = 0.1 * p,
                                        .ki = 0.19 * i / dt_s,
                                        .kd = kd_over_dt[j % 6] * dt_s,
                                        .d_filter_s = filter_over_dt[j / 6] * dt_s,
                                        .c_max_rad = 1.0,
                                        .dt_s = dt_s});
            }
        }
    }
    TEST_ASSERT_GREATER_THAN(800, count.accepted);
    TEST_ASSERT_GREATER_THAN(800, count.refused);
    TEST_ASSERT_GREATER_THAN(100, count.by_derivative);
    TEST_ASSERT_LESS_THAN(100, count.undecided);
}

/* For kp = 0 and no filter the border of the derivative gain is known: the cubic
 * z^3 + (g - 1 + h) z^2 - 2 h z + h has z = -1 as a root at h = (2 - g)/4. */
static void the_border_of_the_derivative_gain_is_where_algebra_puts_it(void)
{
    for (int i = 1; i < 20; i++) {
        const double g = 0.1 * i;
        const double border = (2.0 - g) / 4.0;
        exk_pid_config cfg = {.ki = g, .c_max_rad = 1.0, .dt_s = 1.0};
        cfg.kd = border * (1.0 - 1e-12);
        TEST_ASSERT_TRUE(accepted(&cfg));
        cfg.kd = border * (1.0 + 1e-12);
        TEST_ASSERT_FALSE(accepted(&cfg));
        cfg.kd = border * 0.9;
        TEST_ASSERT_TRUE(growth(&cfg) < 0.0);
        cfg.kd = border * 1.1;
        TEST_ASSERT_TRUE(growth(&cfg) > 0.0);
    }
}

/* The real controller in the loop, far from its limit, follows the simulation. */
static void the_controller_is_the_simulated_one(void)
{
    const exk_pid_config cfg = {0.3, 200.0, 1e-4, 2e-3, 1e6, 1e-3};
    exk_pid pid;
    TEST_ASSERT_EQUAL(EXK_OK, exk_pid_init(&pid, &cfg));
    exk_pid_preset(&pid, 1.0, 0.7);
    state s = {1.0, 1.0 - 0.3 * 0.7, 0.0, 0.7};
    double c = 1.0;
    for (int k = 0; k < 100; k++) {
        advance(&s, &cfg);
        c = exk_pid_step(&pid, -c);
        TEST_ASSERT_DOUBLE_WITHIN(1e-14, s.c, c);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(accepted_gains_settle_and_refused_ones_do_not);
    RUN_TEST(the_border_of_the_derivative_gain_is_where_algebra_puts_it);
    RUN_TEST(the_controller_is_the_simulated_one);
    return UNITY_END();
}
