/* The profiles that come with exk, and the page that is written from the table of keys. */
#define _POSIX_C_SOURCE 200809L
#include <dirent.h>
#include <stdio.h>
#include <string.h>

#include "exk/job_csv.h"
#include "exk/profile.h"
#include "unity.h"

enum { MAX_FAULTS = 8, TEXT_SIZE = 65536 };

static const char profiles[] = EXK_SOURCE_DIR "/profiles";
static const char page[] = EXK_SOURCE_DIR "/docs/profiles.md";

static exk_fault faults[MAX_FAULTS];
static char text[TEXT_SIZE];
static char printed[TEXT_SIZE];
static char again[TEXT_SIZE];

void setUp(void)
{
}

void tearDown(void)
{
}

static void read_file(const char *path, char out[TEXT_SIZE])
{
    FILE *file = fopen(path, "rb");
    TEST_ASSERT_NOT_NULL_MESSAGE(file, path);
    const size_t n = fread(out, 1, TEXT_SIZE - 1, file);
    fclose(file);
    TEST_ASSERT_TRUE_MESSAGE(n > 0 && n < TEXT_SIZE - 1, path);
    out[n] = '\0';
}

static bool ends_with(const char *name, const char *ending)
{
    const size_t n = strlen(name);
    const size_t m = strlen(ending);
    return n > m && strcmp(name + n - m, ending) == 0;
}

static exk_profile parse(const char *source, const char *name)
{
    exk_profile profile;
    size_t n = 0;
    const exk_err err = exk_profile_parse(source, &profile, faults, MAX_FAULTS, &n);
    TEST_ASSERT_EQUAL_MESSAGE(EXK_OK, err, n > 0 ? faults[0].message : name);
    return profile;
}

static void check_profile(const char *name)
{
    char path[1024];
    snprintf(path, sizeof(path), "%s/%s", profiles, name);
    read_file(path, text);
    TEST_ASSERT_EQUAL_CHAR_MESSAGE(';', text[0], "a profile starts by saying what it shows");
    const exk_profile profile = parse(text, name);
    exk_profile_print(&profile, printed, sizeof(printed));
    const exk_profile back = parse(printed, name);
    exk_profile_print(&back, again, sizeof(again));
    TEST_ASSERT_EQUAL_STRING_MESSAGE(printed, again, name);
}

static void every_profile_parses_and_prints_back(void)
{
    DIR *folder = opendir(profiles);
    TEST_ASSERT_NOT_NULL(folder);
    int n = 0;
    for (struct dirent *entry = readdir(folder); entry != NULL; entry = readdir(folder)) {
        if (ends_with(entry->d_name, ".ini")) {
            check_profile(entry->d_name);
            n++;
        }
    }
    closedir(folder);
    TEST_ASSERT_TRUE(n >= 10);
}

static void the_rectangle_is_the_study_case(void)
{
    static exk_hole holes[4];
    static exk_segment segments[20];
    exk_plan plan;
    size_t n_holes = 0;
    read_file(EXK_SOURCE_DIR "/profiles/rectangle.ini", text);
    const exk_profile profile = parse(text, "rectangle");
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_rectangle(&profile.job.pattern, holes, 4, &n_holes));
    TEST_ASSERT_EQUAL(EXK_OK, exk_plan_init(&plan, &profile.job.plan, holes, 4, segments, 20));
    TEST_ASSERT_EQUAL_INT64(12000, plan.n_ticks);
}

static void the_wing_root_has_120_holes_in_two_rows(void)
{
    static exk_hole holes[EXK_MAX_HOLES];
    size_t n_holes = 0;
    size_t n_faults = 0;
    read_file(EXK_SOURCE_DIR "/profiles/wing_root.ini", text);
    const exk_profile profile = parse(text, "wing_root");
    read_file(EXK_SOURCE_DIR "/profiles/wing_root.csv", text);
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_csv_parse(text, 1.45, holes, EXK_MAX_HOLES, &n_holes,
                                                faults, MAX_FAULTS, &n_faults));
    TEST_ASSERT_EQUAL_UINT(120, n_holes);
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_serpentine(holes, n_holes, profile.job.row_gap_m));
    TEST_ASSERT_EQUAL_INT32(101, holes[0].id);
    TEST_ASSERT_EQUAL_INT32(160, holes[59].id);
    TEST_ASSERT_EQUAL_INT32(260, holes[60].id); /* the second row comes back */
    TEST_ASSERT_EQUAL_INT32(201, holes[119].id);
}

static void the_page_is_what_the_table_says(void)
{
    const size_t length = exk_profile_manual(printed, sizeof(printed));
    TEST_ASSERT_TRUE(length < sizeof(printed));
    read_file(page, text);
    if (strcmp(printed, text) != 0) {
        TEST_FAIL_MESSAGE("docs/profiles.md is not up to date: run test_profile_files --page > "
                          "docs/profiles.md");
    }
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "--page") == 0) {
        exk_profile_manual(printed, sizeof(printed));
        fputs(printed, stdout);
        return 0;
    }
    UNITY_BEGIN();
    RUN_TEST(every_profile_parses_and_prints_back);
    RUN_TEST(the_rectangle_is_the_study_case);
    RUN_TEST(the_wing_root_has_120_holes_in_two_rows);
    RUN_TEST(the_page_is_what_the_table_says);
    return UNITY_END();
}
