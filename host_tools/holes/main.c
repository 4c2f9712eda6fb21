/** exk-holes: hole accuracy of a run, from a log or live. See options.c for its use. */
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "bus_url.h"
#include "exk/log.h"
#include "exk/plural.h"
#include "exk/standard_streams.h"
#include "files.h"
#include "gnuplot.h"
#include "live.h"
#include "options.h"
#include "picture.h"
#include "report.h"
#include "table.h"
#include "terminal.h"

enum { WHY_MAX = 1024 };

static int complain(int code, const char *why)
{
    fprintf(stderr, "exk-holes: %s\n", why);
    return code;
}

static int read_log(exk_run_log *log, const char *path)
{
    char why[WHY_MAX] = "";
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        snprintf(why, sizeof why, "%s: cannot be opened: %s", path, strerror(errno));
        return complain(3, why);
    }
    fclose(file);
    return exk_run_log_read(log, path, why, sizeof why) ? 0 : complain(2, why);
}

static int listen(exk_run_log *log, const holes_options *opt)
{
    char why[WHY_MAX] = "";
    char url[EXK_PATH_MAX];
    exk_bus_url(opt->url, url, sizeof url);
    const int code = hole_live_listen(log, url, opt->seconds, opt->quiet, why, sizeof why);
    return code == 0 ? 0 : complain(code, why);
}

static void note_file(const exk_run_log *log)
{
    if (log->truncated) {
        fprintf(stderr, "exk-holes: the log ends inside a record: %zu whole sample%s judged\n",
                log->n_samples, exk_plural_s((int64_t)log->n_samples));
    }
    if (log->n_before > 0) {
        fprintf(stderr,
                "exk-holes: %" PRId64 " sample%s before the first one here counted as lost\n",
                log->n_before, exk_plural_s(log->n_before));
    }
    if (log->n_damaged > 0) {
        fprintf(stderr, "exk-holes: %" PRId64 " damaged place%s of the file skipped\n",
                log->n_damaged, exk_plural_s(log->n_damaged));
    }
    if (log->n_other_run > 0) {
        fprintf(stderr,
                "exk-holes: %" PRId64
                " message%s of other runs left out: only the first run of a log is judged\n",
                log->n_other_run, exk_plural_s(log->n_other_run));
    }
}

static void note_run(const exk_run_log *log)
{
    if (log->has_status && log->status.state == EXK_STATE_FAULT) {
        fprintf(stderr, "exk-holes: the run ended by a fault: %s\n", log->status.reason);
    }
    if (!log->ended) {
        fprintf(stderr,
                "exk-holes: the log ends before the run was done (tick %" PRId64 " of %" PRId64
                ")\n",
                log->samples[log->n_samples - 1].k + 1, log->n_ticks);
    }
    if (log->n_repeated > 0) {
        fprintf(stderr, "exk-holes: %" PRId64 " repeated sample%s left out\n", log->n_repeated,
                exk_plural_s(log->n_repeated));
    }
    if (log->n_undecoded > 0) {
        fprintf(stderr, "exk-holes: %" PRId64 " message%s on our channels did not decode\n",
                log->n_undecoded, exk_plural_s(log->n_undecoded));
    }
}

static void note_report(const hole_report *report)
{
    if (report->n_early > 0) {
        fprintf(
            stderr,
            "exk-holes: %zu of %zu holes judged on an earlier sample of the dwell: the last "
            "one before the stroke is not in the log\n",
            report->n_early, report->accuracy.n_drilled);
    }
    if (!report->has_profile) {
        fputs(
            "exk-holes: the profile in the log is not valid here, so frozen or fresh noise is "
            "unknown\n",
            stderr);
    }
}

static int worse(int a, int b)
{
    return a > b ? a : b;
}

static int write_plots(const hole_report *report, const holes_options *opt)
{
    char why[WHY_MAX];
    int code = 0;
    for (size_t i = 0; i < opt->plots.n; i++) {
        const int one = hole_picture_write(report, opt->plots.path[i], why, sizeof why);
        code = worse(code, one == 0 ? 0 : complain(one, why));
    }
    return code;
}

static int write_files(const hole_report *report, const holes_options *opt)
{
    char why[WHY_MAX];
    int code = 0;
    if (opt->json_path != NULL) {
        const int one = hole_json_write(report, opt->json_path, why, sizeof why);
        code = worse(code, one == 0 ? 0 : complain(one, why));
    }
    if (opt->csv_path != NULL) {
        const int one = hole_csv_write(report, opt->csv_path, why, sizeof why);
        code = worse(code, one == 0 ? 0 : complain(one, why));
    }
    return worse(code, write_plots(report, opt));
}

static bool takes_stdout(const char *path)
{
    return path != NULL && strcmp(path, "-") == 0;
}

static int write_results(const hole_report *report, const holes_options *opt)
{
    if (!takes_stdout(opt->json_path) && !takes_stdout(opt->csv_path)) {
        hole_table_print(report, stdout, exk_has_colour(stdout));
    }
    const int code = write_files(report, opt);
    return worse(code, exk_stdout_flush("exk-holes"));
}

static int judge(const exk_run_log *log, const holes_options *opt)
{
    char why[WHY_MAX];
    hole_report report;
    const char *source = opt->live ? "the bus" : opt->log_path;
    const int refused =
        hole_report_make(&report, log, source, opt->tolerance_m, why, sizeof why);
    if (refused != 0) {
        return complain(refused, why);
    }
    if (!opt->quiet) {
        note_file(log);
        note_run(log);
        note_report(&report);
    }
    const int code = write_results(&report, opt);
    const bool good = opt->report_only || hole_report_good(&report);
    hole_report_free(&report);
    return code != 0 ? code : (good ? 0 : 1);
}

int main(int argc, char **argv)
{
    holes_options opt;
    exk_run_log log;
    exk_standard_streams_hold();
    holes_options_parse(argc, argv, &opt);
    exk_run_log_init(&log);
    int code = opt.live ? listen(&log, &opt) : read_log(&log, opt.log_path);
    if (code == 0) {
        code = judge(&log, &opt);
    }
    exk_run_log_free(&log);
    return code;
}
