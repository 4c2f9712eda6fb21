#include <math.h>
#include <string.h>

#include "report_draw.h"
#include "report_svg.h"
#include "unity.h"

enum { PAGE_MAX = 200000 };

static char text[PAGE_MAX];
static char why[512];
static FILE *page;

void setUp(void)
{
    why[0] = '\0';
    page = tmpfile();
    TEST_ASSERT_NOT_NULL(page);
}

void tearDown(void)
{
    fclose(page);
}

static void draw_words(FILE *script, const void *ctx)
{
    fputs(ctx, script);
}

static int draw(const char *script)
{
    const report_drawing drawing = {"fig-x-1", "A <title>", "What & why", 420,
                                    315,       draw_words,  script};
    const int code = report_svg(page, "page.html", &drawing, why, sizeof why);
    rewind(page);
    const size_t n = fread(text, 1, sizeof text - 1, page);
    text[n] = '\0';
    return code;
}

static void a_drawing_is_named_and_takes_the_colours_of_the_page(void)
{
    static const struct {
        const char *text;
        bool wanted;
    } rows[] = {
        {"<svg id=\"fig-x-1\" role=\"img\" aria-labelledby=\"fig-x-1-t fig-x-1-d\"", true},
        {"viewBox=\"0 0 420 315\"", true},
        {"<title id=\"fig-x-1-t\">A &lt;title&gt;</title>", true},
        {"<desc id=\"fig-x-1-d\">What &amp; why</desc>", true},
        {"stroke='var(--blue)'", true},
        {"color='var(--bad)'", true},
        {"href='#fig-x-1-mark", true},
        {"rgb(", false},
        {"black", false},
        {"white", false},
        {"xlink", false},
        {"http", false},
        {"gnuplot", false},
        {"font-family", false},
        {"<filter", false},
    };
    TEST_ASSERT_EQUAL_MESSAGE(0,
                              draw("unset key\nset border lc " MUTED "\nset tics tc " INK "\n"
                                   "plot sin(x) lc " BLUE
                                   ", '+' using 1:(0):(0.1) with yerrorbars pt 7 lc " BAD "\n"),
                              why);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        TEST_ASSERT_EQUAL_MESSAGE(rows[i].wanted, strstr(text, rows[i].text) != NULL,
                                  rows[i].text);
    }
}

static void a_failing_drawing_says_why(void)
{
    TEST_ASSERT_EQUAL(3, draw("plot 'no such file'\n"));
    TEST_ASSERT_NOT_NULL(strstr(why, "page.html: gnuplot failed: "));
    TEST_ASSERT_EQUAL(3, draw("set xlabel 'nothing is plotted'\n"));
    TEST_ASSERT_EQUAL_STRING("page.html: gnuplot left the drawing fig-x-1 unfinished", why);
}

static void errors_are_enlarged_in_round_steps(void)
{
    static const struct {
        const char *name;
        double largest, room, want;
    } rows[] = {
        {"too large already", 41.0, 40.0, 1.0},
        {"just fits", 40.0, 40.0, 1.0},
        {"twice", 20.0, 40.0, 2.0},
        {"three times", 13.0, 40.0, 3.0},
        {"300 times", 0.07, 25.0, 300.0},
        {"500 times", 0.05, 25.0, 500.0},
        {"nothing to enlarge", 0.0, 40.0, 1.0},
        {"not a number", NAN, 40.0, 1.0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(
            rows[i].want, report_enlargement(rows[i].largest, rows[i].room), rows[i].name);
    }
}

static void tics_are_few_and_round(void)
{
    static const struct {
        double range;
        int n;
        double want;
    } rows[] = {{372.0, 10, 50.0}, {1050.0, 10, 200.0}, {0.04, 6, 0.01}, {100.0, 10, 10.0}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-12 * rows[i].want, rows[i].want,
                                  report_tic_step(rows[i].range, rows[i].n));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_drawing_is_named_and_takes_the_colours_of_the_page);
    RUN_TEST(a_failing_drawing_says_why);
    RUN_TEST(errors_are_enlarged_in_round_steps);
    RUN_TEST(tics_are_few_and_round);
    return UNITY_END();
}
