#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "exk/command.h"
#include "unity.h"

static char folder[64];
static char path[96];
static char why[512];
static exk_key_secret key;

void setUp(void)
{
    snprintf(folder, sizeof folder, "/tmp/exk_key_XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/operator.key", folder);
}

void tearDown(void)
{
    unlink(path);
    rmdir(folder);
}

static void write_key(const char *text, mode_t mode)
{
    FILE *file = fopen(path, "wb");
    TEST_ASSERT_NOT_NULL(file);
    TEST_ASSERT_EQUAL_size_t(strlen(text), fwrite(text, 1, strlen(text), file));
    fclose(file);
    TEST_ASSERT_EQUAL(0, chmod(path, mode));
}

static void a_new_key_is_private_loads_and_differs_from_the_next(void)
{
    struct stat info;
    exk_key_secret other;
    TEST_ASSERT_TRUE_MESSAGE(exk_key_make(path, why, sizeof why), why);
    TEST_ASSERT_EQUAL(0, stat(path, &info));
    TEST_ASSERT_EQUAL_HEX(0600, info.st_mode & 07777U);
    TEST_ASSERT_TRUE_MESSAGE(exk_key_load(path, &key, why, sizeof why), why);
    TEST_ASSERT_FALSE(exk_key_make(path, why, sizeof why));
    TEST_ASSERT_NOT_NULL(strstr(why, "an existing file is never overwritten"));
    unlink(path);
    TEST_ASSERT_TRUE(exk_key_make(path, why, sizeof why));
    TEST_ASSERT_TRUE(exk_key_load(path, &other, why, sizeof why));
    TEST_ASSERT_TRUE(memcmp(key.bytes, other.bytes, sizeof key.bytes) != 0);
}

#define DIGITS "000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1F"

static void digits_are_the_bytes(void)
{
    write_key(DIGITS "\n", 0400);
    TEST_ASSERT_TRUE_MESSAGE(exk_key_load(path, &key, why, sizeof why), why);
    for (int i = 0; i < EXK_KEY_BYTES; i++) {
        TEST_ASSERT_EQUAL_UINT8(i, key.bytes[i]);
    }
    unlink(path);
    write_key(DIGITS, 0600);
    TEST_ASSERT_TRUE(exk_key_load(path, &key, why, sizeof why));
}

static void what_is_no_key_is_refused(void)
{
    static const char one_more[] = DIGITS "0";
    static const char two_lines[] = DIGITS "\n\n";
    static const char blank[] = DIGITS " ";
    static const char not_hex[] = "g" DIGITS;
    static const char colon[] =
        "00:10203405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f0";
    static const char *const texts[] = {"",        "\n",  "secret", one_more,
                                        two_lines, blank, not_hex,  colon};
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        unlink(path);
        write_key(texts[i], 0600);
        TEST_ASSERT_FALSE_MESSAGE(exk_key_load(path, &key, why, sizeof why), texts[i]);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why, "64 hexadecimal digits are allowed"),
                                     texts[i]);
    }
}

/* Every mode that gives anyone else anything. */
static void a_key_that_others_may_touch_is_refused(void)
{
    write_key(DIGITS "\n", 0600);
    for (unsigned mode = 0; mode < 0100; mode++) {
        TEST_ASSERT_EQUAL(0, chmod(path, 0600 | mode));
        TEST_ASSERT_EQUAL(mode == 0, exk_key_load(path, &key, why, sizeof why));
    }
    TEST_ASSERT_NOT_NULL(strstr(why, "(mode 0677): run chmod 600 on it"));
}

static void no_file_a_folder_and_a_link_are_refused(void)
{
    char link_path[112];
    TEST_ASSERT_FALSE(exk_key_load(path, &key, why, sizeof why));
    TEST_ASSERT_NOT_NULL(strstr(why, "cannot open the key: No such file or directory"));
    TEST_ASSERT_FALSE(exk_key_load(folder, &key, why, sizeof why));
    TEST_ASSERT_NOT_NULL(strstr(why, "not a regular file"));
    write_key(DIGITS "\n", 0600);
    snprintf(link_path, sizeof link_path, "%s.link", path);
    TEST_ASSERT_EQUAL(0, symlink(path, link_path));
    TEST_ASSERT_FALSE(exk_key_load(link_path, &key, why, sizeof why));
    unlink(link_path);
}

static void a_key_of_another_user_is_refused(void)
{
    if (geteuid() != 0) {
        TEST_IGNORE_MESSAGE("only root can give a file away");
    }
    write_key(DIGITS "\n", 0600);
    TEST_ASSERT_EQUAL(0, chown(path, 12345, (gid_t)-1));
    TEST_ASSERT_FALSE(exk_key_load(path, &key, why, sizeof why));
    TEST_ASSERT_NOT_NULL(strstr(why, "this key belongs to user 12345"));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_new_key_is_private_loads_and_differs_from_the_next);
    RUN_TEST(digits_are_the_bytes);
    RUN_TEST(what_is_no_key_is_refused);
    RUN_TEST(a_key_that_others_may_touch_is_refused);
    RUN_TEST(no_file_a_folder_and_a_link_are_refused);
    RUN_TEST(a_key_of_another_user_is_refused);
    return UNITY_END();
}
