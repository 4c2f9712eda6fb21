#define _POSIX_C_SOURCE 200809L

#include "csv_in.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { GOOD = 0, BAD_INPUT = 2, BAD_FILE = 3 };

static const char byte_order_mark[] = "\xEF\xBB\xBF";

/* Takes the white space off both ends, in place. */
static char *trimmed(char *text)
{
    while (isspace((unsigned char)*text)) {
        text++;
    }
    char *end = text + strlen(text);
    while (end > text && isspace((unsigned char)end[-1])) {
        end--;
    }
    *end = '\0';
    return text;
}

/* Unquotes one cell in place; returns where the next begins, or NULL after the last. */
static char *take_cell(char *from, char **cell)
{
    while (*from == ' ' || *from == '\t') {
        from++;
    }
    char *to = from;
    bool quoted = *from == '"';
    *cell = from;
    from += quoted;
    for (; *from != '\0' && (quoted || *from != ','); from++) {
        if (quoted && *from == '"' && from[1] != '"') {
            quoted = false;
            continue;
        }
        from += quoted && *from == '"';
        *to++ = *from;
    }
    char *next = *from == ',' ? from + 1 : NULL;
    *to = '\0';
    *cell = trimmed(*cell);
    return next;
}

static bool split(exk_csv_in *csv, char *text)
{
    csv->n_cells = 0;
    while (text != NULL) {
        if (csv->n_cells == EXK_CSV_COLUMNS_MAX) {
            return false;
        }
        text = take_cell(text, &csv->cells[csv->n_cells++]);
    }
    return true;
}

/* The next line that holds a record, split. */
static int next_record(exk_csv_in *csv, bool *more, char *why, size_t why_size)
{
    errno = 0;
    while (getline(&csv->text, &csv->capacity, csv->file) >= 0) {
        csv->line++;
        char *text = csv->text;
        if (csv->line == 1 && strncmp(text, byte_order_mark, 3) == 0) {
            text += 3;
        }
        text = trimmed(text);
        if (*text == '\0' || *text == '#') {
            continue;
        }
        *more = true;
        if (split(csv, text)) {
            return GOOD;
        }
        snprintf(why, why_size, "%s, line %ld: more than %d columns", csv->shown, csv->line,
                 EXK_CSV_COLUMNS_MAX);
        return BAD_INPUT;
    }
    *more = false;
    if (ferror(csv->file)) {
        snprintf(why, why_size, "%s: cannot be read: %s", csv->shown, strerror(errno));
        return BAD_FILE;
    }
    return GOOD;
}

/* "x_m,y_m,z_m" for a message. */
static void list_columns(const exk_csv_in *csv, char *out, size_t size)
{
    size_t n = 0;
    out[0] = '\0';
    for (size_t i = 0; i < csv->n_wanted && n < size; i++) {
        n += (size_t)snprintf(out + n, size - n, "%s%s", i > 0 ? "," : "", csv->wanted[i]);
    }
}

static int find_column(exk_csv_in *csv, size_t i, char *why, size_t why_size)
{
    size_t n_found = 0;
    for (size_t j = 0; j < csv->n_cells; j++) {
        if (strcmp(csv->cells[j], csv->wanted[i]) == 0) {
            csv->column_of[i] = j;
            n_found++;
        }
    }
    if (n_found == 1) {
        return GOOD;
    }
    char needed[256];
    list_columns(csv, needed, sizeof needed);
    snprintf(why, why_size, "%s, line %ld: column %s %s; needed are %s, in any order",
             csv->shown, csv->line, csv->wanted[i],
             n_found == 0 ? "is missing in the header" : "stands more than once in the header",
             needed);
    return BAD_INPUT;
}

int exk_csv_open(exk_csv_in *csv, FILE *file, const char *shown, const char *const *wanted,
                 size_t n_wanted, char *why, size_t why_size)
{
    *csv = (exk_csv_in){.file = file, .shown = shown, .wanted = wanted, .n_wanted = n_wanted};
    bool more = false;
    int rc = next_record(csv, &more, why, why_size);
    if (rc == GOOD && !more) {
        char needed[256];
        list_columns(csv, needed, sizeof needed);
        snprintf(why, why_size, "%s: no header; a first line %s is needed", shown, needed);
        return BAD_INPUT;
    }
    csv->n_columns = csv->n_cells;
    for (size_t i = 0; rc == GOOD && i < n_wanted; i++) {
        rc = find_column(csv, i, why, why_size);
    }
    return rc;
}

static int take_number(const exk_csv_in *csv, size_t i, double *value, char *why,
                       size_t why_size)
{
    const char *cell = csv->cells[csv->column_of[i]];
    if (*cell == '\0') {
        *value = (double)NAN;
        return GOOD;
    }
    char *end;
    *value = strtod(cell, &end);
    if (*end == '\0') {
        return GOOD;
    }
    snprintf(why, why_size, "%s, line %ld, column %s: '%s' is not a number", csv->shown,
             csv->line, csv->wanted[i], cell);
    return BAD_INPUT;
}

int exk_csv_next(exk_csv_in *csv, double *values, bool *more, char *why, size_t why_size)
{
    int rc = next_record(csv, more, why, why_size);
    if (rc != GOOD || !*more) {
        return rc;
    }
    if (csv->n_cells != csv->n_columns) {
        snprintf(why, why_size, "%s, line %ld: %zu cells, but the header has %zu", csv->shown,
                 csv->line, csv->n_cells, csv->n_columns);
        return BAD_INPUT;
    }
    for (size_t i = 0; rc == GOOD && i < csv->n_wanted; i++) {
        rc = take_number(csv, i, &values[i], why, why_size);
    }
    return rc;
}

void exk_csv_close(exk_csv_in *csv)
{
    free(csv->text);
    csv->text = NULL;
}
