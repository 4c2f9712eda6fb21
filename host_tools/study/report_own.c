#include "report_own.h"

#include <math.h>
#include <string.h>

#include "compare.h"
#include "report_draw.h"
#include "report_tables.h"

enum { OWN_H = 300 };

/* Below this an error is rounding, not an error; the drawing's axis ends there. */
static const double smallest_mm = 1e-6;

static const struct {
    const char *name;
    const char *title;
} noises[STUDY_N_NOISES] = {{"white", "white noise (zero order)"},
                            {"first_order", "random walk (first order)"},
                            {"second_order", "second-order noise"}};

/* Of one noise: the rows of the JSON, one a controller. */
typedef struct {
    const json_t *frozen[STUDY_N_CONTROLLERS];
    const json_t *fresh[STUDY_N_CONTROLLERS];
} own_rows;

static const json_t *find(const json_t *list, const char *noise, const char *repeat,
                          const char *controller)
{
    size_t i = 0;
    const json_t *row = NULL;
    json_array_foreach(list, i, row)
    {
        if (strcmp(report_word(row, "noise"), noise) == 0 &&
            strcmp(report_word(row, "repeat"), repeat) == 0 &&
            strcmp(report_word(row, "controller"), controller) == 0) {
            return row;
        }
    }
    return NULL;
}

static own_rows rows_of(const report_page *page, const char *noise)
{
    const json_t *list = json_object_get(page->also->compare, "controllers");
    own_rows rows;
    for (int i = 0; i < STUDY_N_CONTROLLERS; i++) {
        const char *name = study_controller_at(i)->name;
        rows.frozen[i] = find(list, noise, "frozen", name);
        rows.fresh[i] = find(list, noise, "fresh", name);
    }
    return rows;
}

static bool complete(const own_rows *rows)
{
    for (int i = 0; i < STUDY_N_CONTROLLERS; i++) {
        if (rows->frozen[i] == NULL || rows->fresh[i] == NULL) {
            return false;
        }
    }
    return true;
}

static void put_points(FILE *script, const char *block, const json_t *const *rows)
{
    fprintf(script, "$%s << EOD\n", block);
    for (int i = 0; i < STUDY_N_CONTROLLERS; i++) {
        fprintf(script, "%.9g %d \"%s\"\n", fmax(smallest_mm, report_number(rows[i], "rms_mm")),
                i + 1, study_controller_at(i)->word);
    }
    fputs("EOD\n", script);
}

static void draw_rows(FILE *script, const void *ctx)
{
    const own_rows *rows = ctx;
    const double floor_mm = report_number(rows->fresh[0], "floor_rms_mm");
    report_draw_style(script, "rms path error, mm", "");
    put_points(script, "frozen", rows->frozen);
    put_points(script, "fresh", rows->fresh);
    fprintf(
        script,
        "unset ylabel\nset lmargin 28\nset rmargin 3\nset logscale x\n"
        "set xrange [%g:2]\nset yrange [%d.6:0.4]\nset ytics scale 0 textcolor " INK "\n"
        "set xtics ('≤ 10⁻⁶' 1e-6, '10⁻⁴' 1e-4, '0.01' 0.01, '1' 1)\n"
        "set arrow from first %.9g,graph 0 to first %.9g,graph 1 nohead lw 2 dt (6,4) lc " INK
        " back\n"
        "plot $frozen using 1:2:ytic(3) with points pt 13 ps 1.5*mark_size lc " BLUE
        ", $fresh using 1:2 with points pt 6 lw 2 ps 2.4*mark_size lc " ORANGE "\n",
        smallest_mm, STUDY_N_CONTROLLERS, floor_mm, floor_mm);
}

static void put_figure(report_page *page, const own_rows *rows)
{
    report_figure(page, "fig-own", "Controllers on frozen and on fresh noise");
    for (int i = 0; i < STUDY_N_NOISES; i++) {
        char desc[192];
        snprintf(desc, sizeof desc,
                 "Rms path error of %d controllers on %s, on frozen and on fresh noise; floor "
                 "%.3g mm.",
                 STUDY_N_CONTROLLERS, noises[i].title,
                 report_number(rows[i].fresh[0], "floor_rms_mm"));
        report_panel(page, noises[i].title, desc, REPORT_PANEL_W, OWN_H, draw_rows, &rows[i]);
    }
    report_legend(page);
    report_legend_item(page, REPORT_DIAMOND, "blue", "frozen noise");
    report_legend_item(page, REPORT_RING, "orange", "fresh noise");
    report_legend_item(page, REPORT_DASHED, "ink", "floor on fresh noise");
    report_caption(page);
    fprintf(
        page->out,
        "Rectangle of S5; rms of the radial error over the whole path, of the last run of a "
        "series, n = %.0f series, seed %llu. Learning: run %.0f after %.0f updates.",
        report_number(page->also->compare, "seeds"),
        (unsigned long long)page->paper->profiles[STUDY_S5].timing.seed,
        report_number(page->also->compare, "updates") + 1.0,
        report_number(page->also->compare, "updates"));
    report_figure_end(page);
}

/* What is left of frozen noise after learning all of it is rounding. */
static void put_mm(report_page *page, double value_mm)
{
    if (value_mm > 0.0 && value_mm < 1e-9) {
        fputs("<td class=\"n\">&lt; 1e-9</td>", page->out);
    } else {
        report_cell_number(page, REPORT_DIGITS(4), value_mm);
    }
}

static void put_row(report_page *page, const own_rows *rows, int i)
{
    const json_t *fresh = rows->fresh[i], *frozen = rows->frozen[i];
    report_row_head(page, study_controller_at(i)->word);
    report_cell_number(page, REPORT_DIGITS(4), report_number(fresh, "rms_mm"));
    report_cell_interval(page, REPORT_DIGITS(4), report_end(fresh, "rms_ci95", 0),
                         report_end(fresh, "rms_ci95", 1));
    report_cell_number(page, REPORT_DIGITS(4), report_number(fresh, "floor_rms_mm"));
    report_cell_number(page, REPORT_DIGITS(4), report_number(fresh, "rms_over_floor"));
    report_cell_number(page, REPORT_DIGITS(4), report_number(fresh, "theory_rms_mm"));
    report_cell_number(page, REPORT_DIGITS(4), report_number(fresh, "last_point_mm"));
    put_mm(page, report_number(frozen, "rms_mm"));
    put_mm(page, report_number(frozen, "theory_rms_mm"));
    put_mm(page, report_number(frozen, "last_point_mm"));
    report_row_end(page);
}

static void put_table(report_page *page, const char *title, const own_rows *rows)
{
    static const char *const heads[] = {
        "Controller", "Fresh: rms, mm", "95 % of it",      "Floor, mm",  "rms / floor",
        "Theory, mm", "Last point, mm", "Frozen: rms, mm", "Theory, mm", "Last point, mm",
        NULL};
    report_table(page, title, heads);
    for (int i = 0; i < STUDY_N_CONTROLLERS; i++) {
        put_row(page, rows, i);
    }
    report_table_end(page);
}

void report_own(report_page *page)
{
    own_rows rows[STUDY_N_NOISES];
    fputs(
        "<p>The study replays the same noise in every run of a learning series. A machine does "
        "not: its noise is new each time, and learning can only remove what repeats. Here the "
        "same controllers meet both, beside the floor that no controller with one step of "
        "delay "
        "goes below on fresh noise. Theory is what each law should give, computed from its "
        "impulse response and not from these runs.</p>\n",
        page->out);
    for (int i = 0; i < STUDY_N_NOISES; i++) {
        rows[i] = rows_of(page, noises[i].name);
        if (!complete(&rows[i])) {
            report_fail(page, STUDY_INPUT,
                        "the comparison lacks a controller that this version knows: run "
                        "exk-study compare --json again");
            return;
        }
    }
    put_figure(page, rows);
    for (int i = 0; i < STUDY_N_NOISES; i++) {
        put_table(page, noises[i].title, &rows[i]);
    }
}

static void put_verdict(report_page *page, const json_t *verdict)
{
    const bool inside = json_is_true(json_object_get(verdict, "inside"));
    fprintf(page->out, "<td class=\"n %s\">%s %.3f to %.3f</td>", inside ? "good" : "bad",
            inside ? "✓" : "✗", report_end(verdict, "prediction95", 0),
            report_end(verdict, "prediction95", 1));
}

static void put_choice(report_page *page, const json_t *row)
{
    static const char *const ids[] = {"S7_min", "S7_max",  "S8_min",
                                      "S8_max", "S9_rate", "S9_mean"};
    const json_t *verdicts = json_object_get(row, "verdicts");
    char head[32];
    snprintf(head, sizeof head, "%.2f", report_number(row, "ilc_gain"));
    report_row_head(page, head);
    report_cell_number(page, 1, report_number(row, "dwell_s"));
    report_cell_number(page, 0, report_number(row, "feed_mmps"));
    report_cell(page, report_word(row, "model"));
    report_cell_number(page, 0, report_number(row, "s9_order"));
    report_cell_number(page, 0, report_number(row, "n_inside_of_8"));
    for (size_t i = 0; i < sizeof ids / sizeof ids[0]; i++) {
        put_verdict(page, json_object_get(verdicts, ids[i]));
    }
    report_cell_number(page, REPORT_DIGITS(3), report_number(row, "first_order_intensity"));
    report_cell_number(page, REPORT_DIGITS(3), report_number(row, "zero_order_sigma"));
    report_row_end(page);
}

void report_sensitivity(report_page *page)
{
    static const char *const heads[] = {"K",
                                        "Dwell, s",
                                        "Feed, mm/s",
                                        "Model",
                                        "Order of S9",
                                        "Inside of 8",
                                        "S7_min",
                                        "S7_max",
                                        "S8_min",
                                        "S8_max",
                                        "S9_rate",
                                        "S9_mean",
                                        "First order, rad/√s",
                                        "Zero order, rad",
                                        NULL};
    char caption[192];
    size_t i = 0;
    const json_t *row = NULL;
    if (page->also->sensitivity == NULL) {
        return;
    }
    snprintf(caption, sizeof caption,
             "How the verdicts depend on what the study does not give: 95 %% of one study over "
             "%.0f seeds, each choice fitted again",
             report_number(page->also->sensitivity, "seeds"));
    report_table(page, caption, heads);
    json_array_foreach(json_object_get(page->also->sensitivity, "sensitivity"), i, row)
    {
        put_choice(page, row);
    }
    report_table_end(page);
}
