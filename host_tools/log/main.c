/** exk-log: records the bus of exk, or reads a log again. See options.c for its use. */
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "bus_url.h"
#include "exk/bus.h"
#include "exk/log.h"
#include "exk/plural.h"
#include "exk/progress_line.h"
#include "exk/standard_streams.h"
#include "options.h"
#include "path_picture.h"
#include "poses_csv.h"
#include "record.h"
#include "report.h"

enum { WHY_MAX = 1024, GAPS_SHOWN = 5 };

/* What goes on while poses come: rows of the CSV, gaps said at once. */
typedef struct {
    exk_out csv;
    bool has_csv;
    bool quiet;
    bool on_progress; /* a line of progress stands where a note goes */
    int64_t next_seq; /* -1: none seen */
    int n_gaps;
} pose_sink;

static int complain(int code, const char *why)
{
    fprintf(stderr, "exk-log: %s\n", why);
    return code;
}

static int worse(int a, int b)
{
    return a > b ? a : b;
}

static void note_gap(pose_sink *sink, const exk_wire_pose *pose)
{
    const int64_t n = pose->seq - sink->next_seq;
    sink->n_gaps++;
    if (sink->quiet || sink->n_gaps > GAPS_SHOWN) {
        return;
    }
    if (sink->on_progress) {
        exk_progress_clear();
    }
    fprintf(stderr, "exk-log: %" PRId64 " sample%s lost before k %" PRId64 " (%.3f s)%s\n", n,
            exk_plural_s(n), pose->sample.k, 1e-6 * (double)pose->sample.time_us,
            sink->n_gaps == GAPS_SHOWN ? "; further gaps are only counted" : "");
}

static void on_pose(void *ctx, const exk_wire_pose *pose)
{
    pose_sink *sink = ctx;
    if (sink->next_seq >= 0 && pose->seq > sink->next_seq) {
        note_gap(sink, pose);
    }
    sink->next_seq = pose->seq + 1;
    if (sink->has_csv) {
        poses_csv_row(&sink->csv, pose);
    }
}

static void warn_of_small_buffer(void)
{
    const int64_t granted = exk_bus_granted_bytes();
    if (granted < EXK_BUS_BUFFER_BYTES) {
        fprintf(stderr,
                "exk-log: the system grants a receive buffer of %" PRId64
                " bytes, not %d: bursts may "
                "be lost; run `sysctl -w net.core.rmem_max=%d` as root\n",
                granted, EXK_BUS_BUFFER_BYTES, EXK_BUS_BUFFER_BYTES);
    }
}

static int record(const log_options *opt, exk_run_log *log, record_result *result)
{
    char why[WHY_MAX] = "";
    char url[EXK_PATH_MAX];
    exk_bus_url(opt->url, url, sizeof url);
    if (!exk_bus_url_good(url, why, sizeof why)) {
        return complain(2, why);
    }
    const record_request request = {.path = opt->log_path,
                                    .url = url,
                                    .seconds = opt->seconds,
                                    .until_done = opt->until_done,
                                    .progress = !opt->quiet && exk_progress_wanted()};
    if (!opt->quiet) {
        warn_of_small_buffer();
        fprintf(stderr, "exk-log: listening on %s\n", url);
    }
    const int code = record_bus(log, &request, result, why, sizeof why);
    return code == 0 ? 0 : complain(code, why);
}

static int read_log(const log_options *opt, exk_run_log *log)
{
    char why[WHY_MAX] = "";
    FILE *file = fopen(opt->from, "rb");
    if (file == NULL) {
        snprintf(why, sizeof why, "%s: cannot be opened: %s", opt->from, strerror(errno));
        return complain(3, why);
    }
    fclose(file);
    return exk_run_log_read(log, opt->from, why, sizeof why) ? 0 : complain(2, why);
}

static int draw_pictures(const log_options *opt, const exk_run_log *log)
{
    char why[WHY_MAX];
    int code = 0;
    const char *source = opt->from != NULL ? opt->from : opt->log_path;
    for (size_t i = 0; i < opt->plots.n; i++) {
        const int one = path_picture_write(log, source, opt->plots.path[i], why, sizeof why);
        code = worse(code, one == 0 ? 0 : complain(one, why));
    }
    return code;
}

static bool takes_stdout(const char *path)
{
    return path != NULL && strcmp(path, "-") == 0;
}

static int say(const log_options *opt, const log_report *report)
{
    char why[WHY_MAX];
    int code = 0;
    if (!opt->quiet) {
        log_report_notes(report);
    }
    if (opt->json_path != NULL) {
        const int one = log_report_json(report, opt->json_path, why, sizeof why);
        code = one == 0 ? 0 : complain(one, why);
    }
    if (!takes_stdout(opt->json_path)) {
        log_report_print(report, takes_stdout(opt->csv_path) ? stderr : stdout);
    }
    return worse(code, exk_stdout_flush("exk-log"));
}

/* 1: what was asked for is not what came. */
static int verdict(const log_options *opt, const log_report *report)
{
    const record_result *result = report->result;
    /* NOLINTNEXTLINE(clang-analyzer-core.NullDereference): set before any verdict */
    if (opt->until_done && result->end != RECORD_DONE) {
        static const char *const reasons[] = {[RECORD_STOPPED] = "stopped by a signal",
                                              [RECORD_TIME] = "the time was over",
                                              [RECORD_SILENT] = "nothing was heard for 5 s"};
        fprintf(stderr, "exk-log: %s before the run was done\n", reasons[result->end]);
        return 1;
    }
    if (report->log->n_poses == 0) {
        fputs(
            "exk-log: no EXK_POSE was heard: is exk-loop running, and on this URL? exk-doctor "
            "checks the way\n",
            stderr);
    }
    return log_report_whole(report) ? 0 : 1;
}

static int run(const log_options *opt, exk_run_log *log, pose_sink *sink)
{
    char why[WHY_MAX];
    record_result result = {.end = RECORD_DONE};
    int code = opt->from != NULL ? read_log(opt, log) : record(opt, log, &result);
    if (code == 0 && sink->has_csv) {
        sink->has_csv = false;
        code = exk_out_commit(&sink->csv, why, sizeof why);
        code = code == 0 ? 0 : complain(code, why);
    }
    if (code != 0 && opt->from != NULL) {
        return code;
    }
    const log_report report = {.log = log,
                               .path = opt->from != NULL ? opt->from : opt->log_path,
                               .result = opt->from != NULL ? NULL : &result};
    if (code == 0) {
        code = worse(draw_pictures(opt, log), say(opt, &report));
    }
    return code != 0 ? code : verdict(opt, &report);
}

int main(int argc, char **argv)
{
    log_options opt;
    exk_run_log log;
    char why[WHY_MAX];
    pose_sink sink = {.next_seq = -1};
    exk_standard_streams_hold();
    log_options_parse(argc, argv, &opt);
    sink.quiet = opt.quiet;
    sink.on_progress = opt.from == NULL && exk_progress_wanted();
    if (opt.csv_path != NULL) {
        const int refused = poses_csv_open(&sink.csv, opt.csv_path, why, sizeof why);
        if (refused != 0) {
            return complain(refused, why);
        }
        sink.has_csv = true;
    }
    exk_run_log_init(&log);
    log.only_run_id = opt.run_id;
    log.keep_none = true;
    log.on_pose = on_pose;
    log.ctx = &sink;
    const int code = run(&opt, &log, &sink);
    if (sink.has_csv) {
        exk_out_abort(&sink.csv);
    }
    exk_run_log_free(&log);
    return code;
}
