#define _POSIX_C_SOURCE 200809L
#include "exk/store.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "unity.h"

enum { N = 16 };
static char folder[64];
static char path[96];
static char why[512];
static exk_store made;

void setUp(void)
{
    snprintf(folder, sizeof folder, "/tmp/exk_store_XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/a.ilc", folder);
    TEST_ASSERT_EQUAL(EXK_STORE_OK, exk_store_alloc(&made, N));
    made.job_hash = 0x0123456789abcdefULL;
    made.dt_s = 0.001;
    made.iteration = 3;
    for (int k = 0; k < N; k++) {
        made.u_rad[EXK_ALPHA][k] = 1e-4 * sin(0.1 * k);
        made.u_rad[EXK_BETA][k] = -1e-5 * k;
    }
}

void tearDown(void)
{
    char other[112];
    snprintf(other, sizeof other, "%s.new", path);
    unlink(other);
    snprintf(other, sizeof other, "%s.prev", path);
    unlink(other);
    unlink(path);
    rmdir(folder);
    exk_store_free(&made);
}

static void save(void)
{
    TEST_ASSERT_EQUAL_MESSAGE(EXK_STORE_OK, exk_store_save(path, &made, why, sizeof why), why);
}

static size_t read_file(unsigned char *bytes, size_t size)
{
    FILE *file = fopen(path, "rb");
    TEST_ASSERT_NOT_NULL(file);
    const size_t n = fread(bytes, 1, size, file);
    fclose(file);
    return n;
}

static void write_file(const void *bytes, size_t n)
{
    unlink(path); /* some file systems sync a file that is cut to nothing */
    FILE *file = fopen(path, "wb");
    TEST_ASSERT_NOT_NULL(file);
    TEST_ASSERT_EQUAL_size_t(n, fwrite(bytes, 1, n, file));
    fclose(file);
}

static void what_was_saved_is_loaded_to_the_bit(void)
{
    exk_store got;
    save();
    TEST_ASSERT_EQUAL_MESSAGE(EXK_STORE_OK, exk_store_load(path, &got, why, sizeof why), why);
    TEST_ASSERT_EQUAL_HEX64(made.job_hash, got.job_hash);
    TEST_ASSERT_EQUAL_UINT32(3, got.iteration);
    TEST_ASSERT_EQUAL_size_t(N, got.n_samples);
    TEST_ASSERT_EQUAL_MEMORY(&made.dt_s, &got.dt_s, sizeof got.dt_s);
    for (int i = 0; i < EXK_N_AXES; i++) {
        TEST_ASSERT_EQUAL_MEMORY(made.u_rad[i], got.u_rad[i], N * sizeof(double));
    }
    exk_store_free(&got);
}

static void every_flipped_bit_is_refused(void)
{
    static unsigned char bytes[4096];
    exk_store got;
    save();
    const size_t n = read_file(bytes, sizeof bytes);
    for (size_t bit = 0; bit < 8 * n; bit++) {
        bytes[bit / 8] ^= (unsigned char)(1U << (bit % 8));
        write_file(bytes, n);
        TEST_ASSERT_NOT_EQUAL(EXK_STORE_OK, exk_store_load(path, &got, why, sizeof why));
        TEST_ASSERT_NULL(got.u_rad[0]);
        bytes[bit / 8] ^= (unsigned char)(1U << (bit % 8));
    }
}

static void every_shorter_length_is_refused(void)
{
    static unsigned char bytes[4096];
    exk_store got;
    save();
    const size_t n = read_file(bytes, sizeof bytes);
    for (size_t length = 0; length < n; length++) {
        write_file(bytes, length);
        TEST_ASSERT_NOT_EQUAL(EXK_STORE_OK, exk_store_load(path, &got, why, sizeof why));
    }
    bytes[n] = 0;
    write_file(bytes, n + 1);
    TEST_ASSERT_EQUAL(EXK_STORE_CORRUPT, exk_store_load(path, &got, why, sizeof why));
}

/* Two generations; the newer one is spoilt: it is refused with the reason, the older one is used. */
static void expect_previous(const void *bytes, size_t n)
{
    exk_store got;
    char want[256];
    write_file(bytes, n);
    TEST_ASSERT_EQUAL_MESSAGE(EXK_STORE_OK, exk_store_load(path, &got, why, sizeof why), why);
    TEST_ASSERT_TRUE(got.is_previous);
    TEST_ASSERT_EQUAL_UINT32(3, got.iteration);
    snprintf(want, sizeof want, "; its previous generation is used: %s.prev", path);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why, want), why);
    TEST_ASSERT_EQUAL_STRING_LEN(path, why, strlen(path));
    exk_store_free(&got);
}

static void any_damage_leads_to_the_previous_generation(void)
{
    static unsigned char bytes[4096];
    char previous[112];
    save();
    made.iteration = 4;
    save();
    const size_t n = read_file(bytes, sizeof bytes);
    for (size_t bit = 0; bit < 8 * n; bit++) {
        bytes[bit / 8] ^= (unsigned char)(1U << (bit % 8));
        expect_previous(bytes, n);
        bytes[bit / 8] ^= (unsigned char)(1U << (bit % 8));
    }
    for (size_t length = 0; length < n; length++) {
        expect_previous(bytes, length);
    }
    exk_store got;
    unlink(path);
    TEST_ASSERT_EQUAL(EXK_STORE_OK, exk_store_load(path, &got, why, sizeof why));
    TEST_ASSERT_NOT_NULL(strstr(why,
                                "cannot open the ILC store: No such file or directory; its "
                                "previous generation is used: "));
    exk_store_free(&got);
    snprintf(previous, sizeof previous, "%s.prev", path);
    write_file(bytes, n / 2);
    TEST_ASSERT_EQUAL(0, rename(path, previous));
    write_file(bytes, n / 3);
    TEST_ASSERT_EQUAL(EXK_STORE_CORRUPT, exk_store_load(path, &got, why, sizeof why));
    TEST_ASSERT_NOT_NULL(strstr(why, "; its previous generation is no better: "));
}

/* A damaged store is no generation to keep: saving over it leaves the good one before it. */
static void a_damaged_store_does_not_become_the_previous_one(void)
{
    static unsigned char bytes[4096];
    exk_store got;
    save();
    made.iteration = 4;
    save();
    const size_t n = read_file(bytes, sizeof bytes);
    bytes[80] ^= 1U;
    write_file(bytes, n);
    made.iteration = 5;
    save();
    unlink(path);
    TEST_ASSERT_EQUAL(EXK_STORE_OK, exk_store_load(path, &got, why, sizeof why));
    TEST_ASSERT_EQUAL_UINT32(3, got.iteration);
    exk_store_free(&got);
}

static void one_flipped_bit_is_named(void)
{
    static unsigned char bytes[4096];
    char want[256];
    exk_store got;
    save();
    const size_t n = read_file(bytes, sizeof bytes);
    bytes[100] ^= 1U;
    write_file(bytes, n);
    TEST_ASSERT_EQUAL(EXK_STORE_CORRUPT, exk_store_load(path, &got, why, sizeof why));
    snprintf(want, sizeof want, "%s: damaged ILC store: CRC-32 is ", path);
    TEST_ASSERT_EQUAL_STRING_LEN(want, why, strlen(want));
    TEST_ASSERT_NOT_NULL(strstr(why, "; train again or restore a copy of the file"));
}

static void another_job_is_refused_with_both_hashes(void)
{
    TEST_ASSERT_EQUAL(EXK_STORE_OTHER_JOB,
                      exk_store_match(&made, 1, 0.001, N, why, sizeof why));
    TEST_ASSERT_EQUAL_STRING("ILC store of another job: its hash is 0123456789abcdef, this "
                             "profile's 0000000000000001; "
                             "train a store for this [machine], [kinematics], [job] and rate",
                             why);
    TEST_ASSERT_EQUAL(EXK_STORE_OTHER_JOB,
                      exk_store_match(&made, made.job_hash, 0.002, N, why, sizeof why));
    TEST_ASSERT_EQUAL_STRING(
        "ILC store of 16 samples of 0.001 s; this job has 16 samples of 0.002 s", why);
    TEST_ASSERT_EQUAL(EXK_STORE_OTHER_JOB,
                      exk_store_match(&made, made.job_hash, 0.001, N + 1, why, sizeof why));
    TEST_ASSERT_EQUAL(EXK_STORE_OTHER_JOB,
                      exk_store_match(&made, made.job_hash, (double)NAN, N, why, sizeof why));
    TEST_ASSERT_EQUAL(EXK_STORE_OK,
                      exk_store_match(&made, made.job_hash, 0.001, N, why, sizeof why));
}

static void a_file_that_is_not_ours_stays(void)
{
    char want[256];
    unsigned char bytes[64];
    write_file("my thesis", 9);
    TEST_ASSERT_EQUAL(EXK_STORE_NOT_OURS, exk_store_save(path, &made, why, sizeof why));
    snprintf(want, sizeof want,
             "%s: exists and is not an ILC store: not overwritten; choose another name", path);
    TEST_ASSERT_EQUAL_STRING(want, why);
    TEST_ASSERT_EQUAL_size_t(9, read_file(bytes, sizeof bytes));
    TEST_ASSERT_EQUAL_MEMORY("my thesis", bytes, 9);
}

static void no_folder_no_disk_no_file_are_said(void)
{
    exk_store got;
    TEST_ASSERT_EQUAL(EXK_STORE_IO, exk_store_save("/nowhere/a.ilc", &made, why, sizeof why));
    TEST_ASSERT_EQUAL_STRING(
        "/nowhere/a.ilc: cannot write the ILC store: No such file or directory", why);
    TEST_ASSERT_EQUAL(EXK_STORE_IO, exk_store_load("/nowhere/a.ilc", &got, why, sizeof why));
    TEST_ASSERT_EQUAL_STRING(
        "/nowhere/a.ilc: cannot open the ILC store: No such file or directory", why);
    TEST_ASSERT_EQUAL(EXK_STORE_IO, exk_store_load("/tmp", &got, why, sizeof why));
    TEST_ASSERT_EQUAL_STRING("/tmp: not a regular file: an ILC store is kept in one", why);
}

static void a_second_save_replaces_the_first(void)
{
    exk_store got;
    save();
    made.iteration = 4;
    save();
    TEST_ASSERT_EQUAL(EXK_STORE_OK, exk_store_load(path, &got, why, sizeof why));
    TEST_ASSERT_EQUAL_UINT32(4, got.iteration);
    exk_store_free(&got);
}

static void values_that_are_not_finite_are_refused(void)
{
    exk_store got;
    made.u_rad[EXK_BETA][7] = (double)NAN;
    save();
    TEST_ASSERT_EQUAL(EXK_STORE_CORRUPT, exk_store_load(path, &got, why, sizeof why));
}

/* BLAKE2b-128, first 8 bytes little-endian; figures from Python's hashlib.blake2b(digest_size=16). */
static void hashes_are_blake2b(void)
{
    TEST_ASSERT_EQUAL_HEX64(0x40bdefd94169e6caULL, exk_store_hash("", 0));
    TEST_ASSERT_EQUAL_HEX64(0x2b8d2bc691b74acfULL, exk_store_hash("abc", 3));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(what_was_saved_is_loaded_to_the_bit);
    RUN_TEST(every_flipped_bit_is_refused);
    RUN_TEST(every_shorter_length_is_refused);
    RUN_TEST(any_damage_leads_to_the_previous_generation);
    RUN_TEST(a_damaged_store_does_not_become_the_previous_one);
    RUN_TEST(one_flipped_bit_is_named);
    RUN_TEST(another_job_is_refused_with_both_hashes);
    RUN_TEST(a_file_that_is_not_ours_stays);
    RUN_TEST(no_folder_no_disk_no_file_are_said);
    RUN_TEST(a_second_save_replaces_the_first);
    RUN_TEST(values_that_are_not_finite_are_refused);
    RUN_TEST(hashes_are_blake2b);
    return UNITY_END();
}
