#include <stdio.h>
#include <stdlib.h>

#include "mpi_ranks.h"
#include "report.h"
#include "result.h"
#include "study_tool.h"

enum { SEEDS = 2000, KEEP_MAX = 4096 };

study_work study_work_of(const study_options *options, uint64_t n_seeds)
{
    return (study_work){.n_trials = n_seeds,
                        .n_threads = study_mpi_size() > 1 ? 1 : options->n_threads,
                        .folder = options->resume};
}

static int report(const study_options *options, const study_paper *paper,
                  const study_sums *totals, const json_t *result)
{
    study_also also;
    const study_work work = {.n_trials = STUDY_ALSO_SEEDS, .n_threads = options->n_threads};
    int code = study_also_open(&also, options->with_compare, options->with_sensitivity);
    if (code == STUDY_GOOD) {
        code = study_also_run(&also, options->profiles, &work);
    }
    if (code == STUDY_GOOD) {
        code = study_report(paper, totals, result, &also, options->report);
    }
    study_also_close(&also);
    return code;
}

/* Before hours of work rather than after them. */
static int check_also(const study_options *options)
{
    study_also also;
    const int code = study_also_open(&also, options->with_compare, options->with_sensitivity);
    study_also_close(&also);
    return code;
}

/* Everything that was asked for; the table when nothing was. */
static int show(const study_options *options, const study_paper *paper,
                const study_sums *totals, uint64_t n_trials)
{
    int code = STUDY_GOOD;
    json_t *result = study_result(paper, totals, n_trials);
    if (options->json != NULL) {
        code = study_write_json(result, options->json);
    }
    if (options->csv != NULL && code == STUDY_GOOD) {
        code = study_write_csv(totals, paper->measures, options->csv);
    }
    if (options->report != NULL && code == STUDY_GOOD) {
        code = report(options, paper, totals, result);
    }
    if (code == STUDY_GOOD && (options->json == NULL || options->json[0] != '-')) {
        code = study_print(totals, n_trials, paper->noise);
    }
    json_decref(result);
    return code;
}

static int run_and_show(const study_options *options, study_paper *paper)
{
    char keep[KEEP_MAX];
    char next[KEEP_MAX];
    study_sums totals;
    const uint64_t n = options->n_seeds > 0 ? options->n_seeds : SEEDS;
    study_work work = study_work_of(options, n);
    snprintf(keep, sizeof keep, "%s.parts",
             options->json != NULL && options->json[0] != '-' ? options->json : "exk-study");
    snprintf(next, sizeof next, "exk-study paper --seeds %llu%s%s", (unsigned long long)n,
             options->only != NULL ? " --only " : "",
             options->only != NULL ? options->only : "");
    work.keep = study_mpi_size() > 1 ? NULL : keep;
    work.how_next = next;
    int code = study_sums_open(&totals, paper->measures, STUDY_N_PAPER);
    if (code == STUDY_GOOD) {
        code = study_run(&paper->task, &work, &totals);
    }
    if (code == STUDY_GOOD) {
        code = show(options, paper, &totals, n);
    }
    study_sums_close(&totals);
    return code;
}

static int merge_and_show(const study_options *options, study_paper *paper)
{
    study_sums totals;
    uint64_t n_trials = 0;
    int code = study_sums_open(&totals, paper->measures, STUDY_N_PAPER);
    if (code == STUDY_GOOD) {
        code = study_merge_parts(&paper->task, options->parts, options->n_parts, &totals,
                                 &n_trials);
    }
    if (code == STUDY_GOOD) {
        code = show(options, paper, &totals, n_trials);
    }
    study_sums_close(&totals);
    return code;
}

static int run_block(const study_options *options, study_paper *paper)
{
    const study_work work = study_work_of(options, options->to);
    return study_run_part(&paper->task, &work, options->from, options->to, options->output);
}

int study_with_paper(const study_options *options, uint32_t parts,
                     int (*act)(const study_options *options, study_paper *paper))
{
    study_paper *paper = calloc(1, sizeof *paper);
    if (paper == NULL) {
        fprintf(stderr, "exk-study: out of memory\n");
        return STUDY_IO;
    }
    int code = study_paper_init(paper, options->profiles, parts);
    if (code == STUDY_GOOD) {
        paper->by_steps = options->by_steps;
        code = act(options, paper);
    }
    free(paper);
    return code;
}

static int act_on_parts(const study_options *options,
                        int (*act)(const study_options *options, study_paper *paper))
{
    const int code = check_also(options);
    return code != STUDY_GOOD ? code : study_with_paper(options, options->parts_run, act);
}

int study_do_paper(const study_options *options)
{
    return act_on_parts(options, run_and_show);
}

int study_do_merge(const study_options *options)
{
    return act_on_parts(options, merge_and_show);
}

int study_do_block(const study_options *options)
{
    return act_on_parts(options, run_block);
}
