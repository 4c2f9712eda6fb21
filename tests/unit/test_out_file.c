#define _XOPEN_SOURCE 700
#include <dirent.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "json_file.h"
#include "out_file.h"
#include "unity.h"

static char folder[64];
static char path[128];
static char why[512];

static void in_folder(const char *name)
{
    snprintf(path, sizeof path, "%s/%s", folder, name);
}

void setUp(void)
{
    snprintf(folder, sizeof folder, "exk_out_XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    in_folder("a.csv");
    why[0] = '\0';
}

static int count_files(void)
{
    int n = 0;
    DIR *dir = opendir(folder);
    for (struct dirent *e = readdir(dir); e != NULL; e = readdir(dir)) {
        n += e->d_name[0] != '.' ? 1 : 0;
    }
    closedir(dir);
    return n;
}

void tearDown(void)
{
    char name[512];
    DIR *dir = opendir(folder);
    for (struct dirent *e = readdir(dir); e != NULL; e = readdir(dir)) {
        snprintf(name, sizeof name, "%s/%s", folder, e->d_name);
        if (e->d_name[0] != '.') {
            remove(name);
        }
    }
    closedir(dir);
    rmdir(folder);
}

static void put(const char *text)
{
    FILE *f = fopen(path, "wb");
    TEST_ASSERT_NOT_NULL(f);
    fputs(text, f);
    fclose(f);
}

static const char *get(void)
{
    static char text[4096];
    FILE *f = fopen(path, "rb");
    TEST_ASSERT_NOT_NULL(f);
    text[fread(text, 1, sizeof text - 1, f)] = '\0';
    fclose(f);
    return text;
}

static int write_csv(const char *body)
{
    exk_out out;
    const int code = exk_out_open(&out, path, EXK_OUT_TEXT, "a,b\n", why, sizeof why);
    if (code != 0) {
        return code;
    }
    fputs(body, out.file);
    return exk_out_commit(&out, why, sizeof why);
}

static void a_new_file_is_whole_after_commit_and_absent_before(void)
{
    exk_out out;
    struct stat st;
    TEST_ASSERT_EQUAL(0, exk_out_open(&out, path, EXK_OUT_TEXT, "a,b\n", why, sizeof why));
    fputs("a,b\n1,2\n", out.file);
    TEST_ASSERT_NOT_EQUAL(0, stat(path, &st));
    TEST_ASSERT_EQUAL(0, exk_out_commit(&out, why, sizeof why));
    TEST_ASSERT_EQUAL_STRING("a,b\n1,2\n", get());
    TEST_ASSERT_EQUAL(1, count_files());
    TEST_ASSERT_EQUAL(0, stat(path, &st));
    const mode_t mask = umask(0);
    umask(mask);
    TEST_ASSERT_EQUAL_HEX(0666 & ~mask, st.st_mode & 0777);
}

static void an_aborted_file_leaves_nothing_and_the_old_one(void)
{
    exk_out out;
    put("a,b\nold\n");
    TEST_ASSERT_EQUAL(0, exk_out_open(&out, path, EXK_OUT_TEXT, "a,b\n", why, sizeof why));
    fputs("a,b\nnew\n", out.file);
    exk_out_abort(&out);
    TEST_ASSERT_EQUAL_STRING("a,b\nold\n", get());
    TEST_ASSERT_EQUAL(1, count_files());
}

static void an_earlier_result_and_an_empty_file_are_replaced(void)
{
    put("a,b\nold\n");
    TEST_ASSERT_EQUAL(0, chmod(path, 0600));
    TEST_ASSERT_EQUAL(0, write_csv("a,b\nnew\n"));
    TEST_ASSERT_EQUAL_STRING("a,b\nnew\n", get());
    struct stat st;
    TEST_ASSERT_EQUAL(0, stat(path, &st));
    TEST_ASSERT_EQUAL_HEX(0600, st.st_mode & 0777);
    put("");
    TEST_ASSERT_EQUAL(0, write_csv("a,b\n"));
}

static void another_file_is_left_as_it_is(void)
{
    char want[512];
    put("a,b,c\n1,2,3\n");
    TEST_ASSERT_EQUAL(2, write_csv("a,b\n"));
    snprintf(
        want, sizeof want,
        "%s: exists and is not an earlier result of this kind, so it is left as it is: choose "
        "another name or remove it",
        path);
    TEST_ASSERT_EQUAL_STRING(want, why);
    TEST_ASSERT_EQUAL_STRING("a,b,c\n1,2,3\n", get());
    put("a,");
    TEST_ASSERT_EQUAL(2, write_csv("a,b\n"));
}

static int open_kind(const char *content, exk_out_kind kind)
{
    exk_out out;
    put(content);
    const int code = exk_out_open(&out, path, kind, NULL, why, sizeof why);
    if (code == 0) {
        exk_out_abort(&out);
    }
    return code;
}

static void pictures_are_told_by_their_marks(void)
{
    static const char ours[] = "<?xml?><svg><title>Gnuplot</title><desc>Produced by GNUPLOT 5";
    TEST_ASSERT_EQUAL(0, open_kind(ours, EXK_OUT_SVG));
    TEST_ASSERT_EQUAL(2, open_kind("<?xml version=\"1.0\"?><svg>a drawing</svg>", EXK_OUT_SVG));
    TEST_ASSERT_NOT_NULL(strstr(why, "is not an SVG picture made by gnuplot"));
    TEST_ASSERT_EQUAL(0, open_kind("\x89PNG\r\n\x1a\nbytes", EXK_OUT_PNG));
    TEST_ASSERT_EQUAL(2, open_kind("\x89PN", EXK_OUT_PNG));
    TEST_ASSERT_NOT_NULL(strstr(why, "is not a PNG picture"));
}

static void the_file_behind_a_link_is_replaced_not_the_link(void)
{
    char link_path[128];
    struct stat st;
    put("a,b\nold\n");
    snprintf(link_path, sizeof link_path, "%s/link.csv", folder);
    TEST_ASSERT_EQUAL(0, symlink("a.csv", link_path));
    in_folder("link.csv");
    TEST_ASSERT_EQUAL(0, write_csv("a,b\nnew\n"));
    TEST_ASSERT_EQUAL(0, lstat(path, &st));
    TEST_ASSERT_TRUE(S_ISLNK(st.st_mode));
    in_folder("a.csv");
    TEST_ASSERT_EQUAL_STRING("a,b\nnew\n", get());
}

static void folders_and_places_that_are_not_there(void)
{
    snprintf(path, sizeof path, "%s", folder);
    TEST_ASSERT_EQUAL(2, write_csv("a,b\n"));
    TEST_ASSERT_NOT_NULL(strstr(why, ": is a folder: give the name of a file"));
    in_folder("no/such/place.csv");
    TEST_ASSERT_EQUAL(3, write_csv("a,b\n"));
    TEST_ASSERT_NOT_NULL(strstr(why, ": cannot be written there: No such file or directory"));
    char *longer = malloc(2 * EXK_OUT_PATH_MAX);
    exk_out out;
    memset(longer, 'x', 2 * EXK_OUT_PATH_MAX - 1);
    longer[2 * EXK_OUT_PATH_MAX - 1] = '\0';
    TEST_ASSERT_EQUAL(3, exk_out_open(&out, longer, EXK_OUT_TEXT, "a", why, sizeof why));
    free(longer);
}

static void a_full_disk_is_said_and_leaves_nothing(void)
{
    snprintf(path, sizeof path, "/dev/full");
    TEST_ASSERT_EQUAL(3, write_csv("a,b\n"));
    TEST_ASSERT_EQUAL_STRING("/dev/full: could not be written: No space left on device", why);
    const struct rlimit small = {16, RLIM_INFINITY};
    struct rlimit old;
    TEST_ASSERT_EQUAL(0, getrlimit(RLIMIT_FSIZE, &old));
    signal(SIGXFSZ, SIG_IGN);
    in_folder("a.csv");
    put("a,b\nold\n");
    TEST_ASSERT_EQUAL(0, setrlimit(RLIMIT_FSIZE, &small));
    const int code = write_csv("a,b\n0123456789012345678901234567890123456789\n");
    TEST_ASSERT_EQUAL(0, setrlimit(RLIMIT_FSIZE, &old));
    TEST_ASSERT_EQUAL(3, code);
    TEST_ASSERT_NOT_NULL(strstr(why, ": could not be written: File too large"));
    TEST_ASSERT_EQUAL_STRING("a,b\nold\n", get());
    TEST_ASSERT_EQUAL(1, count_files());
}

static void a_device_is_written_straight_into(void)
{
    struct stat st;
    snprintf(path, sizeof path, "/dev/null");
    TEST_ASSERT_EQUAL(0, write_csv("a,b\n"));
    TEST_ASSERT_EQUAL(0, stat(path, &st));
    TEST_ASSERT_TRUE(S_ISCHR(st.st_mode));
}

static void json_is_written_and_known_again(void)
{
    json_t *root = json_object();
    json_object_set_new(root, "first", exk_json_real(0.1));
    json_object_set_new(root, "none", exk_json_real(NAN));
    json_object_set_new(root, "far", exk_json_real(-INFINITY));
    TEST_ASSERT_EQUAL(0, exk_json_write(root, path, "first", why, sizeof why));
    TEST_ASSERT_EQUAL_STRING("{\n  \"first\": 0.1,\n  \"none\": null,\n  \"far\": null\n}\n",
                             get());
    TEST_ASSERT_EQUAL(0, exk_json_write(root, path, "first", why, sizeof why));
    TEST_ASSERT_EQUAL(2, exk_json_write(root, path, "other", why, sizeof why));
    snprintf(path, sizeof path, "/dev/full");
    TEST_ASSERT_EQUAL(3, exk_json_write(root, path, "first", why, sizeof why));
    json_decref(root);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_new_file_is_whole_after_commit_and_absent_before);
    RUN_TEST(an_aborted_file_leaves_nothing_and_the_old_one);
    RUN_TEST(an_earlier_result_and_an_empty_file_are_replaced);
    RUN_TEST(another_file_is_left_as_it_is);
    RUN_TEST(pictures_are_told_by_their_marks);
    RUN_TEST(the_file_behind_a_link_is_replaced_not_the_link);
    RUN_TEST(folders_and_places_that_are_not_there);
    RUN_TEST(a_full_disk_is_said_and_leaves_nothing);
    RUN_TEST(a_device_is_written_straight_into);
    RUN_TEST(json_is_written_and_known_again);
    return UNITY_END();
}
