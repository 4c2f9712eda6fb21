#include "report_page.h"

#include <math.h>
#include <string.h>

void report_fail(report_page *page, int code, const char *why)
{
    if (page->code == STUDY_GOOD && code != STUDY_GOOD) {
        page->code = code;
        snprintf(page->why, sizeof page->why, "%s", why);
    }
}

bool report_ran(const report_page *page, study_part part)
{
    return (page->paper->parts & 1U << part) != 0;
}

void report_scale(report_page *page, double enlarged)
{
    if (enlarged > 1.0) {
        fprintf(page->out, " Errors are drawn %g times as large as they are.", enlarged);
    } else {
        fputs(" Errors are drawn to scale.", page->out);
    }
}

void report_escaped(report_page *page, const char *text)
{
    report_escape(page->out, text);
}

void report_section(report_page *page, const char *id, const char *title)
{
    fprintf(page->out, "<section id=\"%s\" aria-labelledby=\"%s-h\">\n<h2 id=\"%s-h\">", id, id,
            id);
    report_escaped(page, title);
    fputs("</h2>\n", page->out);
}

void report_section_end(report_page *page)
{
    fputs("</section>\n", page->out);
}

void report_figure(report_page *page, const char *id, const char *title)
{
    page->figure = id;
    page->n_panels = 0;
    page->n_figures++;
    fprintf(page->out, "<figure id=\"%s\">\n<h3><a href=\"#%s\">Figure %d</a> ", id, id,
            page->n_figures);
    report_escaped(page, title);
    fputs("</h3>\n<div class=\"panels\">\n", page->out);
}

void report_panel(report_page *page, const char *title, const char *desc, int width, int height,
                  exk_draw_fn draw, const void *ctx)
{
    char id[64];
    char why[sizeof page->why];
    snprintf(id, sizeof id, "%s-%d", page->figure, ++page->n_panels);
    const report_drawing drawing = {id, title, desc, width, height, draw, ctx};
    if (page->code != STUDY_GOOD) {
        return;
    }
    fputs("<div class=\"panel\"><p class=\"name\" aria-hidden=\"true\">", page->out);
    report_escaped(page, title);
    fputs("</p>\n", page->out);
    report_fail(page, report_svg(page->out, page->path, &drawing, why, sizeof why), why);
    fputs("</div>\n", page->out);
}

void report_legend(report_page *page)
{
    fputs("</div>\n<ul class=\"legend\">\n", page->out);
}

static const char *const marks[] = {
    [REPORT_LINE] = "<path d=\"M0 6H24\" stroke-width=\"2.5\"/>",
    [REPORT_DASHED] = "<path d=\"M0 6H24\" stroke-width=\"2\" stroke-dasharray=\"5 3\"/>",
    [REPORT_DOT] = "<circle cx=\"12\" cy=\"6\" r=\"4\" fill=\"currentColor\"/>",
    [REPORT_RING] = "<circle cx=\"12\" cy=\"6\" r=\"4.5\" stroke-width=\"1.5\"/>",
    [REPORT_CROSS] = "<path d=\"M8 2l8 8M16 2l-8 8\" stroke-width=\"2.5\"/>",
    [REPORT_BAND] = "<rect width=\"24\" height=\"12\" stroke=\"none\" fill=\"currentColor\" "
                    "opacity=\"0.25\"/>",
    [REPORT_DIAMOND] = "<path d=\"M12 1l5 5-5 5-5-5z\" fill=\"currentColor\"/>",
    [REPORT_SPREAD] = "<path d=\"M2 6H22M2 3v6M22 3v6\" stroke-width=\"1.8\"/>"
                      "<circle cx=\"12\" cy=\"6\" r=\"3.5\" fill=\"currentColor\"/>",
    [REPORT_TRIANGLE] = "<path d=\"M12 1l5 9h-10z\" fill=\"currentColor\"/>",
};

void report_legend_item(report_page *page, report_mark mark, const char *colour,
                        const char *words)
{
    fprintf(page->out,
            "<li><svg class=\"mark\" width=\"24\" height=\"12\" viewBox=\"0 0 24 12\" "
            "style=\"color:var(--%s)\" fill=\"none\" stroke=\"currentColor\" "
            "aria-hidden=\"true\">%s</svg>",
            colour, marks[mark]);
    report_escaped(page, words);
    fputs("</li>\n", page->out);
}

void report_caption(report_page *page)
{
    fputs("</ul>\n<figcaption>", page->out);
}

void report_figure_end(report_page *page)
{
    fputs("</figcaption>\n</figure>\n", page->out);
}

void report_table(report_page *page, const char *caption, const char *const heads[])
{
    page->n_tables++;
    fprintf(page->out,
            "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-labelledby=\"table-%d\">"
            "<table>\n<caption id=\"table-%d\"><b>Table %d</b> ",
            page->n_tables, page->n_tables, page->n_tables);
    report_escaped(page, caption);
    fputs("</caption>\n<thead><tr>", page->out);
    for (; *heads != NULL; heads++) {
        fputs("<th scope=\"col\">", page->out);
        report_escaped(page, *heads);
        fputs("</th>", page->out);
    }
    fputs("</tr></thead>\n<tbody>\n", page->out);
}

void report_table_end(report_page *page)
{
    fputs("</tbody></table></div>\n", page->out);
}

void report_row_head(report_page *page, const char *text)
{
    fputs("<tr><th scope=\"row\">", page->out);
    report_escaped(page, text);
    fputs("</th>", page->out);
}

/* A long text keeps some width where the table is narrow. */
void report_cell(report_page *page, const char *text)
{
    fputs(strlen(text) > 40 ? "<td class=\"w\">" : "<td>", page->out);
    report_escaped(page, text);
    fputs("</td>", page->out);
}

static void put_number(report_page *page, int decimals, double value)
{
    if (!isfinite(value)) {
        fputs("n/a", page->out);
    } else if (decimals < 0) {
        fprintf(page->out, "%.*g", -decimals, value);
    } else {
        fprintf(page->out, "%.*f", decimals, value);
    }
}

void report_cell_number(report_page *page, int decimals, double value)
{
    fputs("<td class=\"n\">", page->out);
    put_number(page, decimals, value);
    fputs("</td>", page->out);
}

void report_cell_interval(report_page *page, int decimals, double low, double high)
{
    fputs("<td class=\"n\">", page->out);
    put_number(page, decimals, low);
    fputs(" to ", page->out);
    put_number(page, decimals, high);
    fputs("</td>", page->out);
}

void report_cell_verdict(report_page *page, bool good, const char *words)
{
    fprintf(page->out, "<td class=\"%s\">%s ", good ? "good" : "bad", good ? "✓" : "✗");
    report_escaped(page, words);
    fputs("</td>", page->out);
}

void report_row_end(report_page *page)
{
    fputs("</tr>\n", page->out);
}

double report_number(const json_t *object, const char *key)
{
    const json_t *value = json_object_get(object, key);
    return json_is_number(value) ? json_number_value(value) : NAN;
}

double report_end(const json_t *object, const char *key, size_t end)
{
    const json_t *value = json_array_get(json_object_get(object, key), end);
    return json_is_number(value) ? json_number_value(value) : NAN;
}

const char *report_word(const json_t *object, const char *key)
{
    const char *text = json_string_value(json_object_get(object, key));
    return text != NULL ? text : "";
}
