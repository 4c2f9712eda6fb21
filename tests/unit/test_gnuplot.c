#define _XOPEN_SOURCE 700
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "gnuplot.h"
#include "unity.h"

static char why[512];

void setUp(void)
{
    why[0] = '\0';
}

void tearDown(void)
{
    remove("exk_plot.svg");
    remove("exk_plot.png");
}

static void draw_words(FILE *script, const void *ctx)
{
    fputs(ctx, script);
}

static int plot(const char *path, const char *script)
{
    return exk_plot_write(path, 400, 300, draw_words, script, why, sizeof why);
}

static size_t head(const char *path, char *out, size_t size)
{
    FILE *f = fopen(path, "rb");
    TEST_ASSERT_NOT_NULL(f);
    const size_t n = fread(out, 1, size - 1, f);
    out[n] = '\0';
    fclose(f);
    return n;
}

static void the_ending_names_the_kind(void)
{
    exk_out_kind kind;
    TEST_ASSERT_TRUE(exk_plot_kind("a/b.svg", &kind));
    TEST_ASSERT_EQUAL(EXK_OUT_SVG, kind);
    TEST_ASSERT_TRUE(exk_plot_kind("B.PNG", &kind));
    TEST_ASSERT_EQUAL(EXK_OUT_PNG, kind);
    static const char *const bad[] = {"a.gif", "a", "", ".svg", "a.svg.gz", "a.png/b"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        TEST_ASSERT_FALSE_MESSAGE(exk_plot_kind(bad[i], &kind), bad[i]);
    }
    TEST_ASSERT_EQUAL(2, plot("exk_plot.gif", "plot sin(x)\n"));
    TEST_ASSERT_EQUAL_STRING("exk_plot.gif: a picture ends in .svg or .png", why);
}

static void both_kinds_are_drawn_and_replaced(void)
{
    char text[2048];
    for (int i = 0; i < 2; i++) {
        TEST_ASSERT_EQUAL_MESSAGE(0, plot("exk_plot.svg", "plot sin(x)\n"), why);
        TEST_ASSERT_EQUAL_MESSAGE(0, plot("exk_plot.png", "plot sin(x)\n"), why);
    }
    head("exk_plot.svg", text, sizeof text);
    TEST_ASSERT_NOT_NULL(strstr(text, "<svg"));
    TEST_ASSERT_TRUE(head("exk_plot.png", text, sizeof text) > 1000);
    TEST_ASSERT_EQUAL(0, memcmp(text, "\x89PNG", 4));
}

static void a_failing_script_leaves_no_picture(void)
{
    TEST_ASSERT_EQUAL(3, plot("exk_plot.svg", "plot 'no such file'\n"));
    TEST_ASSERT_NOT_NULL(strstr(why, "exk_plot.svg: gnuplot failed: "));
    TEST_ASSERT_NOT_EQUAL(0, access("exk_plot.svg", F_OK));
}

static void without_gnuplot_it_says_what_to_install(void)
{
    char old[8192];
    const char *path = getenv("PATH");
    snprintf(old, sizeof old, "%s", path != NULL ? path : "");
    setenv("PATH", "/nowhere", 1);
    const int code = plot("exk_plot.svg", "plot sin(x)\n");
    setenv("PATH", old, 1);
    TEST_ASSERT_EQUAL(3, code);
    TEST_ASSERT_EQUAL_STRING(
        "exk_plot.svg: gnuplot draws the pictures and cannot be started: No such file or "
        "directory: install it (apt-get install gnuplot-nox) or leave the picture out",
        why);
    TEST_ASSERT_NOT_EQUAL(0, access("exk_plot.svg", F_OK));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(the_ending_names_the_kind);
    RUN_TEST(both_kinds_are_drawn_and_replaced);
    RUN_TEST(a_failing_script_leaves_no_picture);
    RUN_TEST(without_gnuplot_it_says_what_to_install);
    return UNITY_END();
}
