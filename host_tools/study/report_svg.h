/** A gnuplot drawing as part of an HTML page: named, described, in the page's colours and font.
 *
 *  Colours  a script names colours of the page as RGB keys, the macros below; they come out as
 *           CSS variables, so that one drawing serves the light theme, the dark one and paper.
 *  Inline   no XML head, no name spaces, no ids but the markers', prefixed with the drawing's id.
 *  Errors   an exit code; why says which drawing failed and what to do.
 */
#ifndef STUDY_REPORT_SVG_H
#define STUDY_REPORT_SVG_H

#include <stddef.h>

#include "gnuplot.h"

#define INK "rgb '#000001'"
#define MUTED "rgb '#000002'"
#define GRID "rgb '#000003'"
#define PATH "rgb '#000004'" /* the reference: path, target, tolerance */
#define BLUE "rgb '#000005'"
#define ORANGE "rgb '#000006'"
#define GREEN "rgb '#000007'"
#define PURPLE "rgb '#000008'"
#define GOOD "rgb '#000009'"
#define BAD "rgb '#00000a'"

typedef struct {
    const char *id;    /* unique in the page */
    const char *title; /* what it is, for those who do not see it */
    const char *desc;  /* what it shows */
    int width;         /* of the drawing, in CSS pixels before it is fitted to the page */
    int height;
    exk_draw_fn draw;
    const void *ctx;
} report_drawing;

int report_svg(FILE *page, const char *shown, const report_drawing *drawing, char *why,
               size_t why_size);

/** Text with <, >, &, " as entities. */
void report_escape(FILE *page, const char *text);

#endif
