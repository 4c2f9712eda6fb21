#include "report.h"

#include <inttypes.h>
#include <stdio.h>

#include "exk/version.h"
#include "out_file.h"
#include "report_figures.h"
#include "report_own.h"
#include "report_page.h"
#include "report_style.h"
#include "report_tables.h"

static const char begins[] = "<!DOCTYPE html>\n<!-- exk-study report -->\n";

static const struct {
    const char *id;
    const char *title;
} contents[] = {
    {"verdict", "Verdict"},        {"words", "Claims in words"}, {"paths", "Noise on the path"},
    {"learning", "Learning"},      {"holes", "Holes"},           {"spread", "Distributions"},
    {"fitted", "What was fitted"}, {"own", "Beyond the study"},  {"repeat", "Repeat it"},
};

enum { VERDICT, WORDS, PATHS, LEARNING, HOLES, SPREAD, FITTED, OWN, REPEAT };

static void section(report_page *page, int which)
{
    report_section(page, contents[which].id, contents[which].title);
}

static void put_head(report_page *page)
{
    fprintf(page->out,
            "%s<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
            "content=\"width=device-width, initial-scale=1\">\n<meta name=\"generator\" "
            "content=\"exk-study %s\">\n<title>The Exechon drilling study, run again</title>\n",
            begins, EXK_VERSION);
    report_style(page->out);
    fputs("</head>\n<body>\n", page->out);
}

static void put_contents(report_page *page)
{
    fputs("<nav aria-label=\"Contents\"><ol>\n", page->out);
    for (size_t i = 0; i < sizeof contents / sizeof contents[0]; i++) {
        fprintf(page->out, "<li><a href=\"#%s\">%s</a></li>\n", contents[i].id,
                contents[i].title);
    }
    fputs("</ol></nav>\n", page->out);
}

static void put_title(report_page *page)
{
    fprintf(
        page->out,
        "<header>\n<h1>The Exechon drilling study, run again</h1>\n"
        "<p class=\"lede\">“Using Kinematic Models to Improve the Performance of Wing Root "
        "Drilling Processes” models a parallel kinematic drilling machine by two angles, "
        "disturbs them with noise, corrects them by iterative learning (ILC) or PI control and "
        "judges the drilled holes. This page repeats its experiments over %" JSON_INTEGER_FORMAT
        " seeds and sets every printed figure and every claim beside what came out, with "
        "intervals. All lengths are radial errors in mm unless another unit is given.</p>\n",
        json_integer_value(json_object_get(page->result, "seeds")));
    put_contents(page);
    fputs("</header>\n<main>\n", page->out);
}

static void put_tile(report_page *page, const char *words, size_t n, size_t of)
{
    fprintf(page->out, "<div><dt>%s</dt><dd>%zu of %zu</dd></div>\n", words, n, of);
}

static void put_verdict(report_page *page)
{
    const json_t *claims = json_object_get(page->result, "claims");
    const json_t *words = json_object_get(page->result, "words");
    size_t of_predicted = 0, of_fitted = 0, of_words = 0;
    const size_t predicted = report_count(claims, "inside", "predicted", &of_predicted);
    const size_t fitted = report_count(claims, "inside", "fitted", &of_fitted);
    const size_t hold = report_count(words, "holds", NULL, &of_words);
    section(page, VERDICT);
    fputs("<dl class=\"tiles\">\n", page->out);
    put_tile(page, "predicted figures inside our interval", predicted, of_predicted);
    put_tile(page, "fitted figures inside it, as they should be", fitted, of_fitted);
    put_tile(page, "claims in words that hold", hold, of_words);
    fprintf(page->out, "<div><dt>fitted numbers in all</dt><dd>%zu</dd></div>\n</dl>\n",
            json_array_size(json_object_get(page->result, "fitted")));
    fputs(
        "<p>A published figure is <em>inside</em> when what its printed digits stand for "
        "meets the 95&nbsp;% prediction interval: the range in which 95 of 100 studies of the "
        "published size would fall if our model were right. Inside does not prove the model; "
        "outside speaks against it.</p>\n",
        page->out);
    report_overview(page);
    report_claims(page);
    report_section_end(page);
}

static void put_words(report_page *page)
{
    section(page, WORDS);
    fputs("<p>Each sentence of the study became a number with a direction. A claim holds when "
          "its one-sided test gives p below 0.01. With this many trials even a tiny effect is "
          "seen, so read the effect beside the verdict.</p>\n",
          page->out);
    report_words(page);
    report_section_end(page);
}

static void put_paths(report_page *page)
{
    section(page, PATHS);
    fputs("<p>Once round the rectangle with the noise on neither angle, on one of them, on "
          "both. α moves the tool along x, β along y.</p>\n",
          page->out);
    report_paths(page);
    report_section_end(page);
}

static void put_learning(report_page *page)
{
    section(page, LEARNING);
    fputs("<p>The study's law adds a share K of the last error to the next command. It removes "
          "what repeats: here the noise is <em>frozen</em>, the same in every run of a series, "
          "as "
          "falling errors in the study imply.</p>\n",
          page->out);
    report_learning(page);
    report_section_end(page);
}

static void put_holes(report_page *page)
{
    section(page, HOLES);
    fputs(
        "<p>A hole is judged on the last sample before the stroke, against a circle of 0.03 mm "
        "round its target.</p>\n",
        page->out);
    report_grid25(page);
    report_target45(page);
    report_machines(page);
    report_section_end(page);
}

static void put_fitted(report_page *page)
{
    section(page, FITTED);
    fputs("<p>The study leaves out every noise amplitude and gain. Three numbers were fitted, "
          "each to one published figure, by <code>exk-study calibrate</code>, and are stored "
          "in the "
          "profiles; the rest are choices that the profiles state.</p>\n",
          page->out);
    report_fitted(page);
    report_experiments(page);
    report_sensitivity(page);
    report_section_end(page);
}

/* "--only S5,S6" where some experiments were left out. */
static void put_only(report_page *page)
{
    const char *before = " --only ";
    for (int part = 0; part < STUDY_N_PARTS && page->paper->parts != STUDY_ALL_PARTS; part++) {
        if (report_ran(page, (study_part)part)) {
            fprintf(page->out, "%sS%d", before, part + 1);
            before = ",";
        }
    }
}

static void put_commands(report_page *page, json_int_t n)
{
    fprintf(page->out, "<pre><code>exk-study compare --seeds %.0f --json compare.json\n",
            report_number(page->also->compare, "seeds"));
    if (page->also->sensitivity != NULL) {
        fprintf(page->out, "exk-study sensitivity --seeds %.0f --json sensitivity.json\n",
                report_number(page->also->sensitivity, "seeds"));
    }
    fprintf(page->out, "exk-study paper --seeds %" JSON_INTEGER_FORMAT, n);
    put_only(page);
    fprintf(page->out,
            " --json paper.json --csv paper.csv --compare compare.json%s --report paper.html"
            "</code></pre>\n",
            page->also->sensitivity != NULL ? " --sensitivity sensitivity.json" : "");
}

static void put_repeat(report_page *page)
{
    const json_int_t n = json_integer_value(json_object_get(page->result, "seeds"));
    section(page, REPEAT);
    put_commands(page, n);
    fprintf(
        page->out,
        "<p>Made by exk-study %s. Trial i is series i of the counter-based random numbers, i "
        "= 0 to %" JSON_INTEGER_FORMAT ", with the seed that each profile names: any number of "
        "threads, hosts or interruptions gives the same figures. Drawn paths and holes are "
        "those of trial 0; <code>exk-loop --fast</code> on the same profile logs the same run. "
        "Numbers to copy are in paper.json and paper.csv.</p>\n",
        EXK_VERSION, n - 1);
    report_section_end(page);
}

static void put_page(report_page *page)
{
    put_head(page);
    put_title(page);
    put_verdict(page);
    put_words(page);
    put_paths(page);
    put_learning(page);
    put_holes(page);
    section(page, SPREAD);
    report_spread(page);
    report_section_end(page);
    put_fitted(page);
    section(page, OWN);
    report_own(page);
    report_section_end(page);
    put_repeat(page);
    fputs("</main>\n</body>\n</html>\n", page->out);
}

int study_report(const study_paper *paper, const study_sums *totals, const json_t *result,
                 const study_also *also, const char *path)
{
    exk_out out;
    report_page page = {.path = path,
                        .paper = paper,
                        .tallies = totals->tallies,
                        .result = result,
                        .also = also};
    int code = exk_out_open(&out, path, EXK_OUT_TEXT, begins, page.why, sizeof page.why);
    if (code == STUDY_GOOD) {
        page.out = out.file;
        put_page(&page);
        code = page.code;
        if (code == STUDY_GOOD) {
            code = exk_out_commit(&out, page.why, sizeof page.why);
        } else {
            exk_out_abort(&out);
        }
    }
    if (code != STUDY_GOOD && page.why[0] != '\0') {
        fprintf(stderr, "exk-study: %s\n", page.why);
    }
    return code;
}
