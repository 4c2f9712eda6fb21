/** Pieces of the gnuplot script that both halves of the picture use. */
#ifndef EXK_HOLES_PICTURE_DRAW_H
#define EXK_HOLES_PICTURE_DRAW_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "picture_layout.h"

#define INSIDE_COLOUR "#0072B2"
#define OUTSIDE_COLOUR "#D55E00"
#define NONE_COLOUR "#666666"
#define CIRCLE_COLOUR "#8a8a8a"
#define TEXT_COLOUR "#222222"

typedef struct {
    const hole_report *report;
    picture_layout layout;
} picture;

typedef enum { MARK_INSIDE, MARK_OUTSIDE, MARK_NONE, MARK_COUNT } mark;

typedef struct {
    const char *style;
    const char *colour;
    const char *words;
} picture_mark;

extern const picture_mark picture_marks[MARK_COUNT];

double picture_mm(double metres);

size_t picture_count(const hole_report *report, mark which);

/** A line of text at pixels of the picture. */
void picture_put_text(FILE *out, double x, double y, const char *style, const char *text);

void picture_set_view(FILE *out, const picture_view *view);

/** Data of one kind of mark as block $data<mark>: x, y, dx, dy in mm, of one map or of all holes
 *  (part -1). False when there is none. */
bool picture_put_block(FILE *out, const picture *p, mark which, int part);

/** Label of the worst hole, on the map it is on, or in the circle (part -1). */
void picture_put_worst(FILE *out, const picture *p, int part);

/** The right half: all holes in one circle, figures, published figures. */
void picture_put_target(FILE *out, const picture *p);

#endif
