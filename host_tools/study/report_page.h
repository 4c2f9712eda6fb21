/** The page while it is written: sections, figures, tables; and what the parts of it draw from.
 *
 *  Errors   the first failure is kept in code and why; later drawings are skipped, and the caller
 *           throws the page away.
 */
#ifndef STUDY_REPORT_PAGE_H
#define STUDY_REPORT_PAGE_H

#include <stdint.h>

#include "report.h"
#include "report_svg.h"
#include "result.h"

typedef struct {
    FILE *out;
    const char *path; /* as the user named it */
    int code;
    char why[512];
    const study_paper *paper;
    const study_tally *tallies;
    const json_t *result;
    const study_also *also;
    int n_figures;
    int n_tables;
    const char *figure; /* id of the open one */
    int n_panels;       /* in it */
} report_page;

void report_fail(report_page *page, int code, const char *why);

void report_section(report_page *page, const char *id, const char *title);
void report_section_end(report_page *page);

void report_figure(report_page *page, const char *id, const char *title);

/** title above the drawing, which also names it; desc says what it shows. */
void report_panel(report_page *page, const char *title, const char *desc, int width, int height,
                  exk_draw_fn draw, const void *ctx);

/** Ends the panels; the legend's items follow. */
void report_legend(report_page *page);

typedef enum {
    REPORT_LINE,
    REPORT_DASHED,
    REPORT_DOT,
    REPORT_RING,
    REPORT_CROSS,
    REPORT_BAND,
    REPORT_TRIANGLE,
    REPORT_DIAMOND,
    REPORT_SPREAD /* a dot with its interval */
} report_mark;

/** colour: a CSS variable's name, as "blue". */
void report_legend_item(report_page *page, report_mark mark, const char *colour,
                        const char *words);

/** Ends the legend; the caption's text follows, then report_figure_end. */
void report_caption(report_page *page);
void report_figure_end(report_page *page);

/** A table in a box of its own that scrolls where the page is narrow. heads: NULL-terminated. */
void report_table(report_page *page, const char *caption, const char *const heads[]);
void report_table_end(report_page *page);

/* Cells: the first of a row is its head; numbers to the right, with that many decimals, or with
 * REPORT_DIGITS(n) of n significant digits. */
#define REPORT_DIGITS(n) (-(n))

void report_row_head(report_page *page, const char *text);
void report_cell(report_page *page, const char *text);
void report_cell_number(report_page *page, int decimals, double value);
void report_cell_interval(report_page *page, int decimals, double low, double high);
void report_row_end(report_page *page);

/** A verdict in words with a sign of another shape. */
void report_cell_verdict(report_page *page, bool good, const char *words);

/** Whether an experiment was run; figures of one that was left out are left out too. */
bool report_ran(const report_page *page, study_part part);

/** A sentence of a caption: errors are drawn so many times as large, or to scale. */
void report_scale(report_page *page, double enlarged);

void report_escaped(report_page *page, const char *text);

/* Of the result: NaN and "" where a key is missing. */
double report_number(const json_t *object, const char *key);
double report_end(const json_t *object, const char *key, size_t end);
const char *report_word(const json_t *object, const char *key);

#endif
