/* Disturbances against their formulas. Seeds are fixed, so a run repeats; every tolerance is at
 * least four standard errors of its estimate, so that a right generator passes with any seed (odds
 * of a false alarm below 1e-4 each), and the error it would let pass is stated as the tolerance. */
#include <math.h>

#include "exk/disturbance.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* --- sums ------------------------------------------------------------------------------------- */

/* Second moments of pairs (a, b) of zero mean. */
typedef struct {
    double n, aa, ab, bb;
} pairs;

static void push(pairs *p, double a, double b)
{
    p->n += 1.0;
    p->aa += a * a;
    p->ab += a * b;
    p->bb += b * b;
}

static double correlation(const pairs *p)
{
    return p->ab / sqrt(p->aa * p->bb);
}

static exk_disturbance start(int order, double sigma, double dt_s, exk_realisation which,
                             bool frozen)
{
    exk_disturbance_config cfg = exk_disturbance_default();
    cfg.wave = EXK_WAVE_GAUSSIAN;
    cfg.order = order;
    cfg.amplitude = sigma;
    cfg.frozen = frozen;
    exk_disturbance d;
    TEST_ASSERT_EQUAL(EXK_OK, exk_disturbance_init(&d, &cfg, dt_s, which, 0));
    return d;
}

static void read_at(exk_disturbance *d, int64_t k, double n[EXK_N_AXES])
{
    n[EXK_ALPHA] = 0.0;
    n[EXK_BETA] = 0.0;
    exk_disturbance_add(d, k, n);
}

/* --- order 0: one long record ----------------------------------------------------------------- */

enum { N_WHITE = 100000 };

/* Standard errors of normal draws: mean 1/sqrt(N), variance sqrt(2/N), third moment sqrt(15/N),
 * fourth sqrt(96/N); N = 200000 with both channels: 0.0022, 0.0032, 0.0087, 0.022. */
static void white_noise_has_the_moments_of_a_normal(void)
{
    exk_disturbance d = start(0, 2.0, 1e-3, (exk_realisation){1, 0, 1}, true);
    double m[5] = {0.0};
    for (int64_t k = 0; k < N_WHITE; k++) {
        double n[EXK_N_AXES];
        read_at(&d, k, n);
        for (int i = 0; i < EXK_N_AXES; i++) {
            const double z = n[i] / 2.0;
            m[1] += z;
            m[2] += z * z;
            m[3] += z * z * z;
            m[4] += z * z * z * z;
        }
    }
    const double count = 2.0 * N_WHITE;
    TEST_ASSERT_DOUBLE_WITHIN(0.01, 0.0, m[1] / count);
    TEST_ASSERT_DOUBLE_WITHIN(0.013, 1.0, m[2] / count);
    TEST_ASSERT_DOUBLE_WITHIN(0.035, 0.0, m[3] / count);
    TEST_ASSERT_DOUBLE_WITHIN(0.09, 3.0, m[4] / count);
}

/* Pearson's chi squared over 64 cells of equal probability by the C library's erfc, 63 degrees of
 * freedom: mean 63, standard deviation 11.2; five of them, for its upper tail is long. */
static void white_noise_fills_the_cells_of_a_normal_evenly(void)
{
    enum { N_CELLS = 64 };
    double count[N_CELLS] = {0.0};
    exk_disturbance d = start(0, 1.0, 1e-3, (exk_realisation){2, 0, 1}, true);
    for (int64_t k = 0; k < N_WHITE; k++) {
        double n[EXK_N_AXES];
        read_at(&d, k, n);
        count[(int)(0.5 * erfc(-n[EXK_ALPHA] * sqrt(0.5)) * N_CELLS)] += 1.0;
    }
    const double want = (double)N_WHITE / N_CELLS;
    double chi2 = 0.0;
    for (int i = 0; i < N_CELLS; i++) {
        chi2 += (count[i] - want) * (count[i] - want) / want;
    }
    TEST_ASSERT_DOUBLE_WITHIN(56.0, 63.0, chi2);
}

/* Every pair of records that must not know each other; correlation 0 +- 0.0032. */
static void white_noise_is_independent_where_it_must_be(void)
{
    static const struct {
        const char *name;
        exk_realisation other;
        bool frozen;
        int lag, axis;
    } rows[] = {
        {"lag 1", {3, 5, 7}, false, 1, EXK_ALPHA},
        {"lag 2", {3, 5, 7}, false, 2, EXK_ALPHA},
        {"lag 32", {3, 5, 7}, false, 32, EXK_ALPHA},
        {"alpha and beta", {3, 5, 7}, false, 0, EXK_BETA},
        {"alpha and the beta after it", {3, 5, 7}, false, 1, EXK_BETA},
        {"next series", {3, 6, 7}, false, 0, EXK_ALPHA},
        {"next run", {3, 5, 8}, false, 0, EXK_ALPHA},
        {"next seed", {4, 5, 7}, false, 0, EXK_ALPHA},
        {"frozen and fresh", {3, 5, 7}, true, 0, EXK_ALPHA},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        exk_disturbance a = start(0, 1.0, 1e-3, (exk_realisation){3, 5, 7}, false);
        exk_disturbance b = start(0, 1.0, 1e-3, rows[i].other, rows[i].frozen);
        pairs p = {0.0, 0.0, 0.0, 0.0};
        for (int64_t k = 0; k < N_WHITE; k++) {
            double na[EXK_N_AXES];
            double nb[EXK_N_AXES];
            read_at(&a, k, na);
            read_at(&b, k + rows[i].lag, nb);
            push(&p, na[EXK_ALPHA], nb[rows[i].axis]);
        }
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(0.013, 0.0, correlation(&p), rows[i].name);
    }
}

/* --- orders 1 and 2: many series, at one time ------------------------------------------------- */

/* Moments of (n, rate) at time t over N_SERIES series and both channels: 40000 pairs, standard
 * error of a variance 0.7 %; of a covariance with correlation r sqrt((1 + r^2)/N), 0.76 % of it. */
enum { N_SERIES = 20000 };

static pairs moments_at(int order, double sigma, double dt_s, int64_t k, uint64_t seed)
{
    pairs p = {0.0, 0.0, 0.0, 0.0};
    for (uint32_t series = 0; series < N_SERIES; series++) {
        exk_disturbance d = start(order, sigma, dt_s, (exk_realisation){seed, series, 1}, true);
        double n[EXK_N_AXES];
        read_at(&d, k, n);
        for (int i = 0; i < EXK_N_AXES; i++) {
            push(&p, n[i], d.rate_radps[i]);
        }
    }
    return p;
}

/* The same time by steps of any length; one step alone is in the table too. */
static const struct {
    const char *name;
    double dt_s;
    int64_t k;
} grids[] = {
    {"one step", 0.4, 1},
    {"ten steps", 0.04, 10},
    {"thirty-two steps", 0.0125, 32},
};
enum { N_GRIDS = sizeof grids / sizeof *grids };

static void check_ratio(double tolerance, double want, double got, const char *name)
{
    TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(tolerance, 1.0, got / want, name);
}

/* Var n = s^2 t whatever dt. */
static void a_walk_spreads_with_time_and_not_with_dt(void)
{
    const double s = 0.3;
    for (int i = 0; i < N_GRIDS; i++) {
        const double t = grids[i].dt_s * (double)grids[i].k;
        const pairs p = moments_at(1, s, grids[i].dt_s, grids[i].k, 20 + (uint64_t)i);
        check_ratio(0.03, s * s * t, p.aa / p.n, grids[i].name);
    }
}

/* Var n = s^2 t^3/3, cov(n, rate) = s^2 t^2/2, var rate = s^2 t whatever dt. */
static void a_double_walk_has_its_joint_covariance_for_every_dt(void)
{
    const double s = 0.3;
    for (int i = 0; i < N_GRIDS; i++) {
        const double t = grids[i].dt_s * (double)grids[i].k;
        const pairs p = moments_at(2, s, grids[i].dt_s, grids[i].k, 30 + (uint64_t)i);
        check_ratio(0.03, s * s * t * t * t / 3.0, p.aa / p.n, grids[i].name);
        check_ratio(0.035, s * s * t * t / 2.0, p.ab / p.n, grids[i].name);
        check_ratio(0.03, s * s * t, p.bb / p.n, grids[i].name);
    }
}

/* Cov(n(t1), n(t2)) = s^2 t1 for t1 < t2: increments are independent. With t2 = 4 t1 the
 * correlation is 1/2, standard error 0.75/sqrt(40000) = 0.004. */
static void increments_of_a_walk_are_independent(void)
{
    pairs p = {0.0, 0.0, 0.0, 0.0};
    for (uint32_t series = 0; series < N_SERIES; series++) {
        exk_disturbance d = start(1, 1.0, 0.1, (exk_realisation){40, series, 1}, true);
        double early[EXK_N_AXES];
        double late[EXK_N_AXES];
        read_at(&d, 5, early);
        read_at(&d, 20, late);
        push(&p, early[EXK_ALPHA], late[EXK_ALPHA]);
        push(&p, early[EXK_BETA], late[EXK_BETA]);
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.016, 0.5, correlation(&p));
}

static double correlation_of_runs(int order, bool frozen)
{
    pairs p = {0.0, 0.0, 0.0, 0.0};
    for (uint32_t series = 0; series < N_SERIES; series++) {
        exk_disturbance a = start(order, 1.0, 0.1, (exk_realisation){50, series, 1}, frozen);
        exk_disturbance b = start(order, 1.0, 0.1, (exk_realisation){50, series, 2}, frozen);
        double na[EXK_N_AXES];
        double nb[EXK_N_AXES];
        read_at(&a, 3, na);
        read_at(&b, 3, nb);
        push(&p, na[EXK_ALPHA], nb[EXK_ALPHA]);
        push(&p, na[EXK_BETA], nb[EXK_BETA]);
    }
    return correlation(&p);
}

/* Runs 1 and 2 of the same series: the same when frozen, strangers (0 +- 0.005) when fresh. */
static void frozen_runs_are_one_and_fresh_runs_are_strangers(void)
{
    for (int order = 0; order <= 2; order++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1.0, correlation_of_runs(order, true));
        TEST_ASSERT_DOUBLE_WITHIN(0.02, 0.0, correlation_of_runs(order, false));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(white_noise_has_the_moments_of_a_normal);
    RUN_TEST(white_noise_fills_the_cells_of_a_normal_evenly);
    RUN_TEST(white_noise_is_independent_where_it_must_be);
    RUN_TEST(a_walk_spreads_with_time_and_not_with_dt);
    RUN_TEST(a_double_walk_has_its_joint_covariance_for_every_dt);
    RUN_TEST(increments_of_a_walk_are_independent);
    RUN_TEST(frozen_runs_are_one_and_fresh_runs_are_strangers);
    return UNITY_END();
}
