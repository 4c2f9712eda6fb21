#include <float.h>
#include <math.h>

#include "exk/ilc.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* --- what check refuses ----------------------------------------------------------------------- */

/* gain, d_gain, lead, cutoff, u_max, dt. */
static const struct {
    const char *name;
    exk_ilc_config cfg;
    exk_err want;
} checks[] = {
    {"P", {0.5, 0.0, 0, 0.0, 0.1, 1e-3}, EXK_OK},
    {"gain just below 2", {2.0 - 1e-15, 0.0, 0, 0.0, 0.1, 1e-3}, EXK_OK},
    {"gain 2", {2.0, 0.0, 0, 0.0, 0.1, 1e-3}, EXK_ERR_ARG},
    {"gain 0", {0.0, 0.0, 0, 0.0, 0.1, 1e-3}, EXK_ERR_ARG},
    {"gain negative", {-0.5, 0.0, 0, 0.0, 0.1, 1e-3}, EXK_ERR_ARG},
    {"PD just below its border", {0.5, 0.75 - 1e-15, 0, 0.0, 0.1, 1.0}, EXK_OK},
    {"PD at its border", {0.5, 0.75, 0, 0.0, 0.1, 1.0}, EXK_ERR_ARG},
    {"PD through dt", {0.5, 0.75e-3, 0, 0.0, 0.1, 1e-3}, EXK_ERR_ARG},
    {"d gain negative", {0.5, -1e-9, 0, 0.0, 0.1, 1e-3}, EXK_ERR_ARG},
    {"longest lead", {0.5, 0.0, EXK_ILC_LEAD_MAX, 0.0, 0.1, 1e-3}, EXK_OK},
    {"lead too long", {0.5, 0.0, EXK_ILC_LEAD_MAX + 1, 0.0, 0.1, 1e-3}, EXK_ERR_ARG},
    {"lead negative", {0.5, 0.0, -1, 0.0, 0.1, 1e-3}, EXK_ERR_ARG},
    {"cutoff just below half of Nyquist", {0.5, 0.0, 0, 0.2499, 0.1, 1.0}, EXK_OK},
    {"cutoff at half of Nyquist", {0.5, 0.0, 0, 0.25, 0.1, 1.0}, EXK_ERR_ARG},
    {"cutoff negative", {0.5, 0.0, 0, -1.0, 0.1, 1e-3}, EXK_ERR_ARG},
    {"limit 0", {0.5, 0.0, 0, 0.0, 0.0, 1e-3}, EXK_ERR_ARG},
    {"limit negative", {0.5, 0.0, 0, 0.0, -0.1, 1e-3}, EXK_ERR_ARG},
    {"dt 0", {0.5, 0.0, 0, 0.0, 0.1, 0.0}, EXK_ERR_ARG},
    {"dt negative", {0.5, 0.0, 0, 0.0, 0.1, -1e-3}, EXK_ERR_ARG},
    {"gain NaN", {NAN, 0.0, 0, 0.0, 0.1, 1e-3}, EXK_ERR_ARG},
    {"d gain NaN", {0.5, NAN, 0, 0.0, 0.1, 1e-3}, EXK_ERR_ARG},
    {"cutoff NaN", {0.5, 0.0, 0, NAN, 0.1, 1e-3}, EXK_ERR_ARG},
    {"limit NaN", {0.5, 0.0, 0, 0.0, NAN, 1e-3}, EXK_ERR_ARG},
    {"dt NaN", {0.5, 0.0, 0, 0.0, 0.1, NAN}, EXK_ERR_ARG},
    {"gain Inf", {INFINITY, 0.0, 0, 0.0, 0.1, 1e-3}, EXK_ERR_ARG},
    {"d gain Inf", {0.5, INFINITY, 0, 0.0, 0.1, 1e-3}, EXK_ERR_ARG},
    {"cutoff Inf", {0.5, 0.0, 0, INFINITY, 0.1, 1e-3}, EXK_ERR_ARG},
    {"limit Inf", {0.5, 0.0, 0, 0.0, INFINITY, 1e-3}, EXK_ERR_ARG},
    {"dt Inf", {0.5, 0.0, 0, 0.0, 0.1, INFINITY}, EXK_ERR_ARG},
};

static void check_and_learn_refuse_by_the_table(void)
{
    const double one[1] = {0.01};
    for (size_t i = 0; i < sizeof checks / sizeof *checks; i++) {
        double next[1];
        TEST_ASSERT_EQUAL_MESSAGE(checks[i].want, exk_ilc_check(&checks[i].cfg),
                                  checks[i].name);
        TEST_ASSERT_EQUAL_MESSAGE(checks[i].want,
                                  exk_ilc_learn(&checks[i].cfg, one, one, one, 1, next),
                                  checks[i].name);
    }
}

static void the_default_is_the_law_of_the_study(void)
{
    const exk_ilc_config cfg = exk_ilc_default();
    TEST_ASSERT_EQUAL(EXK_OK, exk_ilc_check(&cfg));
    TEST_ASSERT_TRUE(cfg.d_gain_s == 0.0 && cfg.lead == 0 && cfg.cutoff_Hz == 0.0);
}

/* --- the law ---------------------------------------------------------------------------------- */

enum { N = 100 };

typedef struct {
    double u[N], e[N], c[N], next[N];
} arrays;

static void fill(arrays *a)
{
    for (int k = 0; k < N; k++) {
        a->u[k] = sin(0.37 * k) - 0.2;
        a->e[k] = cos(1.7 * k) * 0.5;
        a->c[k] = sin(2.9 * k + 1.0) * 0.25;
        a->next[k] = NAN;
    }
}

/* u_{p+1}[k] of the header for one sample, without Q. */
static double law(const exk_ilc_config *cfg, const arrays *a, int n, int k)
{
    const int at = k + cfg->lead < n ? k + cfg->lead : n - 1;
    const int before = k - 1 + cfg->lead < n ? k - 1 + cfg->lead : n - 1;
    const double x = a->e[at] + a->c[k];
    const double x_before = k > 0 ? a->e[before] + a->c[k - 1] : x;
    const double u = a->u[k] + cfg->gain * x + cfg->d_gain_s * (x - x_before) / cfg->dt_s;
    return fmax(-cfg->u_max_rad, fmin(cfg->u_max_rad, u));
}

static const exk_ilc_config laws[] = {
    {0.5, 0.0, 0, 0.0, 10.0, 1e-3},    {1.3, 0.0, 0, 0.0, 0.3, 1e-3},
    {0.5, 0.0, 1, 0.0, 10.0, 1e-3},    {0.5, 0.0, 37, 0.0, 0.3, 1e-3},
    {0.5, 0.0, 1000, 0.0, 10.0, 1e-3}, {0.5, 3e-4, 0, 0.0, 10.0, 1e-3},
    {0.5, 3e-4, 5, 0.0, 0.3, 1e-3},    {0.5, 3e-4, 1000, 0.0, 10.0, 1e-3},
};
enum { N_LAWS = sizeof laws / sizeof *laws };

/* Every length from 1 to N: whole blocks, their remainders, leads past the end. */
static void learn_follows_the_law_at_every_length(void)
{
    for (int i = 0; i < N_LAWS; i++) {
        for (int n = 1; n <= N; n++) {
            arrays a;
            fill(&a);
            TEST_ASSERT_EQUAL(EXK_OK,
                              exk_ilc_learn(&laws[i], a.u, a.e, a.c, (size_t)n, a.next));
            for (int k = 0; k < n; k++) {
                TEST_ASSERT_DOUBLE_WITHIN(1e-14, law(&laws[i], &a, n, k), a.next[k]);
            }
            TEST_ASSERT_TRUE(n == N || isnan(a.next[n]));
        }
    }
}

static void the_stored_correction_is_never_written(void)
{
    arrays a;
    arrays before;
    fill(&a);
    fill(&before);
    const exk_ilc_config cfg = {0.5, 1e-4, 2, 50.0, 0.1, 1e-3};
    TEST_ASSERT_EQUAL(EXK_OK, exk_ilc_learn(&cfg, a.u, a.e, a.c, N, a.next));
    a.e[50] = NAN;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_ilc_learn(&cfg, a.u, a.e, a.c, N, a.next));
    TEST_ASSERT_EQUAL_MEMORY(before.u, a.u, sizeof a.u);
}

/* --- what learn refuses ----------------------------------------------------------------------- */

static void no_samples_are_the_wrong_size(void)
{
    arrays a;
    fill(&a);
    TEST_ASSERT_EQUAL(EXK_ERR_SIZE, exk_ilc_learn(&laws[0], a.u, a.e, a.c, 0, a.next));
}

static void an_overlap_is_refused(void)
{
    static const struct {
        const char *name;
        int u, e, c, next;
        exk_err want;
    } rows[] = {
        {"side by side", 0, 10, 20, 30, EXK_OK},
        {"before the inputs", 10, 20, 30, 0, EXK_OK},
        {"inputs may be one array", 0, 0, 0, 10, EXK_OK},
        {"onto u", 0, 10, 20, 0, EXK_ERR_ARG},
        {"onto e", 0, 10, 20, 10, EXK_ERR_ARG},
        {"onto c", 0, 10, 20, 20, EXK_ERR_ARG},
        {"one sample into u", 10, 20, 30, 1, EXK_ERR_ARG},
        {"one sample out of u", 0, 20, 30, 9, EXK_ERR_ARG},
        {"one sample into e", 20, 10, 30, 1, EXK_ERR_ARG},
        {"one sample out of e", 20, 0, 30, 9, EXK_ERR_ARG},
        {"one sample into c", 20, 30, 10, 1, EXK_ERR_ARG},
        {"one sample out of c", 20, 30, 0, 9, EXK_ERR_ARG},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double space[40] = {0.0};
        const exk_err err = exk_ilc_learn(&laws[0], space + rows[i].u, space + rows[i].e,
                                          space + rows[i].c, 10, space + rows[i].next);
        TEST_ASSERT_EQUAL_MESSAGE(rows[i].want, err, rows[i].name);
    }
}

static exk_err learn_with(const exk_ilc_config *cfg, int which, int k, double value)
{
    arrays a;
    fill(&a);
    double *const input[3] = {a.u, a.e, a.c};
    input[which][k] = value;
    return exk_ilc_learn(cfg, a.u, a.e, a.c, N, a.next);
}

/* Every sample of every input, under every law, with and without Q; also samples of e that a lead
 * passes over. */
static void a_value_that_is_not_finite_is_refused_wherever_it_is(void)
{
    static const double bad[] = {NAN, -NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 2 * N_LAWS; i++) {
        exk_ilc_config cfg = laws[i % N_LAWS];
        cfg.cutoff_Hz = i < N_LAWS ? 0.0 : 40.0;
        for (int which = 0; which < 3; which++) {
            for (int k = 0; k < N; k++) {
                TEST_ASSERT_EQUAL(EXK_ERR_ARG, learn_with(&cfg, which, k, bad[k % 4]));
            }
        }
    }
}

static void infinities_that_cancel_are_refused(void)
{
    arrays a;
    fill(&a);
    a.e[3] = INFINITY;
    a.c[3] = -INFINITY;
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_ilc_learn(&laws[0], a.u, a.e, a.c, N, a.next));
}

static void an_overflow_on_the_way_out_is_refused(void)
{
    arrays a;
    fill(&a);
    a.e[40] = DBL_MAX;
    a.c[40] = DBL_MAX;
    for (int i = 0; i < N_LAWS; i++) {
        if (laws[i].lead == 0) {
            TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_ilc_learn(&laws[i], a.u, a.e, a.c, N, a.next));
        }
    }
}

/* --- reading a store -------------------------------------------------------------------------- */

static void at_holds_the_last_sample(void)
{
    static const double u[3] = {1.0, 2.0, 3.0};
    static const struct {
        size_t n;
        int64_t k;
        double want;
    } rows[] = {{3, 0, 1.0},  {3, 2, 3.0},         {3, 3, 3.0}, {3, INT64_MAX, 3.0},
                {3, -1, 0.0}, {3, INT64_MIN, 0.0}, {0, 0, 0.0}, {1, 2, 1.0}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        TEST_ASSERT_TRUE(exk_ilc_at(u, rows[i].n, rows[i].k) == rows[i].want);
    }
    TEST_ASSERT_TRUE(exk_ilc_at(NULL, 0, 5) == 0.0);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(check_and_learn_refuse_by_the_table);
    RUN_TEST(the_default_is_the_law_of_the_study);
    RUN_TEST(learn_follows_the_law_at_every_length);
    RUN_TEST(the_stored_correction_is_never_written);
    RUN_TEST(no_samples_are_the_wrong_size);
    RUN_TEST(an_overlap_is_refused);
    RUN_TEST(a_value_that_is_not_finite_is_refused_wherever_it_is);
    RUN_TEST(infinities_that_cancel_are_refused);
    RUN_TEST(an_overflow_on_the_way_out_is_refused);
    RUN_TEST(at_holds_the_last_sample);
    return UNITY_END();
}
