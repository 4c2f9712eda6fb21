/* How the verdicts depend on what the study does not give: each row is another set of choices, fitted
 * again to S5 and S9_mean in the same way (S6 by its integral gain, which no other figure sees), with
 * the eight verdicts. */
#include <math.h>
#include <stdio.h>

#include "exk/units.h"
#include "fit.h"
#include "json_file.h"
#include "out_file.h"
#include "result.h"
#include "study_tool.h"

enum { SEEDS = 500, NAME_SIZE = 96 };

/* Zero order needs fewer trials for its fit: each has 45 holes. */
static const uint64_t white_share = 5;

typedef struct {
    double ilc_gain;
    double dwell_s;
    double feed_mps;
    bool universal;
    bool s9_walk;
} choice;

static const choice choices[] = {
    {0.40, 0.5, 0.1, false, false},  {0.40, 1.0, 0.1, false, false},
    {0.40, 2.0, 0.1, false, false},  {0.45, 0.5, 0.1, false, false},
    {0.45, 1.0, 0.1, false, false},  {0.45, 2.0, 0.1, false, false},
    {0.50, 0.5, 0.1, false, false},  {0.50, 1.0, 0.1, false, false},
    {0.50, 2.0, 0.1, false, false},  {0.55, 0.5, 0.1, false, false},
    {0.55, 1.0, 0.1, false, false},  {0.55, 2.0, 0.1, false, false},
    {0.50, 2.0, 0.05, false, false}, {0.50, 2.0, 0.2, false, false},
    {0.50, 2.0, 0.1, true, false},   {0.45, 2.0, 0.1, true, false},
    {0.50, 2.0, 0.1, false, true},   {0.45, 2.0, 0.1, false, true},
};

static void name_of(const choice *c, char name[NAME_SIZE])
{
    snprintf(name, NAME_SIZE, "K %.2f, dwell %.1f s, feed %3.0f mm/s, %c, S9 order %c",
             c->ilc_gain, c->dwell_s, EXK_MM_PER_M * c->feed_mps, c->universal ? 'U' : 'P',
             c->s9_walk ? '1' : '0');
}

/* With S9 of first order the zero-order noise is seen in S7 alone: its sigma is then fitted to
 * S7_max, and S9_mean is a prediction. */
static int fit(study_paper *paper, const study_work *work, const choice *c)
{
    const study_fit walk = {STUDY_PART_S5, STUDY_M_S5_LAST_3, 0.123e-3,
                            paper->profiles[STUDY_S5].twin.disturbance[0].amplitude,
                            &paper->variant.walk_sigma};
    const study_fit white = {
        c->s9_walk ? STUDY_PART_S7 : STUDY_PART_S9,
        c->s9_walk ? STUDY_M_S7_MAX : STUDY_M_S9_MEAN, c->s9_walk ? 0.07e-3 : 0.023614e-3,
        paper->profiles[STUDY_S9].twin.disturbance[0].amplitude, &paper->variant.white_sigma};
    study_work fewer = *work;
    double mean_m = 0.0;
    fewer.n_trials = work->n_trials / white_share / STUDY_GROUP * STUDY_GROUP;
    fewer.n_trials = fewer.n_trials < STUDY_GROUP ? STUDY_GROUP : fewer.n_trials;
    paper->variant = study_as_published();
    paper->variant.ilc_gain = c->ilc_gain;
    paper->variant.dwell_s = c->dwell_s;
    paper->variant.feed_mps = c->feed_mps;
    paper->variant.universal = c->universal;
    int code = study_fit_scale(paper, work, &walk, &mean_m);
    if (code == STUDY_GOOD) {
        code = study_fit_scale(paper, &fewer, &white, &mean_m);
    }
    paper->variant.s9_walk = c->s9_walk;
    return code;
}

static json_t *verdicts_json(const study_tally *tallies, int *n_inside, int *n_judged)
{
    size_t n = 0;
    const study_claim *claims = study_claims(&n);
    json_t *list = json_object();
    *n_inside = 0;
    *n_judged = 0;
    for (size_t i = 0; i < n; i++) {
        if (claims[i].role != STUDY_REFERENCE && study_was_run(&claims[i], tallies)) {
            const study_verdict v = study_judge(&claims[i], tallies);
            json_object_set_new(list, claims[i].id,
                                json_pack("{s:[f,f], s:b}", "prediction95", v.prediction95.low,
                                          v.prediction95.high, "inside", v.inside ? 1 : 0));
            *n_inside += v.inside;
            (*n_judged)++;
        }
    }
    return list;
}

static void print_row(const char *name, const study_paper *paper, const study_tally *tallies,
                      int n_inside, int n_judged)
{
    static const char *const ids[] = {"S7_min", "S7_max",  "S8_min",
                                      "S8_max", "S9_rate", "S9_mean"};
    size_t n = 0;
    const study_claim *claims = study_claims(&n);
    printf("%-50s %9.3g %9.3g", name, paper->variant.walk_sigma, paper->variant.white_sigma);
    for (size_t j = 0; j < sizeof ids / sizeof ids[0]; j++) {
        for (size_t i = 0; i < n; i++) {
            if (claims[i].id[1] == ids[j][1] && claims[i].id[3] == ids[j][3] &&
                claims[i].id[4] == ids[j][4]) {
                const study_verdict v = study_judge(&claims[i], tallies);
                printf(" %.4f-%.4f%c", v.prediction95.low, v.prediction95.high,
                       v.inside ? ' ' : '!');
            }
        }
    }
    printf("  %d of %d\n", n_inside + 1, n_judged + 1);
    fflush(stdout);
}

static int run_row(study_paper *paper, const study_work *work, const choice *c, json_t *list,
                   bool table)
{
    char name[NAME_SIZE];
    int n_inside = 0, n_judged = 0;
    study_sums totals;
    name_of(c, name);
    int code = fit(paper, work, c);
    code = code != STUDY_GOOD ? code : study_sums_open(&totals, paper->measures, STUDY_N_PAPER);
    if (code != STUDY_GOOD) {
        return code;
    }
    paper->parts =
        1U << STUDY_PART_S5 | 1U << STUDY_PART_S7 | 1U << STUDY_PART_S8 | 1U << STUDY_PART_S9;
    code = study_run(&paper->task, work, &totals);
    if (code == STUDY_GOOD) {
        json_t *verdicts = verdicts_json(totals.tallies, &n_inside, &n_judged);
        json_array_append_new(
            list,
            json_pack("{s:s, s:f, s:f, s:f, s:s, s:i, s:f, s:f, s:i, s:o}", "choice", name,
                      "ilc_gain", c->ilc_gain, "dwell_s", c->dwell_s, "feed_mmps",
                      EXK_MM_PER_M * c->feed_mps, "model", c->universal ? "U" : "P", "s9_order",
                      c->s9_walk ? 1 : 0, "first_order_intensity", paper->variant.walk_sigma,
                      "zero_order_sigma", paper->variant.white_sigma, "n_inside_of_8",
                      n_inside + 1, "verdicts", verdicts));
        if (table) {
            print_row(name, paper, totals.tallies, n_inside, n_judged);
        }
    }
    study_sums_close(&totals);
    return code;
}

static int run_rows(const study_options *options, study_paper *paper)
{
    const uint64_t n = options->n_seeds > 0 ? options->n_seeds : SEEDS;
    const study_work work = {.n_trials = n, .n_threads = options->n_threads};
    const bool table = options->json == NULL || options->json[0] != '-';
    json_t *list = json_array();
    int code = STUDY_GOOD;
    if (table) {
        printf(
            "95 %% of one study over %llu seeds, mm; ! published figure outside; S6 is fitted "
            "in every row\n%-50s %9s %9s %-14s %-14s %-14s %-14s %-14s %-14s\n",
            (unsigned long long)n, "choices", "order 1", "order 0", " S7_min", " S7_max",
            " S8_min", " S8_max", " S9_rate", " S9_mean");
    }
    for (size_t i = 0; i < sizeof choices / sizeof choices[0] && code == STUDY_GOOD; i++) {
        code = run_row(paper, &work, &choices[i], list, table);
    }
    json_t *root = json_pack("{s:o, s:s, s:I}", "sensitivity", list, "noise", paper->noise,
                             "seeds", (json_int_t)n);
    if (code == STUDY_GOOD && options->json != NULL) {
        code = study_write_json(root, options->json);
    }
    json_decref(root);
    return code != STUDY_GOOD ? code : exk_stdout_flush("exk-study");
}

int study_do_sensitivity(const study_options *options)
{
    return study_with_paper(options, STUDY_ALL_PARTS, run_rows);
}
