/** A result file: written whole or not at all, and never over a file that is not ours.
 *
 *  Write    to a temporary name beside it, then renamed: a crash leaves the old one or the new one.
 *           "-" is standard output; a device or a pipe is written straight into.
 *  Refused  an existing file that does not begin like our kind of result, a folder.
 *  Errors   open and commit return an exit code: 0, 2 (refused), 3 (cannot be written); why says
 *           file, reason and what to do.
 *  Memory   the caller owns the struct; commit or abort ends its use.
 */
#ifndef EXK_TOOLS_OUT_FILE_H
#define EXK_TOOLS_OUT_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { EXK_OUT_PATH_MAX = 4096 };

typedef enum {
    EXK_OUT_TEXT, /* begins with the text that open was given: a CSV header, a JSON's first key */
    EXK_OUT_SVG, /* an SVG that gnuplot made */
    EXK_OUT_PNG  /* any PNG */
} exk_out_kind;

typedef struct {
    FILE *file;
    const char *shown;           /* the name as the user gave it */
    char path[EXK_OUT_PATH_MAX]; /* links followed */
    char temp[EXK_OUT_PATH_MAX]; /* empty: written directly */
} exk_out;

/** begins: for EXK_OUT_TEXT what a file of ours begins with; NULL for the others. */
int exk_out_open(exk_out *out, const char *path, exk_out_kind kind, const char *begins,
                 char *why, size_t why_size);
int exk_out_commit(exk_out *out, char *why, size_t why_size);
void exk_out_abort(exk_out *out);

/** Flushes standard output; 0, or 3 with a message on stderr when it did not arrive. */
int exk_stdout_flush(const char *program);

#endif
