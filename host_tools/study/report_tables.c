#include "report_tables.h"

#include <math.h>
#include <string.h>

#include "noise_word.h"
#include "report_figures.h"

size_t report_count(const json_t *list, const char *key, const char *role, size_t *of)
{
    size_t i = 0, n = 0;
    const json_t *item = NULL;
    *of = 0;
    json_array_foreach(list, i, item)
    {
        if (role == NULL || strcmp(report_word(item, "role"), role) == 0) {
            (*of)++;
            n += json_is_true(json_object_get(item, key));
        }
    }
    return n;
}

static void claim_row(report_page *page, const json_t *claim)
{
    const bool inside = json_is_true(json_object_get(claim, "inside"));
    report_row_head(page, report_word(claim, "id"));
    report_cell_verdict(page, inside, inside ? "inside" : "outside");
    report_cell(page, report_word(claim, "what"));
    report_cell_number(page, REPORT_DIGITS(6), report_number(claim, "published"));
    report_cell_number(page, 0, report_number(claim, "n_published"));
    report_cell_number(page, 5, report_number(claim, "mean"));
    report_cell_interval(page, 5, report_end(claim, "ci95", 0), report_end(claim, "ci95", 1));
    report_cell_interval(page, 4, report_end(claim, "prediction95", 0),
                         report_end(claim, "prediction95", 1));
    report_cell(page, report_word(claim, "role"));
    report_row_end(page);
}

static void claim_table(report_page *page, const char *key, const char *caption)
{
    static const char *const heads[] = {
        "Id",   "Verdict",  "Figure",           "Published",
        "n",    "Our mean", "95 % of our mean", "95 % of one such study",
        "Role", NULL};
    size_t i = 0;
    const json_t *claim = NULL;
    report_table(page, caption, heads);
    json_array_foreach(json_object_get(page->result, key), i, claim)
    {
        claim_row(page, claim);
    }
    report_table_end(page);
}

void report_claims(report_page *page)
{
    claim_table(page, "claims", "What the study prints, and what comes out here");
    claim_table(page, "references",
                "The two measured machines: could our model of the Exechon machine have given "
                "their figures?");
}

static void p_cell(report_page *page, double p)
{
    char text[32];
    snprintf(text, sizeof text, p < 1e-3 ? "%.1e" : "%.3f", p);
    fprintf(page->out, "<td class=\"n\">%s</td>", p < 1e-12 ? "&lt; 1e-12" : text);
}

static void word_row(report_page *page, const json_t *word)
{
    const bool holds = json_is_true(json_object_get(word, "holds"));
    report_row_head(page, report_word(word, "id"));
    report_cell_verdict(page, holds, holds ? "holds" : "does not hold");
    report_cell(page, report_word(word, "claim"));
    fprintf(page->out, "<td class=\"n\">%.3g%s</td>", report_number(word, "effect"),
            strstr(report_word(word, "effect_is"), "mm") != NULL ? " mm" : "");
    report_cell_interval(page, REPORT_DIGITS(3), report_end(word, "ci95", 0),
                         report_end(word, "ci95", 1));
    report_cell_number(page, REPORT_DIGITS(3), report_number(word, "statistic"));
    p_cell(page, report_number(word, "p_value"));
    report_row_end(page);
}

void report_words(report_page *page)
{
    static const char *const heads[] = {"Id",         "Verdict", "Claim", "Effect",
                                        "95 % of it", "z",       "p",     NULL};
    size_t i = 0;
    const json_t *word = NULL;
    report_table(
        page,
        "Claims in words, each with a one-sided test. Effect: the mean difference in mm, or a "
        "share of trials or holes",
        heads);
    json_array_foreach(json_object_get(page->result, "words"), i, word)
    {
        word_row(page, word);
    }
    report_table_end(page);
}

static const char *from_profile(const char *to)
{
    static const struct {
        const char *claim;
        study_experiment which;
    } sources[] = {{"S5", STUDY_S5}, {"S6", STUDY_S6}, {"S9_mean", STUDY_S9}};
    for (size_t i = 0; i < sizeof sources / sizeof sources[0]; i++) {
        if (strcmp(sources[i].claim, to) == 0) {
            return study_experiment_at(sources[i].which)->name;
        }
    }
    return "";
}

void report_fitted(report_page *page)
{
    static const char *const heads[] = {"Number",    "Value",       "Unit",
                                        "Fitted to", "Where it is", NULL};
    size_t i = 0;
    const json_t *fitted = NULL;
    report_table(page, "Fitted numbers; everything else is a stated choice or a prediction",
                 heads);
    json_array_foreach(json_object_get(page->result, "fitted"), i, fitted)
    {
        char file[96];
        snprintf(file, sizeof file, "profiles/study/%s.ini",
                 from_profile(report_word(fitted, "to")));
        report_row_head(page, report_word(fitted, "name"));
        report_cell_number(page, REPORT_DIGITS(4), report_number(fitted, "value"));
        report_cell(page, report_word(fitted, "unit"));
        report_cell(page, report_word(fitted, "to"));
        report_cell(page, file);
        report_row_end(page);
    }
    report_table_end(page);
}

static void controller_text(const exk_profile *profile, int n_runs, char *out, size_t size)
{
    const exk_pid_config *pid = &profile->feedback.pid;
    if (profile->feedback.kind == EXK_FEEDBACK_PID) {
        snprintf(out, size, "PI, Kp = %.4g, Ki = %.4g /s", pid->kp, pid->ki);
    } else if (n_runs > 1) {
        snprintf(out, size, "ILC, K = %.4g", profile->ilc.gain);
    } else {
        snprintf(out, size, "none");
    }
}

void report_experiments(report_page *page)
{
    static const char *const heads[] = {"Profile",  "Noise", "Controller", "Runs", "Dwell, s",
                                        "Rate, Hz", "Seed",  "Repeat",     NULL};
    char text[256];
    report_table(page, "What was run: the profiles in profiles/study, as they were read",
                 heads);
    for (int i = 0; i < STUDY_N_EXPERIMENTS; i++) {
        const exk_profile *profile = &page->paper->profiles[i];
        const study_experiment_info *info = study_experiment_at((study_experiment)i);
        report_row_head(page, info->name);
        report_noise_text(profile, text, sizeof text);
        report_cell(page, text);
        controller_text(profile, info->n_runs, text, sizeof text);
        report_cell(page, text);
        report_cell_number(page, 0, info->n_runs);
        report_cell_number(page, REPORT_DIGITS(6), profile->job.plan.dwell_s);
        report_cell_number(page, REPORT_DIGITS(6), profile->timing.rate_Hz);
        report_cell_number(page, 0, (double)profile->timing.seed);
        report_cell(page, exk_noise_word(profile));
        report_row_end(page);
    }
    report_table_end(page);
}

static void machine_row(report_page *page, const char *name, const json_t *m,
                        const char *rayleigh, const char *rician)
{
    const json_t *ray = json_object_get(m, rayleigh);
    const json_t *rice = json_object_get(m, rician);
    report_row_head(page, name);
    fprintf(page->out, "<td class=\"n\">%.0f of %.0f</td>", report_number(m, "n_inside"),
            report_number(m, "n_holes"));
    report_cell_interval(page, 3, report_end(m, "wilson95", 0), report_end(m, "wilson95", 1));
    report_cell_number(page, 4, report_number(ray, "sigma_mm"));
    report_cell_number(page, 3, report_number(ray, "inside"));
    report_cell_number(page, 2, report_number(ray, "ppk"));
    report_cell_number(page, 4, report_number(rice, "offset_mm"));
    report_cell_number(page, 4, report_number(rice, "sigma_mm"));
    report_row_end(page);
}

void report_machines(report_page *page)
{
    static const char *const heads[] = {
        "Machine",           "Inside 0.03 mm",     "95 % (Wilson)",
        "Rayleigh σ, mm",    "share inside by it", "Ppk by it",
        "Rician offset, mm", "Rician σ, mm",       NULL};
    const json_t *statistics = json_object_get(page->result, "statistics");
    const json_t *sizes = json_object_get(statistics, "sizes");
    size_t i = 0;
    const json_t *machine = NULL;
    if (!report_ran(page, STUDY_PART_S9)) {
        return;
    }
    report_table(page, "What the printed figures of the machines imply, and our 45 holes",
                 heads);
    json_array_foreach(json_object_get(statistics, "published"), i, machine)
    {
        machine_row(page, report_word(machine, "name"), machine, "rayleigh_of_mean",
                    "rician_of_mean_and_share");
    }
    machine_row(page, "ours, simulated", json_object_get(statistics, "S9_simulated"),
                "rayleigh", "rician");
    report_table_end(page);
    fprintf(
        page->out,
        "<p>The study gives no hole counts for Mazak and Loxin: 45 each is our assumption. "
        "The Rayleigh columns follow from the mean error alone, the Rician ones from mean and "
        "share. To tell 82.2&nbsp;%% from 80.0&nbsp;%% inside, about %.0f holes of each "
        "machine "
        "would be needed; to claim 99.73&nbsp;%%, %.0f holes without a miss.</p>\n",
        report_number(sizes, "holes_to_tell_822_from_800"),
        report_number(sizes, "holes_without_a_miss_for_9973"));
}
