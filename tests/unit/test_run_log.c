#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exk/event_file.h"
#include "exk/log.h"
#include "telemetry_samples.h"
#include "unity.h"

static made_up_run run;
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

static void feed(int64_t run_id, int64_t seq, int64_t k)
{
    unsigned char buffer[EXK_WIRE_POSE_MAX];
    const size_t bytes = make_pose(&run, run_id, seq, k, buffer);
    TEST_ASSERT_TRUE(exk_run_log_feed(&log_of_run, EXK_CHANNEL_POSE, buffer, bytes));
}

static void feed_last_status(int64_t run_id, int64_t n_poses)
{
    unsigned char buffer[EXK_WIRE_STATUS_MAX];
    const exk_wire_status status = {
        .stamp = {.run_id = run_id}, .state = EXK_STATE_RUN, .last = true, .n_poses = n_poses};
    const int bytes = exk_wire_status_encode(&status, buffer, sizeof buffer);
    TEST_ASSERT_TRUE(exk_run_log_feed(&log_of_run, EXK_CHANNEL_STATUS, buffer, (size_t)bytes));
}

/* seq and k of messages in the order they come, and what must be counted. */
static void gaps_repeats_and_reorder_are_told_apart(void)
{
    static const struct {
        const char *name;
        int n;
        int64_t seq[6];
        int64_t k[6];
        int64_t n_poses, n_lost, n_skipped, n_repeated, n_before;
    } rows[] = {
        {"whole", 4, {0, 1, 2, 3}, {0, 1, 2, 3}, 4, 0, 0, 0, 0},
        {"one lost", 3, {0, 2, 3}, {0, 2, 3}, 3, 1, 0, 0, 0},
        {"three lost in two gaps", 3, {0, 2, 5}, {0, 2, 5}, 3, 3, 0, 0, 0},
        {"missed ticks are no loss", 3, {0, 1, 2}, {0, 4, 5}, 3, 0, 3, 0, 0},
        {"loss beside missed ticks", 3, {0, 3, 4}, {0, 9, 11}, 3, 2, 1, 0, 0},
        {"repeated", 4, {0, 1, 1, 2}, {0, 1, 1, 2}, 3, 0, 0, 1, 0},
        {"reordered: late one left out", 4, {0, 2, 1, 3}, {0, 2, 1, 3}, 3, 1, 0, 1, 0},
        {"joined late", 2, {5, 6}, {5, 6}, 2, 0, 0, 0, 5},
        {"k falls though seq rises", 3, {0, 1, 2}, {4, 3, 5}, 2, 1, 0, 1, 0},
        {"k stands though seq rises", 2, {0, 1}, {4, 4}, 1, 0, 0, 1, 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        exk_run_log_free(&log_of_run);
        for (int j = 0; j < rows[i].n; j++) {
            feed(7, rows[i].seq[j], rows[i].k[j]);
        }
        TEST_ASSERT_EQUAL_INT64_MESSAGE(rows[i].n_poses, log_of_run.n_poses, rows[i].name);
        TEST_ASSERT_EQUAL_MESSAGE(rows[i].n_poses, log_of_run.n_samples, rows[i].name);
        TEST_ASSERT_EQUAL_INT64_MESSAGE(rows[i].n_lost, log_of_run.n_lost, rows[i].name);
        TEST_ASSERT_EQUAL_INT64_MESSAGE(rows[i].n_skipped, log_of_run.n_skipped_k,
                                        rows[i].name);
        TEST_ASSERT_EQUAL_INT64_MESSAGE(rows[i].n_repeated, log_of_run.n_repeated,
                                        rows[i].name);
        TEST_ASSERT_EQUAL_INT64_MESSAGE(rows[i].n_before, log_of_run.n_before, rows[i].name);
    }
}

static void the_last_status_tells_of_poses_lost_at_the_end(void)
{
    feed(7, 0, 0);
    feed(7, 1, 1);
    feed_last_status(7, 5);
    TEST_ASSERT_EQUAL_INT64(3, log_of_run.n_lost);
    TEST_ASSERT_TRUE(log_of_run.ended);
    TEST_ASSERT_TRUE(log_of_run.closed);
    feed_last_status(7, 5);
    TEST_ASSERT_EQUAL_INT64(3, log_of_run.n_lost);
}

static void another_run_is_counted_and_left_out(void)
{
    feed(7, 0, 0);
    feed(8, 0, 0);
    feed(8, 1, 1);
    feed(7, 1, 1);
    feed_last_status(8, 9);
    TEST_ASSERT_EQUAL_INT64(7, log_of_run.run_id);
    TEST_ASSERT_EQUAL_INT64(2, log_of_run.n_poses);
    TEST_ASSERT_EQUAL_INT64(0, log_of_run.n_lost);
    TEST_ASSERT_EQUAL_INT64(3, log_of_run.n_other_run);
    TEST_ASSERT_EQUAL_INT64(3, log_of_run.n_other);
    TEST_ASSERT_FALSE(log_of_run.ended);
}

static void a_run_can_be_asked_for(void)
{
    log_of_run.only_run_id = 8;
    feed(7, 0, 0);
    feed(8, 0, 3);
    TEST_ASSERT_EQUAL_INT64(8, log_of_run.run_id);
    TEST_ASSERT_EQUAL_INT64(1, log_of_run.n_poses);
    TEST_ASSERT_EQUAL_INT64(3, log_of_run.first_k);
}

static void garbage_is_counted_and_harmless(void)
{
    static const char *const channels[] = {EXK_CHANNEL_POSE, EXK_CHANNEL_JOB, EXK_CHANNEL_HOLE,
                                           EXK_CHANNEL_STATUS};
    unsigned char noise[700];
    uint32_t x = 1;
    for (size_t i = 0; i < sizeof noise; i++) {
        x = x * 1664525U + 1013904223U;
        noise[i] = (unsigned char)(x >> 24);
    }
    for (size_t c = 0; c < 4; c++) {
        for (size_t n = 0; n <= sizeof noise; n += 7) {
            TEST_ASSERT_TRUE(exk_run_log_feed(&log_of_run, channels[c], noise, n));
        }
    }
    TEST_ASSERT_EQUAL_INT64(4 * 101, log_of_run.n_undecoded);
    TEST_ASSERT_EQUAL_INT64(0, log_of_run.n_poses);
    TEST_ASSERT_FALSE(log_of_run.has_run);
}

static void other_channels_are_counted(void)
{
    TEST_ASSERT_TRUE(exk_run_log_feed(&log_of_run, "CAMERA", "x", 1));
    TEST_ASSERT_EQUAL_INT64(1, log_of_run.n_other);
    TEST_ASSERT_EQUAL_INT64(0, log_of_run.n_other_run);
}

static int n_handed_over;

static void take(void *ctx, const exk_wire_pose *pose)
{
    int64_t *last_k = ctx;
    *last_k = pose->sample.k;
    n_handed_over++;
}

static void a_stream_of_any_length_needs_no_memory(void)
{
    int64_t last_k = -1;
    n_handed_over = 0;
    log_of_run.keep_none = true;
    log_of_run.on_pose = take;
    log_of_run.ctx = &last_k;
    for (int64_t k = 0; k < 5000; k++) {
        feed(7, k, k);
    }
    feed(7, 10, 10);
    TEST_ASSERT_EQUAL(5000, n_handed_over);
    TEST_ASSERT_EQUAL_INT64(4999, last_k);
    TEST_ASSERT_NULL(log_of_run.samples);
    TEST_ASSERT_EQUAL_INT64(5000, log_of_run.n_poses);
}

static void write_log(const char *path, const char *channel, int n)
{
    exk_event_writer *writer = exk_event_writer_create(path, why, sizeof why);
    TEST_ASSERT_NOT_NULL_MESSAGE(writer, why);
    for (int i = 0; i < n; i++) {
        unsigned char buffer[EXK_WIRE_POSE_MAX];
        const size_t bytes = make_pose(&run, 7, i, i, buffer);
        TEST_ASSERT_TRUE(exk_event_writer_add(writer, i, channel, buffer, bytes));
    }
    TEST_ASSERT_TRUE(exk_event_writer_close(writer, why, sizeof why));
}

/* A log cut at every length from one record on: all whole poses, and the truth about the end. */
static void a_log_cut_anywhere_is_read_and_says_so(void)
{
    enum { N = 4 };
    static unsigned char bytes[4096];
    const char *path = scratch_path("run.lcm");
    write_log(path, EXK_CHANNEL_POSE, N);
    FILE *file = fopen(path, "rb");
    const size_t n = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    const size_t record = n / N;
    TEST_ASSERT_EQUAL(n, record * N);
    for (size_t cut = record; cut <= n; cut++) {
        file = fopen(scratch_path("cut.lcm"), "wb");
        TEST_ASSERT_EQUAL(cut, fwrite(bytes, 1, cut, file));
        fclose(file);
        exk_run_log_free(&log_of_run);
        TEST_ASSERT_TRUE(
            exk_run_log_read(&log_of_run, scratch_path("cut.lcm"), why, sizeof why));
        TEST_ASSERT_EQUAL_INT64((int64_t)(cut / record), log_of_run.n_poses);
        TEST_ASSERT_EQUAL(cut % record != 0, log_of_run.truncated);
    }
    const exk_sample want = make_sample(&run, N - 1);
    TEST_ASSERT_EQUAL_INT64(want.k, log_of_run.samples[N - 1].k);
    TEST_ASSERT_EQUAL_MEMORY(want.real.tip_m, log_of_run.samples[N - 1].real.tip_m, 24);
}

static void a_log_without_poses_says_what_it_has(void)
{
    char want[512];
    const char *path = scratch_path("other.lcm");
    write_log(path, "CAMERA", 3);
    TEST_ASSERT_FALSE(exk_run_log_read(&log_of_run, path, why, sizeof why));
    snprintf(
        want, sizeof want,
        "%s: an LCM log, but without EXK_POSE (3 messages of other channels); record one with "
        "exk-log or exk-loop --record",
        path);
    TEST_ASSERT_EQUAL_STRING(want, why);
}

static void a_log_of_other_types_says_so(void)
{
    char want[512];
    const char *path = scratch_path("types.lcm");
    write_log(path, EXK_CHANNEL_STATUS, 2); /* poses where statuses should be */
    TEST_ASSERT_FALSE(exk_run_log_read(&log_of_run, path, why, sizeof why));
    snprintf(
        want, sizeof want,
        "%s: no pose of ours: 2 messages on our channels are of other types; was it written by "
        "another version of exk?",
        path);
    TEST_ASSERT_EQUAL_STRING(want, why);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(gaps_repeats_and_reorder_are_told_apart);
    RUN_TEST(the_last_status_tells_of_poses_lost_at_the_end);
    RUN_TEST(another_run_is_counted_and_left_out);
    RUN_TEST(a_run_can_be_asked_for);
    RUN_TEST(garbage_is_counted_and_harmless);
    RUN_TEST(other_channels_are_counted);
    RUN_TEST(a_stream_of_any_length_needs_no_memory);
    RUN_TEST(a_log_cut_anywhere_is_read_and_says_so);
    RUN_TEST(a_log_without_poses_says_what_it_has);
    RUN_TEST(a_log_of_other_types_says_so);
    return UNITY_END();
}
