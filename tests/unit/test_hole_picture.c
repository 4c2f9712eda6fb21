#define _XOPEN_SOURCE 700
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "picture.h"
#include "picture_layout.h"
#include "unity.h"

enum { MAX_HOLES = 600 };

static exk_hole holes[MAX_HOLES];
static exk_hole_result results[MAX_HOLES];
static exk_run_log run;
static hole_report report;
static picture_layout layout;

void setUp(void)
{
    memset(results, 0, sizeof results);
    exk_run_log_init(&run);
    run.holes = holes;
    strcpy(run.profile_name, "made_up");
    report =
        (hole_report){.log = &run, .source = "made.lcm", .noise = "none", .tolerance_m = 30e-6};
    report.results = results;
    layout = (picture_layout){.ids = NULL};
}

void tearDown(void)
{
    picture_layout_free(&layout);
    remove("exk_holes_test.svg");
    remove("exk_holes_test.png");
}

/* A plain pseudo-random number in -1..1, the same on every host. */
static double wobble(int i)
{
    return sin(12.9898 * i) * cos(78.233 * i);
}

static void judge(size_t i, double dx_m, double dy_m)
{
    exk_hole_result *r = &results[i];
    *r = (exk_hole_result){.drilled = true, .dx_m = dx_m, .dy_m = dy_m};
    r->radial_m = sqrt(dx_m * dx_m + dy_m * dy_m);
    r->inside = r->radial_m <= report.tolerance_m;
}

static void finish(size_t n)
{
    report.accuracy = (exk_accuracy){.worst = -1};
    run.n_holes = report.n_holes = n;
    for (size_t i = 0; i < n; i++) {
        const exk_hole_result *r = &results[i];
        report.accuracy.n_drilled += r->drilled ? 1 : 0;
        report.accuracy.n_inside += r->inside ? 1 : 0;
        if (r->drilled && !(r->radial_m <= report.accuracy.max_m)) {
            report.accuracy.max_m = r->radial_m;
            report.accuracy.worst = (int32_t)i;
        }
    }
}

/* rows x columns over w x h mm, errors of about error_um. */
static void make_grid(int rows, int columns, double w_mm, double h_mm, double error_um)
{
    const int n = rows * columns;
    for (int i = 0; i < n; i++) {
        const double u = columns > 1 ? (double)(i % columns) / (columns - 1) - 0.5 : 0.0;
        const double v = rows > 1 ? (double)(i / columns) / (rows - 1) - 0.5 : 0.0;
        holes[i] = (exk_hole){.id = i + 1,
                              .target_m = {1e-3 * w_mm * u, 1e-3 * h_mm * v, 0.5},
                              .axis = {0, 0, 1}};
        judge((size_t)i, 1e-6 * error_um * wobble(i), 1e-6 * error_um * wobble(i + 1000));
    }
    finish((size_t)n);
}

static bool in_view(const picture_view *view, picture_point p, double margin_mm)
{
    const double w = view->mm_per_px * (view->box.right - view->box.left);
    const double h = view->mm_per_px * (view->box.top - view->box.bottom);
    return p.x_mm - margin_mm >= view->x_mm && p.x_mm + margin_mm <= view->x_mm + w &&
           p.y_mm - margin_mm >= view->y_mm && p.y_mm + margin_mm <= view->y_mm + h;
}

static void everything_is_in_its_view(const char *name)
{
    const double circle = 1e3 * report.tolerance_m * layout.enlarged;
    for (size_t i = 0; i < report.n_holes; i++) {
        const picture_view *view = &layout.map[picture_part(&report, &layout, i)];
        TEST_ASSERT_TRUE_MESSAGE(in_view(view, picture_hole(&report, i), circle), name);
        TEST_ASSERT_TRUE_MESSAGE(in_view(view, picture_tip(&report, &layout, i), 0.0), name);
        const picture_point error = {1e3 * results[i].dx_m, 1e3 * results[i].dy_m};
        TEST_ASSERT_TRUE_MESSAGE(in_view(&layout.target, error, 0.0), name);
    }
}

/* A digit of an id is about 6 px wide and 9 px high on the picture. */
static void ids_do_not_touch(const char *name)
{
    const double px = layout.map[0].mm_per_px;
    for (size_t i = 0; layout.ids != NULL && i < report.n_holes; i++) {
        for (size_t j = 0; j < i; j++) {
            const double digits = (holes[i].id > 99 ? 3 : 2) + (holes[j].id > 99 ? 3 : 2);
            const bool touch =
                fabs(layout.ids[i].x_mm - layout.ids[j].x_mm) < 3.0 * digits * px &&
                fabs(layout.ids[i].y_mm - layout.ids[j].y_mm) < 9.0 * px;
            TEST_ASSERT_FALSE_MESSAGE(touch, name);
        }
    }
}

static const struct {
    const char *name;
    int rows;
    int columns;
    double w_mm;
    double h_mm;
    double error_um;
    int n_maps;
} jobs[] = {
    {"4 at corners", 2, 2, 300, 200, 40, 1}, {"25", 5, 5, 300, 200, 40, 1},
    {"45", 5, 9, 400, 300, 40, 1},           {"120", 10, 12, 440, 320, 40, 1},
    {"one hole", 1, 1, 0, 0, 20, 1},         {"all at one place", 4, 4, 0, 0, 20, 1},
    {"no error", 5, 5, 300, 200, 0, 1},      {"far off", 5, 5, 300, 200, 5000, 1},
    {"a long strip", 2, 60, 480, 40, 40, 2}, {"a high strip", 60, 2, 40, 480, 40, 3},
    {"a line", 1, 40, 500, 0, 40, 3},        {"600 holes", 20, 30, 400, 300, 40, 1},
};

static void every_job_fits(void)
{
    for (size_t i = 0; i < sizeof jobs / sizeof jobs[0]; i++) {
        make_grid(jobs[i].rows, jobs[i].columns, jobs[i].w_mm, jobs[i].h_mm, jobs[i].error_um);
        picture_layout_make(&report, &layout);
        TEST_ASSERT_EQUAL_MESSAGE(jobs[i].n_maps, layout.n_maps, jobs[i].name);
        TEST_ASSERT_TRUE_MESSAGE(layout.enlarged > 0.0 && isfinite(layout.enlarged),
                                 jobs[i].name);
        for (int part = 1; part < layout.n_maps; part++) {
            TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-12, layout.map[0].mm_per_px,
                                              layout.map[part].mm_per_px, jobs[i].name);
        }
        everything_is_in_its_view(jobs[i].name);
        ids_do_not_touch(jobs[i].name);
        picture_layout_free(&layout);
    }
}

/* 4, 25, 45 and 120 holes with errors about the tolerance: circles of at least 8 px radius. */
static void circles_can_be_seen(void)
{
    for (size_t i = 0; i < 4; i++) {
        make_grid(jobs[i].rows, jobs[i].columns, jobs[i].w_mm, jobs[i].h_mm, jobs[i].error_um);
        picture_layout_make(&report, &layout);
        const double px = 1e3 * report.tolerance_m * layout.enlarged / layout.map[0].mm_per_px;
        TEST_ASSERT_TRUE_MESSAGE(px >= 8.0, jobs[i].name);
        picture_layout_free(&layout);
    }
}

static void the_label_of_the_worst_hole_covers_no_point(void)
{
    for (size_t i = 0; i < 4; i++) {
        make_grid(jobs[i].rows, jobs[i].columns, jobs[i].w_mm, jobs[i].h_mm, jobs[i].error_um);
        picture_layout_make(&report, &layout);
        const double px = layout.map[0].mm_per_px;
        const picture_label label = picture_worst_place(&report, &layout, true, 190.0, 20.0);
        for (size_t j = 0; j < report.n_holes; j++) {
            const picture_point tip = picture_tip(&report, &layout, j);
            const bool covered = fabs(tip.x_mm - label.centre.x_mm) < 95.0 * px &&
                                 fabs(tip.y_mm - label.centre.y_mm) < 10.0 * px;
            TEST_ASSERT_FALSE_MESSAGE(covered, jobs[i].name);
        }
        picture_layout_free(&layout);
    }
}

static void put_picture(const char *path)
{
    char why[512] = "";
    TEST_ASSERT_EQUAL_MESSAGE(0, hole_picture_write(&report, path, why, sizeof why), why);
}

static bool picture_says(const char *words)
{
    static char text[1 << 23];
    FILE *f = fopen("exk_holes_test.svg", "rb");
    TEST_ASSERT_NOT_NULL(f);
    text[fread(text, 1, sizeof text - 1, f)] = '\0';
    fclose(f);
    return strstr(text, words) != NULL;
}

/* Marks right on their small circles: the id stands beside them, not on them, and is not left out. */
static void a_hole_alone_has_its_id(void)
{
    make_grid(2, 2, 300, 200, 40);
    judge(0, 5e-3, 5e-3);
    judge(1, 20e-6, 0.0);
    judge(2, 0.0, 60e-6);
    judge(3, -150e-6, 100e-6);
    finish(4);
    picture_layout_make(&report, &layout);
    for (size_t i = 0; i < 4; i++) {
        TEST_ASSERT_TRUE(isfinite(layout.ids[i].x_mm) && isfinite(layout.ids[i].y_mm));
    }
}

static void holes_without_a_position_are_marked_as_such(void)
{
    make_grid(2, 3, 300, 200, 40);
    results[1] = (exk_hole_result){.drilled = false};
    results[2].dx_m = results[2].radial_m = NAN;
    results[2].inside = false;
    finish(6);
    report.accuracy.worst = 2; /* as the judge has it: NaN is the worst */
    put_picture("exk_holes_test.svg");
    TEST_ASSERT_TRUE(picture_says("no drilled position (2)"));
    for (size_t i = 0; i < 6; i++) {
        results[i] = (exk_hole_result){.drilled = false};
    }
    finish(6);
    put_picture("exk_holes_test.svg");
    TEST_ASSERT_TRUE(picture_says("no drilled position (6)"));
    put_picture("exk_holes_test.png");
}

static void lost_samples_are_said_in_the_picture(void)
{
    make_grid(2, 2, 300, 200, 40);
    report.n_lost = 12;
    put_picture("exk_holes_test.svg");
    TEST_ASSERT_TRUE(picture_says("12 samples lost: figures are not evidence"));
}

/* On a dense job not every id has room: the key says how many are left out, and nothing where all stand. */
static void ids_left_out_are_counted(void)
{
    char words[64];
    size_t n = 0;
    make_grid(18, 22, 300, 200, 60);
    picture_layout_make(&report, &layout);
    TEST_ASSERT_NOT_NULL(layout.ids);
    for (size_t i = 0; i < report.n_holes; i++) {
        n += isnan(layout.ids[i].x_mm) ? 1 : 0;
    }
    TEST_ASSERT_GREATER_THAN_UINT64(1, n);
    snprintf(words, sizeof words, "%zu ids without room", n);
    put_picture("exk_holes_test.svg");
    TEST_ASSERT_TRUE_MESSAGE(picture_says(words), words);
    make_grid(20, 30, 300, 200, 40);
    put_picture("exk_holes_test.svg");
    TEST_ASSERT_TRUE(picture_says("600 ids without room"));
    make_grid(2, 2, 300, 200, 40);
    put_picture("exk_holes_test.svg");
    TEST_ASSERT_FALSE(picture_says("without room"));
}

/* A name comes from a log, so from anyone: it may not become part of the script. */
static void a_name_is_never_run(void)
{
    make_grid(2, 2, 300, 200, 40);
    strcpy(run.profile_name, "a'; system('touch exk_owned'); `touch exk_owned` \"b\n");
    put_picture("exk_holes_test.svg");
    TEST_ASSERT_NOT_EQUAL(0, access("exk_owned", F_OK));
    TEST_ASSERT_TRUE(picture_says("a?; system(?touch exk_owned?); ?touch exk_owned? "));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(every_job_fits);
    RUN_TEST(circles_can_be_seen);
    RUN_TEST(the_label_of_the_worst_hole_covers_no_point);
    RUN_TEST(a_hole_alone_has_its_id);
    RUN_TEST(ids_left_out_are_counted);
    RUN_TEST(holes_without_a_position_are_marked_as_such);
    RUN_TEST(lost_samples_are_said_in_the_picture);
    RUN_TEST(a_name_is_never_run);
    return UNITY_END();
}
