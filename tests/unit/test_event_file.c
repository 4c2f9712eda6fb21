#define _DEFAULT_SOURCE
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "exk/event_file.h"
#include "telemetry_samples.h"
#include "unity.h"

static char why[512];

void setUp(void)
{
    why[0] = '\0';
}

void tearDown(void)
{
    clean_up();
}

static void write_text(const char *path, const void *data, size_t bytes)
{
    FILE *file = fopen(path, "wb");
    TEST_ASSERT_NOT_NULL(file);
    TEST_ASSERT_EQUAL(bytes, fwrite(data, 1, bytes, file));
    fclose(file);
}

static size_t read_all(const char *path, unsigned char *data, size_t size)
{
    FILE *file = fopen(path, "rb");
    TEST_ASSERT_NOT_NULL(file);
    const size_t n = fread(data, 1, size, file);
    fclose(file);
    return n;
}

/* Three records of different lengths; one is empty. */
static const char *const channels[3] = {"EXK_POSE", "A", "EXK_STATUS"};
static const char *const payloads[3] = {"first record", "", "third"};

static void write_three(const char *path)
{
    exk_event_writer *writer = exk_event_writer_create(path, why, sizeof why);
    TEST_ASSERT_NOT_NULL_MESSAGE(writer, why);
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_TRUE(exk_event_writer_add(writer, 1000 * i, channels[i], payloads[i],
                                              strlen(payloads[i])));
    }
    TEST_ASSERT_EQUAL_INT64(3, exk_event_writer_count(writer));
    TEST_ASSERT_TRUE_MESSAGE(exk_event_writer_close(writer, why, sizeof why), why);
}

/* Reads a file whole and checks that what comes is a beginning of the three; returns how many. */
static int count_whole(const char *path, exk_event_status *end)
{
    exk_event_reader reader;
    int n = 0;
    TEST_ASSERT_TRUE_MESSAGE(exk_event_reader_open(&reader, path, why, sizeof why), why);
    while ((*end = exk_event_reader_next(&reader)) == EXK_EVENT_OK) {
        TEST_ASSERT_LESS_THAN(3, n);
        TEST_ASSERT_EQUAL_STRING(channels[n], reader.channel);
        TEST_ASSERT_EQUAL_INT64(1000 * n, reader.stamp_us);
        TEST_ASSERT_EQUAL(strlen(payloads[n]), reader.bytes);
        TEST_ASSERT_EQUAL(0, memcmp(payloads[n], reader.data, reader.bytes));
        n++;
    }
    exk_event_reader_close(&reader);
    return n;
}

static void what_is_written_is_read_back(void)
{
    const char *path = scratch_path("a.lcm");
    exk_event_status end;
    write_three(path);
    TEST_ASSERT_EQUAL(3, count_whole(path, &end));
    TEST_ASSERT_EQUAL(EXK_EVENT_END, end);
    TEST_ASSERT_NOT_EQUAL(0, access(scratch_path("a.lcm.part"), F_OK));
}

/* Record lengths: 28 bytes of header, the channel's name, the payload. */
static int whole_records_in(size_t bytes)
{
    size_t end = 0;
    for (int i = 0; i < 3; i++) {
        end += 28 + strlen(channels[i]) + strlen(payloads[i]);
        if (end > bytes) {
            return i;
        }
    }
    return 3;
}

static void a_log_cut_at_any_length_gives_its_whole_records(void)
{
    unsigned char bytes[256];
    const char *cut = scratch_path("cut.lcm");
    write_three(scratch_path("a.lcm"));
    const size_t n = read_all(scratch_path("a.lcm"), bytes, sizeof bytes);
    TEST_ASSERT_EQUAL(3, whole_records_in(n));
    for (size_t i = 4; i < n; i++) {
        exk_event_status end;
        write_text(cut, bytes, i);
        const int want = whole_records_in(i);
        TEST_ASSERT_EQUAL(want, count_whole(cut, &end));
        const bool at_edge = whole_records_in(i - 1) != want;
        TEST_ASSERT_EQUAL(at_edge ? EXK_EVENT_END : EXK_EVENT_CUT, end);
    }
}

static void damage_is_skipped_and_counted(void)
{
    unsigned char bytes[256];
    exk_event_reader reader;
    write_three(scratch_path("a.lcm"));
    const size_t n = read_all(scratch_path("a.lcm"), bytes, sizeof bytes);
    bytes[28 + 8 + 12] ^= 1; /* sync word of the second record */
    write_text(scratch_path("b.lcm"), bytes, n);
    TEST_ASSERT_TRUE(exk_event_reader_open(&reader, scratch_path("b.lcm"), why, sizeof why));
    TEST_ASSERT_EQUAL(EXK_EVENT_OK, exk_event_reader_next(&reader));
    TEST_ASSERT_EQUAL(EXK_EVENT_OK, exk_event_reader_next(&reader));
    TEST_ASSERT_EQUAL_STRING("EXK_STATUS", reader.channel);
    TEST_ASSERT_EQUAL(EXK_EVENT_END, exk_event_reader_next(&reader));
    TEST_ASSERT_EQUAL_INT64(1, reader.n_damaged);
    exk_event_reader_close(&reader);
}

/* Every single-byte change of a small log is survived, whatever it claims. */
static void any_flipped_byte_is_survived(void)
{
    unsigned char bytes[256];
    write_three(scratch_path("a.lcm"));
    const size_t n = read_all(scratch_path("a.lcm"), bytes, sizeof bytes);
    for (size_t i = 4; i < n; i++) {
        exk_event_reader reader;
        int n_read = 0;
        bytes[i] ^= 0xFF;
        write_text(scratch_path("b.lcm"), bytes, n);
        bytes[i] ^= 0xFF;
        TEST_ASSERT_TRUE(
            exk_event_reader_open(&reader, scratch_path("b.lcm"), why, sizeof why));
        while (exk_event_reader_next(&reader) == EXK_EVENT_OK) {
            n_read++;
        }
        TEST_ASSERT_LESS_OR_EQUAL(3, n_read);
        TEST_ASSERT_GREATER_OR_EQUAL(1, n_read); /* at most one record, or the tail, is hurt */
        exk_event_reader_close(&reader);
    }
}

static void what_is_no_log_is_refused_with_a_reason(void)
{
    exk_event_reader reader;
    write_text(scratch_path("n.txt"), "id,x_mm,y_mm\n", 13);
    write_text(scratch_path("e.lcm"), "", 0);
    static const char *const rows[][2] = {{"n.txt", "not an LCM log"},
                                          {"e.lcm", "empty"},
                                          {"missing", "No such file"},
                                          {".", "not a file"}};
    for (size_t i = 0; i < 4; i++) {
        TEST_ASSERT_FALSE(
            exk_event_reader_open(&reader, scratch_path(rows[i][0]), why, sizeof why));
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why, rows[i][1]), why);
    }
}

static void another_file_is_never_overwritten(void)
{
    static const char text[] = "my thesis";
    char want[512];
    unsigned char back[32];
    const char *path = scratch_path("thesis.txt");
    write_text(path, text, sizeof text);
    TEST_ASSERT_NULL(exk_event_writer_create(path, why, sizeof why));
    snprintf(
        want, sizeof want,
        "%s exists and is not an LCM log: not overwritten; choose another name or move it away",
        path);
    TEST_ASSERT_EQUAL_STRING(want, why);
    TEST_ASSERT_EQUAL(sizeof text, read_all(path, back, sizeof back));
    write_text(scratch_path("b.lcm.part"), text, sizeof text);
    TEST_ASSERT_NULL(exk_event_writer_create(scratch_path("b.lcm"), why, sizeof why));
    TEST_ASSERT_NULL(exk_event_writer_create("/dev/full", why, sizeof why));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why, "is not an LCM log"), why);
}

static void an_older_log_stays_until_the_new_one_is_whole(void)
{
    unsigned char before[256];
    unsigned char during[256];
    const char *path = scratch_path("a.lcm");
    write_three(path);
    const size_t n = read_all(path, before, sizeof before);
    exk_event_writer *writer = exk_event_writer_create(path, why, sizeof why);
    TEST_ASSERT_NOT_NULL(writer);
    TEST_ASSERT_TRUE(exk_event_writer_add(writer, 5, "B", "x", 1));
    TEST_ASSERT_TRUE(exk_event_writer_flush(writer));
    TEST_ASSERT_EQUAL(n, read_all(path, during, sizeof during));
    TEST_ASSERT_EQUAL(0, memcmp(before, during, n));
    TEST_ASSERT_EQUAL(30, read_all(scratch_path("a.lcm.part"), during, sizeof during));
    TEST_ASSERT_TRUE(exk_event_writer_close(writer, why, sizeof why));
    TEST_ASSERT_EQUAL(30, read_all(path, during, sizeof during));
}

static void one_part_has_one_writer(void)
{
    const char *path = scratch_path("a.lcm");
    exk_event_writer *writer = exk_event_writer_create(path, why, sizeof why);
    TEST_ASSERT_NOT_NULL(writer);
    TEST_ASSERT_NULL(exk_event_writer_create(path, why, sizeof why));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why, "is being written by another process"), why);
    exk_event_writer_drop(writer);
    TEST_ASSERT_NOT_EQUAL(0, access(scratch_path("a.lcm.part"), F_OK));
}

/* A file size limit stands in for a full disk: both end a write half way. The log is left with the
 * whole records that fitted, under its part's name. */
static void a_full_disk_leaves_whole_records(void)
{
    enum { RECORD = 28 + 1 + 100, FIT = 7 };
    const char *path = scratch_path("full.lcm");
    const struct rlimit small = {RECORD * FIT + 50, RLIM_INFINITY};
    struct rlimit before;
    char payload[100] = {0};
    bool ok = true;
    signal(SIGXFSZ, SIG_IGN);
    exk_event_writer *writer = exk_event_writer_create(path, why, sizeof why);
    TEST_ASSERT_NOT_NULL_MESSAGE(writer, why);
    getrlimit(RLIMIT_FSIZE, &before);
    setrlimit(RLIMIT_FSIZE, &small);
    for (int i = 0; ok && i < 20; i++) {
        ok = exk_event_writer_add(writer, i, "C", payload, sizeof payload) &&
             exk_event_writer_flush(writer);
    }
    setrlimit(RLIMIT_FSIZE, &before);
    TEST_ASSERT_FALSE(ok);
    TEST_ASSERT_FALSE(exk_event_writer_add(writer, 99, "C", payload, sizeof payload));
    TEST_ASSERT_FALSE(exk_event_writer_close(writer, why, sizeof why));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why, "recording stopped: File too large"), why);
    struct stat info;
    TEST_ASSERT_NOT_EQUAL(0, access(path, F_OK));
    TEST_ASSERT_EQUAL(0, stat(scratch_path("full.lcm.part"), &info));
    TEST_ASSERT_EQUAL_INT64(RECORD * FIT, info.st_size);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(what_is_written_is_read_back);
    RUN_TEST(a_log_cut_at_any_length_gives_its_whole_records);
    RUN_TEST(damage_is_skipped_and_counted);
    RUN_TEST(any_flipped_byte_is_survived);
    RUN_TEST(what_is_no_log_is_refused_with_a_reason);
    RUN_TEST(another_file_is_never_overwritten);
    RUN_TEST(an_older_log_stays_until_the_new_one_is_whole);
    RUN_TEST(one_part_has_one_writer);
    RUN_TEST(a_full_disk_leaves_whole_records);
    return UNITY_END();
}
