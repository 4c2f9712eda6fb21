#include "exk/job_csv.h"

#include <math.h>
#include <string.h>

#include "exk/vec3.h"
#include "faults.h"
#include "number.h"

typedef enum {
    COLUMN_ID,
    COLUMN_X,
    COLUMN_Y,
    COLUMN_Z,
    COLUMN_NX,
    COLUMN_NY,
    COLUMN_NZ
} column;

enum { N_COLUMNS = COLUMN_NZ + 1, CELL_SIZE = 64 };

static const char *const column_names[N_COLUMNS] = {"id", "x_mm", "y_mm", "z_mm",
                                                    "nx", "ny",   "nz"};
static const exk_unit millimetres = {"mm", "mm", -3, false};
static const double shortest_direction = 1e-6;

typedef struct {
    const char *next;
    int line;
    exk_faults faults;
    int place[N_COLUMNS]; /* which cell of a row, -1: not there */
    int n_cells;          /* of the header */
    double plane_z_m;
    exk_hole *holes;
    size_t capacity;
    size_t n_holes;
    bool has_id;              /* of the row being read */
    int lines[EXK_MAX_HOLES]; /* of each hole */
} csv;

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* Moves on to the next line that holds something; false at the end. The line ends at its '\n' or
 * the end of the text. */
static bool next_row(csv *c, const char **row)
{
    while (*c->next != '\0') {
        const char *start = c->next;
        const size_t length = strcspn(start, "\n");
        c->next = start + length + (start[length] == '\n' ? 1 : 0);
        c->line++;
        while (is_blank(*start)) {
            start++;
        }
        if (*start != '\n' && *start != '\0' && *start != '#') {
            *row = start;
            return true;
        }
    }
    return false;
}

/* Copies one cell without the blanks round it; a cell too long for a number is cut. Returns what
 * follows its comma, NULL after the last cell of the row. */
static const char *next_cell(const char *row, char cell[CELL_SIZE])
{
    size_t length = strcspn(row, ",\n");
    const char *rest = row[length] == ',' ? row + length + 1 : NULL;
    while (length > 0 && is_blank(*row)) {
        row++;
        length--;
    }
    while (length > 0 && is_blank(row[length - 1])) {
        length--;
    }
    const size_t kept = length < CELL_SIZE - 1 ? length : CELL_SIZE - 1;
    memcpy(cell, row, kept);
    cell[kept] = '\0';
    return rest;
}

static void say_cell(csv *c, const char *name, const char *what, const char *cell,
                     const char *allowed)
{
    char found[CELL_SIZE];
    exk_text text = exk_text_start(found, sizeof(found));
    exk_text_add_quoted(&text, cell);
    exk_faults_add(&c->faults, c->line, "%s: %s: found %s, allowed: %s", name, what, found,
                   allowed);
}

static void read_name(csv *c, const char *cell)
{
    for (int i = 0; i < N_COLUMNS; i++) {
        if (strcmp(cell, column_names[i]) == 0) {
            if (c->place[i] >= 0) {
                say_cell(c, "header", "column given twice", cell, "each once");
            }
            c->place[i] = c->n_cells;
            return;
        }
    }
    say_cell(c, "header", "unknown column", cell, "id, x_mm, y_mm, z_mm, nx, ny, nz");
}

static void check_header(csv *c)
{
    for (int i = 0; i <= COLUMN_Y; i++) {
        if (c->place[i] < 0) {
            exk_faults_add(&c->faults, c->line,
                           "header: missing column %s; needed: id, x_mm, y_mm",
                           column_names[i]);
        }
    }
    const int n_directions =
        (c->place[COLUMN_NX] >= 0) + (c->place[COLUMN_NY] >= 0) + (c->place[COLUMN_NZ] >= 0);
    if (n_directions != 0 && n_directions != 3) {
        exk_faults_add(&c->faults, c->line,
                       "header: nx, ny, nz go together: found %d of them, allowed: all or none",
                       n_directions);
    }
}

static bool read_header(csv *c)
{
    char cell[CELL_SIZE];
    const char *row;
    if (!next_row(c, &row)) {
        exk_faults_add(&c->faults, 0,
                       "empty: no header and no hole; the first line names the columns: "
                       "id,x_mm,y_mm");
        return false;
    }
    while (row != NULL) {
        row = next_cell(row, cell);
        read_name(c, cell);
        c->n_cells++;
    }
    check_header(c);
    return c->faults.n == 0;
}

static bool read_number(csv *c, column at, const exk_unit *unit, const char *cell, double *out)
{
    const char *what = NULL;
    if (cell[0] == '\0') {
        what = "no value";
    } else if (!exk_number_read(cell, unit, out)) {
        what = "not a number";
    } else if (!isfinite(*out)) {
        what = "not finite";
    }
    if (what != NULL) {
        say_cell(c, column_names[at], what, cell, "any finite number");
    }
    return what == NULL;
}

static void check_id(csv *c, int32_t id)
{
    for (size_t i = 0; i < c->n_holes; i++) {
        if (c->holes[i].id == id) {
            exk_faults_add(
                &c->faults, c->line,
                "id: given twice: found %ld, first in line %d; give each hole its own",
                (long)id, c->lines[i]);
            return;
        }
    }
}

static void read_id(csv *c, const char *cell, exk_hole *hole)
{
    double value = 0.0;
    if (!read_number(c, COLUMN_ID, &exk_unit_none, cell, &value)) {
        return;
    }
    if (value != floor(value) || !(fabs(value) <= INT32_MAX)) {
        say_cell(c, "id", "not a whole number of 32 bits", cell, "-2147483647 to 2147483647");
        return;
    }
    hole->id = (int32_t)value;
    c->has_id = true;
    check_id(c, hole->id);
}

static void set_axis(csv *c, exk_hole *hole)
{
    const double length = exk_norm3(hole->axis);
    if (!(length > shortest_direction) || !isfinite(length)) {
        exk_faults_add(&c->faults, c->line,
                       "nx,ny,nz: no direction: the length must be above 1e-6 and finite");
        return;
    }
    for (int i = 0; i < 3; i++) {
        hole->axis[i] /= length;
    }
}

static bool read_cells(csv *c, const char *row, exk_hole *hole)
{
    double *const targets[N_COLUMNS] = {
        [COLUMN_X] = &hole->target_m[0], [COLUMN_Y] = &hole->target_m[1],
        [COLUMN_Z] = &hole->target_m[2], [COLUMN_NX] = &hole->axis[0],
        [COLUMN_NY] = &hole->axis[1],    [COLUMN_NZ] = &hole->axis[2],
    };
    char cell[CELL_SIZE];
    int n = 0;
    for (; row != NULL; n++) {
        row = next_cell(row, cell);
        for (int i = 0; i < N_COLUMNS; i++) {
            const exk_unit *unit = i < COLUMN_NX ? &millimetres : &exk_unit_none;
            if (c->place[i] == n && i == COLUMN_ID) {
                read_id(c, cell, hole);
            } else if (c->place[i] == n) {
                read_number(c, (column)i, unit, cell, targets[i]);
            }
        }
    }
    if (n != c->n_cells) {
        exk_faults_add(&c->faults, c->line, "row: found %d cells, the header names %d", n,
                       c->n_cells);
    }
    return n == c->n_cells;
}

static void read_hole(csv *c, const char *row)
{
    exk_hole hole = {.target_m = {0.0, 0.0, c->plane_z_m}, .axis = {0.0, 0.0, 1.0}};
    const size_t n_before = c->faults.n;
    c->has_id = false;
    if (read_cells(c, row, &hole) && c->faults.n == n_before) {
        set_axis(c, &hole);
    }
    if (c->has_id) { /* a refused row keeps its place: its id counts too */
        c->lines[c->n_holes] = c->line;
        c->holes[c->n_holes++] = hole;
    }
}

static void read_holes(csv *c)
{
    const char *row;
    while (next_row(c, &row)) {
        if (c->n_holes == c->capacity) {
            exk_faults_add(&c->faults, c->line, "too many holes: allowed %zu", c->capacity);
            return;
        }
        read_hole(c, row);
    }
    if (c->n_holes == 0 && c->faults.n == 0) {
        exk_faults_add(&c->faults, 0, "no hole: the header stands alone; add a line a hole");
    }
}

exk_err exk_job_csv_parse(const char *text, double plane_z_m, exk_hole *holes, size_t capacity,
                          size_t *n_holes, exk_fault *faults, size_t fault_capacity,
                          size_t *n_faults)
{
    static const char byte_order_mark[] = "\xef\xbb\xbf";
    const size_t mark = sizeof(byte_order_mark) - 1;
    csv c = {
        .next = strncmp(text, byte_order_mark, mark) == 0 ? text + mark : text,
        .faults = {faults, fault_capacity, 0},
        .place = {-1, -1, -1, -1, -1, -1, -1},
        .plane_z_m = plane_z_m,
        .holes = holes,
        .capacity = capacity < EXK_MAX_HOLES ? capacity : EXK_MAX_HOLES,
    };
    if (read_header(&c)) {
        read_holes(&c);
    }
    *n_faults = c.faults.n;
    if (c.faults.n > 0) {
        return EXK_ERR_ARG;
    }
    *n_holes = c.n_holes;
    return EXK_OK;
}
