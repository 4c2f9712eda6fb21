/** Pictures by gnuplot, run as a process of its own: SVG or PNG by the ending of the name.
 *
 *  Script   written by the caller's draw function, data in it as blocks ($name << EOD); the
 *           terminal is set before it runs. The user's own gnuplot settings are not read. Marks
 *           sized "ps 0.9*mark_size" and fonts in points look alike in SVG and PNG.
 *  Errors   an exit code: 0, 2 (ending, refused file), 3 (gnuplot missing or failed, cannot write);
 *           why says which and what to do. No half picture is left behind.
 */
#ifndef EXK_TOOLS_GNUPLOT_H
#define EXK_TOOLS_GNUPLOT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "out_file.h"

typedef void (*exk_draw_fn)(FILE *script, const void *ctx);

/** True for .svg and .png; sets the kind. For checking options before any work is done. */
bool exk_plot_kind(const char *path, exk_out_kind *kind);

int exk_plot_write(const char *path, int width, int height, exk_draw_fn draw, const void *ctx,
                   char *why, size_t why_size);

/** SVG into an open file, as a part of a page: no background, no enhanced text. shown names the page in
 *  messages. The file must be one that a process can write (no open_memstream), flushed before. */
int exk_plot_stream(FILE *out, const char *shown, int width, int height, exk_draw_fn draw,
                    const void *ctx, char *why, size_t why_size);

#endif
