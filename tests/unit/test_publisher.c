#define _DEFAULT_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "exk/event_file.h"
#include "exk/log.h"
#include "telemetry_samples.h"
#include "unity.h"

static made_up_run run;
static exk_publish_summary summary;
static exk_run_log log_of_run;
static char why[512];

void setUp(void)
{
    make_run(&run);
    exk_run_log_init(&log_of_run);
}

void tearDown(void)
{
    exk_run_log_free(&log_of_run);
    clean_up();
}

static exk_publisher *start(const char *path)
{
    run.info.record_path = path;
    exk_publisher *pub = exk_publisher_start(&run.info, why, sizeof why);
    TEST_ASSERT_NOT_NULL_MESSAGE(pub, why);
    return pub;
}

static void publish_ticks(const char *path, const int64_t *ticks, int n)
{
    exk_publisher *pub = start(path);
    for (int i = 0; i < n; i++) {
        const exk_record record = make_record(&run, ticks != NULL ? ticks[i] : i);
        exk_publisher_push(pub, &record);
    }
    exk_publisher_stop(pub, &summary);
}

static void publish_all(const char *path)
{
    publish_ticks(path, NULL, RUN_TICKS);
}

static void read_back(const char *path)
{
    TEST_ASSERT_TRUE_MESSAGE(exk_run_log_read(&log_of_run, path, why, sizeof why), why);
}

static void the_log_needs_nothing_else(void)
{
    const char *path = scratch_path("a.lcm");
    publish_all(path);
    read_back(path);
    TEST_ASSERT_TRUE(log_of_run.has_job);
    TEST_ASSERT_EQUAL_STRING("made_up", log_of_run.profile_name);
    TEST_ASSERT_EQUAL_STRING(run.info.profile_text, log_of_run.profile_text);
    TEST_ASSERT_EQUAL_UINT64(run.info.job_hash, log_of_run.job_hash);
    TEST_ASSERT_EQUAL_INT64(99, log_of_run.run_id);
    TEST_ASSERT_EQUAL(3, log_of_run.series);
    TEST_ASSERT_EQUAL(4, log_of_run.run);
    TEST_ASSERT_EQUAL(RUN_HOLES, log_of_run.n_holes);
    TEST_ASSERT_EQUAL(8, log_of_run.holes[1].id);
    TEST_ASSERT_EQUAL_INT64(RUN_TICKS, log_of_run.n_ticks);
    TEST_ASSERT_EQUAL_INT64(RUN_TICKS, log_of_run.n_poses);
    TEST_ASSERT_EQUAL_INT64(0, log_of_run.n_lost + log_of_run.n_skipped_k + log_of_run.n_other);
    TEST_ASSERT_TRUE(log_of_run.closed);
    TEST_ASSERT_EQUAL(EXK_STATE_DONE, log_of_run.status.state);
    for (int64_t k = 0; k < RUN_TICKS; k++) {
        const exk_sample want = make_sample(&run, k);
        TEST_ASSERT_EQUAL_MEMORY(&want, &log_of_run.samples[k], sizeof want);
    }
}

static void holes_are_judged_as_they_are_drilled(void)
{
    publish_all(scratch_path("a.lcm"));
    TEST_ASSERT_EQUAL(2, summary.accuracy.n_drilled);
    TEST_ASSERT_EQUAL(1, summary.accuracy.n_inside);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 50e-6, summary.accuracy.max_m);
    TEST_ASSERT_EQUAL(1, summary.accuracy.worst);
    TEST_ASSERT_EQUAL_INT64(RUN_TICKS, summary.n_poses);
    TEST_ASSERT_EQUAL_INT64(0, summary.n_dropped);
    TEST_ASSERT_TRUE(summary.bus_ok && summary.file_ok);
    TEST_ASSERT_EQUAL_STRING("", summary.why);
}

/* The order of messages in a log, as one letter each: J P H S. */
static void sequence(const char *path, char *out, size_t size)
{
    exk_event_reader reader;
    size_t n = 0;
    int64_t last_stamp_us = 0;
    TEST_ASSERT_TRUE(exk_event_reader_open(&reader, path, why, sizeof why));
    while (exk_event_reader_next(&reader) == EXK_EVENT_OK && n + 1 < size) {
        out[n++] = reader.channel[4];
        TEST_ASSERT_GREATER_OR_EQUAL_INT64(last_stamp_us, reader.stamp_us);
        last_stamp_us = reader.stamp_us;
    }
    out[n] = '\0';
    exk_event_reader_close(&reader);
}

/* dt 0.1 s, status at 2 Hz, job every second; RUN is a change of state, DONE another, and the last
 * status closes. Before tick 10 comes the job of second 1; statuses come before ticks 5, 10, 15. */
static void messages_come_when_they_are_due(void)
{
    char got[128];
    publish_all(scratch_path("a.lcm"));
    sequence(scratch_path("a.lcm"), got, sizeof got);
    TEST_ASSERT_EQUAL_STRING("JSPSPPPPSPPPPHPJSPPPPPSPPPPHPSS", got);
}

static size_t slurp(const char *path, unsigned char *data, size_t size)
{
    FILE *file = fopen(path, "rb");
    TEST_ASSERT_NOT_NULL(file);
    const size_t n = fread(data, 1, size, file);
    fclose(file);
    return n;
}

static void the_same_run_gives_the_same_bytes(void)
{
    static unsigned char first[65536];
    static unsigned char second[65536];
    publish_all(scratch_path("a.lcm"));
    usleep(2000);
    publish_all(scratch_path("b.lcm"));
    const size_t n = slurp(scratch_path("a.lcm"), first, sizeof first);
    TEST_ASSERT_GREATER_THAN(RUN_TICKS * 300, n);
    TEST_ASSERT_EQUAL(n, slurp(scratch_path("b.lcm"), second, sizeof second));
    TEST_ASSERT_EQUAL_MEMORY(first, second, n);
}

static void check_ticks(const int64_t *want, int n)
{
    TEST_ASSERT_EQUAL_INT64(n, log_of_run.n_poses);
    for (int i = 0; i < n; i++) {
        TEST_ASSERT_EQUAL_INT64(want[i], log_of_run.samples[i].k);
    }
}

static void decimation_keeps_judged_and_last_samples(void)
{
    static const int64_t want[] = {0, 6, 7, 12, 17, 18, 19};
    run.profile.telemetry.every = 6;
    publish_all(scratch_path("a.lcm"));
    read_back(scratch_path("a.lcm"));
    check_ticks(want, 7);
    TEST_ASSERT_EQUAL(6, log_of_run.every);
    TEST_ASSERT_EQUAL_INT64(0, log_of_run.n_lost);
    TEST_ASSERT_EQUAL_INT64(13, log_of_run.n_skipped_k);
    TEST_ASSERT_EQUAL(2, summary.accuracy.n_drilled);
}

/* Ticks 7 (judged) and 8 are missed: 6, last of the dwell, is sent late and judged; the first of
 * the block 8..15 is 9. */
static void the_last_of_a_dwell_is_sent_when_the_judged_tick_was_missed(void)
{
    static const int64_t ticks[] = {0,  1,  2,  3,  4,  5,  6,  9,  10,
                                    11, 12, 13, 14, 15, 16, 17, 18, 19};
    static const int64_t want[] = {0, 6, 9, 16, 17, 19};
    run.profile.telemetry.every = 8;
    publish_ticks(scratch_path("a.lcm"), ticks, 18);
    read_back(scratch_path("a.lcm"));
    check_ticks(want, 6);
    TEST_ASSERT_EQUAL_INT64(0, log_of_run.n_lost);
    TEST_ASSERT_EQUAL(2, summary.accuracy.n_drilled);
}

static void a_run_stopped_early_ends_with_its_last_sample(void)
{
    static const int64_t want[] = {0, 6};
    run.profile.telemetry.every = 8;
    publish_ticks(scratch_path("a.lcm"), NULL, 7); /* 0..6: ends within the first dwell */
    read_back(scratch_path("a.lcm"));
    check_ticks(want, 2);
    TEST_ASSERT_TRUE(log_of_run.closed);
    TEST_ASSERT_EQUAL(0, summary.accuracy.n_drilled);
}

/* Real time with a ring of two: far more is pushed than the publisher can take. Not a record may
 * be unaccounted for: what the log lacks is what the ring refused. */
static void what_a_full_ring_refuses_is_a_gap_in_the_log(void)
{
    enum { N = 20000 };
    run.info.fast = false;
    run.info.n_ticks = N;
    run.profile.telemetry.ring_slots = 2;
    exk_publisher *pub = start(scratch_path("a.lcm"));
    for (int64_t k = 0; k < N; k++) {
        exk_record record = make_record(&run, k % (RUN_TICKS - 1));
        record.sample.k = k;
        exk_publisher_push(pub, &record);
    }
    exk_publisher_stop(pub, &summary);
    TEST_ASSERT_GREATER_THAN_INT64(0, summary.n_dropped);
    TEST_ASSERT_EQUAL_INT64(N, summary.n_poses + summary.n_dropped);
    read_back(scratch_path("a.lcm"));
    TEST_ASSERT_EQUAL_INT64(summary.n_poses, log_of_run.n_poses);
    TEST_ASSERT_EQUAL_INT64(summary.n_dropped, log_of_run.n_lost + log_of_run.n_before);
    TEST_ASSERT_EQUAL_INT64(summary.n_dropped, log_of_run.status.n_dropped);
    TEST_ASSERT_EQUAL_INT64(N, log_of_run.status.n_steps);
}

static void a_file_that_is_not_ours_starts_nothing(void)
{
    const char *path = scratch_path("notes.txt");
    FILE *file = fopen(path, "w");
    fputs("notes\n", file);
    fclose(file);
    run.info.record_path = path;
    TEST_ASSERT_NULL(exk_publisher_start(&run.info, why, sizeof why));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why, "is not an LCM log: not overwritten"), why);
}

static void a_job_that_cannot_be_judged_starts_nothing(void)
{
    run.profile.job.tolerance_m = -1.0;
    TEST_ASSERT_NULL(exk_publisher_start(&run.info, why, sizeof why));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why, "cannot be judged"), why);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_log_needs_nothing_else);
    RUN_TEST(holes_are_judged_as_they_are_drilled);
    RUN_TEST(messages_come_when_they_are_due);
    RUN_TEST(the_same_run_gives_the_same_bytes);
    RUN_TEST(decimation_keeps_judged_and_last_samples);
    RUN_TEST(the_last_of_a_dwell_is_sent_when_the_judged_tick_was_missed);
    RUN_TEST(a_run_stopped_early_ends_with_its_last_sample);
    RUN_TEST(what_a_full_ring_refuses_is_a_gap_in_the_log);
    RUN_TEST(a_file_that_is_not_ours_starts_nothing);
    RUN_TEST(a_job_that_cannot_be_judged_starts_nothing);
    return UNITY_END();
}
