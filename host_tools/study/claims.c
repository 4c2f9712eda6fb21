#include "claims.h"

#include <math.h>

#include "exk/units.h"

#define MM EXK_MM_PER_M
#define SHARE (1.0 / STUDY_GRID45)

/* clang-format off: one claim a line or two */
static const study_claim claims[] = {
    {"S5", "ILC, run 3, mean last-point error over 10 simulations, mm", 0.123, 0.0005, 10,
     STUDY_FITTED, STUDY_M_S5_LAST_3, STUDY_M_S5_MEAN10, MM},
    {"S6", "PI, mean last-point error over 10 simulations, mm", 0.071, 0.0005, 10, STUDY_FITTED,
     STUDY_M_S6_LAST, STUDY_M_S6_MEAN10, MM},
    {"S7_min", "25 holes, ILC run 5, zero order, smallest error without the start point, mm",
     0.01, 0.005, 24, STUDY_PREDICTED, STUDY_M_S7_MIN, STUDY_M_S7_MIN, MM},
    {"S7_max", "25 holes, ILC run 5, zero order, largest error without the start point, mm",
     0.07, 0.005, 24, STUDY_PREDICTED, STUDY_M_S7_MAX, STUDY_M_S7_MAX, MM},
    {"S8_min", "25 holes, ILC run 5, first order, smallest error without the start point, mm",
     0.02, 0.005, 24, STUDY_PREDICTED, STUDY_M_S8_MIN, STUDY_M_S8_MIN, MM},
    {"S8_max", "25 holes, ILC run 5, first order, largest error without the start point, mm",
     0.11, 0.005, 24, STUDY_PREDICTED, STUDY_M_S8_MAX, STUDY_M_S8_MAX, MM},
    {"S9_rate", "45 holes, Exechon model, share inside 0.03 mm", 0.822, 0.0005, 45,
     STUDY_PREDICTED, STUDY_M_S9_INSIDE, STUDY_M_S9_INSIDE, SHARE},
    {"S9_mean", "45 holes, Exechon model, mean error, mm", 0.023614, 0.0000005, 45,
     STUDY_FITTED, STUDY_M_S9_MEAN, STUDY_M_S9_MEAN, MM},
    {"S10_rate", "Mazak as measured, share inside 0.03 mm, against our Exechon model", 1.0,
     0.0005, 45, STUDY_REFERENCE, STUDY_M_S9_INSIDE, STUDY_M_S9_INSIDE, SHARE},
    {"S10_mean", "Mazak as measured, mean error, mm, against our Exechon model", 0.011417,
     0.0000005, 45, STUDY_REFERENCE, STUDY_M_S9_MEAN, STUDY_M_S9_MEAN, MM},
    {"S11_rate", "Loxin as measured, share inside 0.03 mm, against our Exechon model", 0.8,
     0.0005, 45, STUDY_REFERENCE, STUDY_M_S9_INSIDE, STUDY_M_S9_INSIDE, SHARE},
    {"S11_mean", "Loxin as measured, mean error, mm, against our Exechon model", 0.024466,
     0.0000005, 45, STUDY_REFERENCE, STUDY_M_S9_MEAN, STUDY_M_S9_MEAN, MM},
};
/* clang-format on */

const study_claim *study_claims(size_t *n)
{
    *n = sizeof claims / sizeof claims[0];
    return claims;
}

bool study_was_run(const study_claim *claim, const study_tally *tallies)
{
    return tallies[claim->of_mean].moments.n > 0;
}

study_verdict study_judge(const study_claim *claim, const study_tally *tallies)
{
    const study_tally *mean = &tallies[claim->of_mean];
    const study_tally *spread = &tallies[claim->of_interval];
    const double half = claim->scale * study_tally_ci95(mean);
    study_verdict v = {
        .mean = claim->scale * mean->moments.mean,
        .prediction95 = {claim->scale * study_tally_quantile(spread, 0.025),
                         claim->scale * study_tally_quantile(spread, 0.975)},
        .rounded = {claim->published - claim->half_digit, claim->published + claim->half_digit},
    };
    v.ci95 = (exk_interval){v.mean - half, v.mean + half};
    v.inside = v.rounded.high >= v.prediction95.low && v.rounded.low <= v.prediction95.high;
    return v;
}

const char *study_role_name(study_role role)
{
    static const char *const names[] = {[STUDY_FITTED] = "fitted",
                                        [STUDY_PREDICTED] = "predicted",
                                        [STUDY_REFERENCE] = "reference"};
    return names[role];
}
