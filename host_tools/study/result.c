#include "result.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "exk/units.h"
#include "json_file.h"
#include "out_file.h"

#define TOLERANCE_M 0.03e-3

enum { WHY_SIZE = 512 };

static const char csv_header[] =
    "measure,n,mean,standard_deviation,ci95_low,ci95_high,q025,q500,q975,min,max\n";

void study_fitted_of(const exk_profile *profiles, study_fitted fitted[STUDY_N_FITTED])
{
    fitted[0] = (study_fitted){"first-order intensity", "rad/s^0.5", "S5",
                               profiles[STUDY_S5].twin.disturbance[0].amplitude};
    fitted[1] =
        (study_fitted){"integral gain", "1/s", "S6", profiles[STUDY_S6].feedback.pid.ki};
    fitted[2] = (study_fitted){"zero-order sigma", "rad", "S9_mean",
                               profiles[STUDY_S9].twin.disturbance[0].amplitude};
}

static json_t *fitted_json(const exk_profile *profiles)
{
    study_fitted fitted[STUDY_N_FITTED];
    json_t *list = json_array();
    study_fitted_of(profiles, fitted);
    for (int i = 0; i < STUDY_N_FITTED; i++) {
        json_array_append_new(list, json_pack("{s:s, s:f, s:s, s:s}", "name", fitted[i].name,
                                              "value", fitted[i].value, "unit", fitted[i].unit,
                                              "to", fitted[i].to));
    }
    return list;
}

static json_t *interval_json(exk_interval interval)
{
    return json_pack("[o, o]", exk_json_real(interval.low), exk_json_real(interval.high));
}

static json_t *claim_json(const study_claim *claim, const study_tally *tallies)
{
    const study_verdict v = study_judge(claim, tallies);
    return json_pack("{s:s, s:s, s:f, s:i, s:o, s:o, s:o, s:o, s:b, s:s}", "id", claim->id,
                     "what", claim->what, "published", claim->published, "n_published",
                     claim->n_published, "mean", exk_json_real(v.mean), "ci95",
                     interval_json(v.ci95), "prediction95", interval_json(v.prediction95),
                     "published_rounding", interval_json(v.rounded), "inside", v.inside ? 1 : 0,
                     "role", study_role_name(claim->role));
}

/* The claims proper, or S10 and S11. */
static json_t *claims_json(const study_tally *tallies, bool references)
{
    size_t n = 0;
    const study_claim *claims = study_claims(&n);
    json_t *list = json_array();
    for (size_t i = 0; i < n; i++) {
        if ((claims[i].role == STUDY_REFERENCE) == references &&
            study_was_run(&claims[i], tallies)) {
            json_array_append_new(list, claim_json(&claims[i], tallies));
        }
    }
    return list;
}

static json_t *words_json(const study_tally *tallies)
{
    study_word words[STUDY_WORDS_MAX];
    const size_t n = study_words(tallies, words);
    json_t *list = json_array();
    for (size_t i = 0; i < n; i++) {
        json_array_append_new(
            list,
            json_pack("{s:s, s:s, s:o, s:o, s:b, s:o, s:o, s:s}", "id", words[i].id, "claim",
                      words[i].claim, "statistic", exk_json_real(words[i].statistic), "p_value",
                      exk_json_real(words[i].p_value), "holds", words[i].holds ? 1 : 0,
                      "effect", exk_json_real(words[i].effect), "ci95",
                      interval_json(words[i].ci95), "effect_is", words[i].effect_is));
    }
    return list;
}

static json_t *summary_json(const study_tally *tally, double scale)
{
    const double half = study_tally_ci95(tally);
    const double mean = tally->moments.n > 0 ? tally->moments.mean : (double)NAN;
    return json_pack("{s:o, s:[o,o], s:[o,o]}", "mean", exk_json_real(scale * mean), "ci95",
                     exk_json_real(scale * (mean - half)), exk_json_real(scale * (mean + half)),
                     "spread95", exk_json_real(scale * study_tally_quantile(tally, 0.025)),
                     exk_json_real(scale * study_tally_quantile(tally, 0.975)));
}

static json_t *curve_json(const study_tally *tallies, int first, int n)
{
    json_t *list = json_array();
    for (int i = 0; i < n; i++) {
        json_array_append_new(list, summary_json(&tallies[first + i], EXK_MM_PER_M));
    }
    return list;
}

static json_t *curves_json(const study_tally *tallies)
{
    return json_pack("{s:o, s:o, s:o, s:o, s:o}", "S1_rms_mm_none_alpha_beta_both",
                     curve_json(tallies, STUDY_M_S1_NONE_RMS, 4), "S4_rms_mm_by_run",
                     curve_json(tallies, STUDY_M_S4_RMS_1, 3), "S5_last_mm_by_run",
                     curve_json(tallies, STUDY_M_S5_LAST_1, 3), "S7_mm_by_hole",
                     curve_json(tallies, STUDY_M_S7_HOLES, STUDY_GRID25), "S8_mm_by_hole",
                     curve_json(tallies, STUDY_M_S8_HOLES, STUDY_GRID25));
}

static json_t *rician_json(exk_rician r)
{
    return json_pack("{s:o, s:o, s:o}", "offset_mm", exk_json_real(r.offset * EXK_MM_PER_M),
                     "sigma_mm", exk_json_real(r.sigma * EXK_MM_PER_M), "inside",
                     exk_json_real(exk_rician_inside(TOLERANCE_M, r)));
}

static json_t *rayleigh_json(double sigma_m)
{
    return json_pack("{s:o, s:o, s:o}", "sigma_mm", exk_json_real(sigma_m * EXK_MM_PER_M),
                     "inside", exk_json_real(exk_rayleigh_inside(TOLERANCE_M, sigma_m)), "ppk",
                     exk_json_real(exk_rayleigh_ppk(TOLERANCE_M, sigma_m)));
}

/* Ppk of the holes as they fell, by quantiles. */
static double measured_ppk(const study_tally *hole)
{
    const double median = study_tally_quantile(hole, 0.5);
    return (TOLERANCE_M - median) / (study_tally_quantile(hole, 0.99865) - median);
}

static json_t *model_json(const study_tally *tallies)
{
    const study_tally *hole = &tallies[STUDY_M_S9_HOLE];
    const exk_moments *square = &tallies[STUDY_M_S9_HOLE2].moments;
    const uint64_t n_holes = hole->moments.n;
    const double inside =
        tallies[STUDY_M_S9_INSIDE].moments.mean * (double)tallies[STUDY_M_S9_INSIDE].moments.n;
    return json_pack("{s:I, s:I, s:o, s:o, s:o, s:o}", "n_holes", (json_int_t)n_holes,
                     "n_inside", (json_int_t)llround(inside), "wilson95",
                     interval_json(exk_wilson((uint64_t)llround(inside), n_holes, 0.95)),
                     "rayleigh", rayleigh_json(sqrt(0.5 * square->mean)), "rician",
                     rician_json(exk_rician_fit(square->mean, exk_moments_variance(square))),
                     "ppk", exk_json_real(measured_ppk(hole)));
}

/* S9 to S11 as printed; the counts of the two machines are assumed. */
static json_t *published_json(const char *name, double mean_m, uint64_t k, uint64_t n)
{
    const double share = k < n ? (double)k / (double)n : (double)NAN; /* all: no one fit */
    return json_pack(
        "{s:s, s:I, s:I, s:o, s:o, s:o}", "name", name, "n_inside", (json_int_t)k, "n_holes",
        (json_int_t)n, "wilson95", interval_json(exk_wilson(k, n, 0.95)), "rayleigh_of_mean",
        rayleigh_json(exk_rayleigh_sigma_of_mean(mean_m)), "rician_of_mean_and_share",
        rician_json(exk_rician_of_mean_and_inside(mean_m, TOLERANCE_M, share)));
}

json_t *study_statistics(const study_tally *tallies)
{
    json_t *published = json_array();
    json_array_append_new(published, published_json("Exechon model", 0.023614e-3, 37, 45));
    json_array_append_new(published, published_json("Mazak", 0.011417e-3, 45, 45));
    json_array_append_new(published, published_json("Loxin", 0.024466e-3, 36, 45));
    return json_pack(
        "{s:o, s:o, s:{s:I, s:I, s:I}}", "S9_simulated", model_json(tallies), "published",
        published, "sizes", "holes_to_tell_822_from_800",
        (json_int_t)exk_two_proportions_size(0.822, 0.800, 0.95, 0.80),
        "holes_without_a_miss_for_9973", (json_int_t)exk_no_miss_size(0.9973, 0.95),
        "holes_without_a_miss_for_9999", (json_int_t)exk_no_miss_size(0.9999, 0.95));
}

json_t *study_result(const study_paper *paper, const study_sums *totals, uint64_t n_trials)
{
    const study_tally *tallies = totals->tallies;
    return json_pack("{s:o, s:o, s:o, s:o, s:o, s:o, s:b, s:s, s:I}", "fitted",
                     fitted_json(paper->profiles), "claims", claims_json(tallies, false),
                     "references", claims_json(tallies, true), "words", words_json(tallies),
                     "curves", curves_json(tallies), "statistics", study_statistics(tallies),
                     "frozen", strcmp(paper->noise, "frozen") == 0, "noise", paper->noise,
                     "seeds", (json_int_t)n_trials);
}

static int say(int code, const char *why)
{
    if (code != STUDY_GOOD) {
        fprintf(stderr, "exk-study: %s\n", why);
    }
    return code;
}

int study_write_json(const json_t *root, const char *path)
{
    char why[WHY_SIZE];
    const char *first = json_object_iter_key(json_object_iter((json_t *)(uintptr_t)root));
    return say(exk_json_write(root, path, first, why, sizeof why), why);
}

static void csv_row(FILE *file, const study_measure *measure, const study_tally *tally)
{
    const double half = study_tally_ci95(tally);
    const double mean = tally->moments.mean;
    fprintf(file, "%s%s%s,%llu,%.9g,%.9g,%.9g,%.9g", measure->key,
            measure->unit[0] == '\0' ? "" : "_", measure->unit,
            (unsigned long long)tally->moments.n, mean, exk_moments_std(&tally->moments),
            mean - half, mean + half);
    if (tally->n_bins > 0) {
        fprintf(file, ",%.9g,%.9g,%.9g", study_tally_quantile(tally, 0.025),
                study_tally_quantile(tally, 0.5), study_tally_quantile(tally, 0.975));
    } else {
        fputs(",,,", file);
    }
    fprintf(file, ",%.9g,%.9g\n", tally->min, tally->max);
}

int study_write_csv(const study_sums *totals, const study_measure *measures, const char *path)
{
    char why[WHY_SIZE];
    exk_out out;
    int code = exk_out_open(&out, path, EXK_OUT_TEXT, csv_header, why, sizeof why);
    if (code != STUDY_GOOD) {
        return say(code, why);
    }
    fputs(csv_header, out.file);
    for (size_t i = 0; i < totals->n; i++) {
        if (totals->tallies[i].moments.n > 0) {
            csv_row(out.file, &measures[i], &totals->tallies[i]);
        }
    }
    return say(exk_out_commit(&out, why, sizeof why), why);
}

static void print_claims(const study_tally *tallies)
{
    size_t n = 0;
    const study_claim *claims = study_claims(&n);
    printf("%-9s %10s %10s %23s %21s  %-9s %s\n", "figure", "published", "ours", "95 % of ours",
           "95 % of one study", "role", "verdict");
    for (size_t i = 0; i < n; i++) {
        if (!study_was_run(&claims[i], tallies)) {
            continue;
        }
        const study_verdict v = study_judge(&claims[i], tallies);
        printf("%-9s %10.6g %10.5f %11.5f to %8.5f %9.4f to %8.4f  %-9s %s\n", claims[i].id,
               claims[i].published, v.mean, v.ci95.low, v.ci95.high, v.prediction95.low,
               v.prediction95.high, study_role_name(claims[i].role),
               v.inside ? "inside" : "OUTSIDE");
    }
}

static void print_words(const study_tally *tallies)
{
    study_word words[STUDY_WORDS_MAX];
    const size_t n = study_words(tallies, words);
    printf("\n%-14s %10s %9s  %-13s %s\n", "claim", "statistic", "p", "verdict", "in words");
    for (size_t i = 0; i < n; i++) {
        printf("%-14s %10.4g %9.2g  %-13s %s\n", words[i].id, words[i].statistic,
               words[i].p_value, words[i].holds ? "holds" : "DOES NOT HOLD", words[i].claim);
    }
}

int study_print(const study_sums *totals, uint64_t n_trials, const char *noise)
{
    printf("The study over %llu seeds, %s noise; lengths in mm\n\n",
           (unsigned long long)n_trials, noise);
    print_claims(totals->tallies);
    print_words(totals->tallies);
    return exk_stdout_flush("exk-study");
}
