#define _POSIX_C_SOURCE 200809L
#include "report_svg.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Index: blue of the key; red and green are 0. */
static const char *const variables[] = {NULL,     "ink",   "muted",  "grid", "path", "blue",
                                        "orange", "green", "purple", "good", "bad"};

/* What gnuplot writes, and what a page wants there; "@" is the drawing's id. */
static const struct {
    const char *from;
    const char *to;
} rewrites[] = {
    {"xlink:href", "href"},
    {" font-family=\"sans-serif\"", ""},
    {"color=\"black\" ", ""},
    {"stroke=\"black\"", "stroke=\"currentColor\""},
    {"fill=\"black\"", "fill=\"currentColor\""},
    {"color='white'", "color='var(--page)'"}, /* round a mark with an interval */
    {"gpPt", "@-mark"},
    {"gpDot", "@-dot"},
};

void report_escape(FILE *page, const char *text)
{
    for (; *text != '\0'; text++) {
        switch (*text) {
        case '<':
            fputs("&lt;", page);
            break;
        case '>':
            fputs("&gt;", page);
            break;
        case '&':
            fputs("&amp;", page);
            break;
        case '"':
            fputs("&quot;", page);
            break;
        default:
            fputc(*text, page);
        }
    }
}

/* A key colour at text as its variable; how many characters it took, 0: none of ours. */
static size_t put_colour(FILE *page, const char *text)
{
    const size_t n_variables = sizeof variables / sizeof variables[0];
    int red = 0, green = 0, taken = 0;
    unsigned blue = 0;
    if (sscanf(text, "rgb(%d,%d,%u)%n", &red, &green, &blue, &taken) != 3 || taken == 0 ||
        red != 0 || green != 0 || blue == 0 || blue >= n_variables) {
        return 0;
    }
    fprintf(page, "var(--%s)", variables[blue]);
    return (size_t)taken;
}

static size_t put_rewrite(FILE *page, const char *text, const char *id)
{
    for (size_t i = 0; i < sizeof rewrites / sizeof rewrites[0]; i++) {
        const size_t n = strlen(rewrites[i].from);
        if (strncmp(text, rewrites[i].from, n) == 0) {
            const char *to = rewrites[i].to;
            fprintf(page, "%s%s", *to == '@' ? id : "", *to == '@' ? to + 1 : to);
            return n;
        }
    }
    return 0;
}

static void put_line(FILE *page, const char *text, const char *id)
{
    while (*text != '\0') {
        size_t n = put_colour(page, text);
        n = n > 0 ? n : put_rewrite(page, text, id);
        if (n == 0) {
            fputc(*text, page);
            n = 1;
        }
        text += n;
    }
}

static bool begins(const char *line, const char *with)
{
    line += strspn(line, " \t");
    return strncmp(line, with, strlen(with)) == 0;
}

static void put_head(FILE *page, const report_drawing *d)
{
    fprintf(page,
            "<svg id=\"%s\" role=\"img\" aria-labelledby=\"%s-t %s-d\" viewBox=\"0 0 %d %d\" "
            "width=\"%d\" height=\"%d\">\n<title id=\"%s-t\">",
            d->id, d->id, d->id, d->width, d->height, d->width, d->height, d->id);
    report_escape(page, d->title);
    fprintf(page, "</title>\n<desc id=\"%s-d\">", d->id);
    report_escape(page, d->desc);
    fputs("</desc>\n<g>\n", page);
}

typedef struct {
    bool inside;   /* behind gnuplot's head */
    bool filter;   /* in one of its text boxes, which we do not use */
    bool complete; /* its end was seen */
    char *pending; /* an opened group, dropped when closed at once */
} svg_state;

static void flush_pending(FILE *page, svg_state *state, const char *id)
{
    if (state->pending != NULL) {
        put_line(page, state->pending, id);
    }
    free(state->pending);
    state->pending = NULL;
}

static void take_line(FILE *page, svg_state *state, const char *line, const report_drawing *d)
{
    const bool in_filter = state->filter || begins(line, "<filter");
    state->filter = in_filter && !begins(line, "</filter>");
    if (!state->inside) {
        state->inside = begins(line, "<g id=\"gnuplot_canvas\"");
    } else if (in_filter || begins(line, "<rect x=\"0\" y=\"0\"")) {
        return;
    } else if (state->pending != NULL && begins(line, "</g>")) {
        free(state->pending);
        state->pending = NULL;
    } else {
        flush_pending(page, state, d->id);
        if (begins(line, "<g fill=\"none\"")) {
            state->pending = strdup(line);
        } else {
            put_line(page, begins(line, "<g id=\"gnuplot_plot") ? "<g>\n" : line, d->id);
        }
    }
    state->complete = state->complete || begins(line, "</svg>");
}

static bool inline_svg(FILE *page, FILE *svg, const report_drawing *d)
{
    svg_state state = {.inside = false};
    char *line = NULL;
    size_t size = 0;
    rewind(svg);
    put_head(page, d);
    while (getline(&line, &size, svg) >= 0) {
        take_line(page, &state, line, d);
    }
    free(state.pending);
    free(line);
    return state.complete;
}

int report_svg(FILE *page, const char *shown, const report_drawing *drawing, char *why,
               size_t why_size)
{
    FILE *svg = tmpfile();
    if (svg == NULL) {
        snprintf(why, why_size, "%s: no temporary file: %s", shown, strerror(errno));
        return 3;
    }
    int code = exk_plot_stream(svg, shown, drawing->width, drawing->height, drawing->draw,
                               drawing->ctx, why, why_size);
    if (code == 0 && !inline_svg(page, svg, drawing)) {
        snprintf(why, why_size, "%s: gnuplot left the drawing %s unfinished", shown,
                 drawing->id);
        code = 3;
    }
    fclose(svg);
    return code;
}
