/** A table of numbers on a stream: CSV with a header, columns found by name.
 *
 *  Format  one record a line, commas, a cell may stand in double quotes ("" is one quote);
 *          blank lines and lines that begin with # are passed over; CRLF and a byte order mark
 *          are taken off. Columns may come in any order, and others may stand among them.
 *  Errors  exit codes: 2 (bad header, bad row, not a number), 3 (cannot be read); why names line,
 *          column, what was found and what is needed.
 *  Memory  close frees; cells point into the line read last.
 */
#ifndef EXK_TOOLS_CSV_IN_H
#define EXK_TOOLS_CSV_IN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { EXK_CSV_COLUMNS_MAX = 256, EXK_CSV_WANTED_MAX = 16 };

typedef struct {
    FILE *file;
    const char *shown; /* "standard input", for messages */
    long line;         /* number of the line read last, from 1 */
    char *text;
    size_t capacity;
    char *cells[EXK_CSV_COLUMNS_MAX];
    size_t n_cells;
    size_t n_columns; /* of the header */
    const char *const *wanted;
    size_t n_wanted;
    size_t column_of[EXK_CSV_WANTED_MAX];
} exk_csv_in;

/** Reads the header and finds the wanted columns; wanted must outlive csv. 0, 2 or 3. */
int exk_csv_open(exk_csv_in *csv, FILE *file, const char *shown, const char *const *wanted,
                 size_t n_wanted, char *why, size_t why_size);

/** Reads the next row into values[n_wanted]; *more is false at the end. An empty cell is NaN:
 *  a value that an earlier tool could not give. 0, 2 or 3. */
int exk_csv_next(exk_csv_in *csv, double *values, bool *more, char *why, size_t why_size);

void exk_csv_close(exk_csv_in *csv);

#endif
