#include "report.h"

#include <inttypes.h>

#include "exk/plural.h"
#include "json_file.h"

static const char *ending(const exk_run_log *log)
{
    if (!log->has_status) {
        return "no status seen";
    }
    if (log->closed && log->status.state != EXK_STATE_FAULT) {
        const bool whole = log->last_k + 1 >= log->n_ticks;
        return whole || !log->has_job ? "done" : "stopped before its end";
    }
    return exk_state_name(log->status.state);
}

/* Ticks the loop itself missed. With every > 1 the gaps in k are mostly meant, and the loop's own
 * count is the one to trust. */
static int64_t missed_ticks(const exk_run_log *log)
{
    return log->every > 1 ? log->status.n_overruns : log->n_skipped_k;
}

static void line(FILE *out, const char *what, int64_t n, const char *remark)
{
    fprintf(out, "  %-16s %10" PRId64 "%s%s\n", what, n, *remark != '\0' ? "  " : "", remark);
}

static void print_head(const log_report *report, FILE *out)
{
    const exk_run_log *log = report->log;
    fprintf(out, "%s: ", report->path);
    if (log->has_job) {
        fprintf(out, "%s, run %" PRIu32 " of series %" PRIu32 ", %zu holes, dt %g s, %s\n",
                log->profile_name, log->run, log->series, log->n_holes, log->dt_s, ending(log));
    } else if (log->has_run) {
        fprintf(out, "a run without EXK_JOB, %s\n", ending(log));
    } else {
        fputs("no run seen\n", out);
    }
}

static void print_file(const log_report *report, FILE *out)
{
    const record_result *r = report->result;
    if (r == NULL) {
        return;
    }
    const double rate = r->seconds > 0.0 ? (double)r->n_messages / r->seconds : 0.0;
    fprintf(out, "  %-16s %10" PRId64 "  in %.3f s (%.0f/s), %.3f MB\n", "messages written",
            r->n_messages, r->seconds, rate, 1e-6 * (double)r->n_bytes);
}

void log_report_print(const log_report *report, FILE *out)
{
    const exk_run_log *log = report->log;
    char remark[96] = "";
    print_head(report, out);
    if (log->n_poses > 0) {
        snprintf(remark, sizeof remark, "k %" PRId64 " to %" PRId64 " of %" PRId64,
                 log->first_k, log->last_k, log->n_ticks);
    }
    line(out, "samples", log->n_poses, remark);
    snprintf(remark, sizeof remark, "%" PRId64 " refused by the ring of exk-loop",
             log->status.n_dropped);
    line(out, "lost", log->n_lost, log->status.n_dropped > 0 ? remark : "");
    line(out, "missed ticks", missed_ticks(log), "");
    line(out, "repeated", log->n_repeated, "");
    line(out, "not decoded", log->n_undecoded, "");
    if (log->every > 1) {
        snprintf(remark, sizeof remark,
                 "one in %" PRId32 " ticks is published, and every judged one", log->every);
        line(out, "left out", log->n_skipped_k - missed_ticks(log), remark);
    }
    print_file(report, out);
}

void log_report_notes(const log_report *report)
{
    const exk_run_log *log = report->log;
    if (log->n_before > 0) {
        fprintf(stderr,
                "exk-log: joined late: %" PRId64 " sample%s sent before the first one here\n",
                log->n_before, log->n_before == 1 ? " was" : "s were");
    }
    if (log->n_other_run > 0) {
        fprintf(stderr,
                "exk-log: %" PRId64
                " message%s of other runs not counted (counted: --run-id %" PRId64 ")\n",
                log->n_other_run, exk_plural_s(log->n_other_run), log->run_id);
    }
    if (log->truncated) {
        fprintf(stderr, "exk-log: %s ends inside a record: all whole ones before it are used\n",
                report->path);
    }
    if (log->n_damaged > 0) {
        fprintf(stderr, "exk-log: %s: %" PRId64 " damaged place%s skipped\n", report->path,
                log->n_damaged, exk_plural_s(log->n_damaged));
    }
    if (log->n_poses > 0 && !log->has_job) {
        fputs("exk-log: no EXK_JOB was seen: the holes of this run are not known\n", stderr);
    }
    if (log->has_status && log->status.state == EXK_STATE_FAULT) {
        fprintf(stderr, "exk-log: the run ended by a fault: %s\n", log->status.reason);
    }
}

bool log_report_whole(const log_report *report)
{
    const exk_run_log *log = report->log;
    return log->n_poses > 0 && log->n_lost == 0 && log->n_damaged == 0 && !log->truncated;
}

static void set_int(json_t *root, const char *key, int64_t value)
{
    json_object_set_new(root, key, json_integer(value));
}

static void set_run(json_t *root, const exk_run_log *log)
{
    json_object_set_new(root, "profile", json_string(log->profile_name));
    set_int(root, "run_id", log->run_id);
    set_int(root, "series", log->series);
    set_int(root, "run", log->run);
    json_object_set_new(root, "dt_s", exk_json_real(log->dt_s));
    set_int(root, "n_holes", (int64_t)log->n_holes);
    set_int(root, "n_ticks", log->n_ticks);
    set_int(root, "every", log->every);
    json_object_set_new(root, "ended", json_string(ending(log)));
}

static void set_counts(json_t *root, const exk_run_log *log)
{
    set_int(root, "samples", log->n_poses);
    set_int(root, "first_k", log->first_k);
    set_int(root, "last_k", log->last_k);
    set_int(root, "lost_samples", log->n_lost);
    set_int(root, "before_start", log->n_before);
    set_int(root, "missed_ticks", missed_ticks(log));
    set_int(root, "repeated", log->n_repeated);
    set_int(root, "not_decoded", log->n_undecoded);
    set_int(root, "other_messages", log->n_other);
    set_int(root, "damaged_places", log->n_damaged);
    json_object_set_new(root, "truncated", json_boolean(log->truncated));
}

int log_report_json(const log_report *report, const char *path, char *why, size_t why_size)
{
    json_t *root = json_object();
    json_object_set_new(root, "log", json_string(report->path));
    set_run(root, report->log);
    set_counts(root, report->log);
    if (report->result != NULL) {
        set_int(root, "messages_written", report->result->n_messages);
        set_int(root, "bytes_written", report->result->n_bytes);
        json_object_set_new(root, "seconds", exk_json_real(report->result->seconds));
    }
    const int code = exk_json_write(root, path, "log", why, why_size);
    json_decref(root);
    return code;
}
