#include "exk/job_csv.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "unity.h"

enum { MAX_FAULTS = 16, MAX_WANTED = 6, CAPACITY = 8 };

static exk_hole holes[EXK_MAX_HOLES];
static exk_fault faults[MAX_FAULTS];
static size_t n_holes;
static size_t n_faults;

void setUp(void)
{
    memset(faults, 0, sizeof(faults));
    n_holes = 77;
    n_faults = 0;
}

void tearDown(void)
{
}

static exk_err parse(const char *text)
{
    return exk_job_csv_parse(text, 1.45, holes, CAPACITY, &n_holes, faults, MAX_FAULTS,
                             &n_faults);
}

static void expect_hole(size_t i, int32_t id, double x_m, double y_m, double z_m)
{
    TEST_ASSERT_EQUAL_INT32(id, holes[i].id);
    TEST_ASSERT_TRUE(x_m == holes[i].target_m[0]); /* the nearest double, nothing else */
    TEST_ASSERT_TRUE(y_m == holes[i].target_m[1]);
    TEST_ASSERT_TRUE(z_m == holes[i].target_m[2]);
}

static void three_columns_are_enough(void)
{
    TEST_ASSERT_EQUAL(EXK_OK, parse("id,x_mm,y_mm\n1,12.3,-4.56\n-7,1e2,0\n"));
    TEST_ASSERT_EQUAL_UINT(2, n_holes);
    expect_hole(0, 1, 0.0123, -0.00456, 1.45);
    expect_hole(1, -7, 0.1, 0.0, 1.45);
    TEST_ASSERT_TRUE(holes[0].axis[0] == 0.0 && holes[0].axis[1] == 0.0 &&
                     holes[0].axis[2] == 1.0);
}

static void columns_come_in_any_order(void)
{
    TEST_ASSERT_EQUAL(EXK_OK, parse("nz,nx,ny,z_mm,y_mm,x_mm,id\n4,3,0,1400,2,1,9\n"));
    TEST_ASSERT_EQUAL_UINT(1, n_holes);
    expect_hole(0, 9, 0.001, 0.002, 1.4);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.6, holes[0].axis[0]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.8, holes[0].axis[2]);
}

static void line_ends_blanks_and_comments_do_not_matter(void)
{
    TEST_ASSERT_EQUAL(EXK_OK,
                      parse("\xef\xbb\xbf# job\r\n\r\n id , x_mm ,\ty_mm \r\n# row\r\n  \r\n 1 "
                            ", 2 , 3 \r\n2,3,4"));
    TEST_ASSERT_EQUAL_UINT(2, n_holes);
    expect_hole(0, 1, 0.002, 0.003, 1.45);
    expect_hole(1, 2, 0.003, 0.004, 1.45);
}

typedef struct {
    const char *name;
    const char *text;
    exk_fault want[MAX_WANTED];
} row;

#define HEADER "id,x_mm,y_mm\n"
#define NAMES "id, x_mm, y_mm, z_mm, nx, ny, nz"

static const row rows[] = {
    {"empty",
     "",
     {{0, "empty: no header and no hole; the first line names the columns: id,x_mm,y_mm"}}},
    {"comments alone",
     "# nothing\n\n",
     {{0, "empty: no header and no hole; the first line names the columns: id,x_mm,y_mm"}}},
    {"header only", HEADER "\n", {{0, "no hole: the header stands alone; add a line a hole"}}},
    {"no header",
     "1,2,3\n",
     {{1, "header: unknown column: found \"1\", allowed: " NAMES},
      {1, "header: unknown column: found \"2\", allowed: " NAMES},
      {1, "header: unknown column: found \"3\", allowed: " NAMES},
      {1, "header: missing column id; needed: id, x_mm, y_mm"},
      {1, "header: missing column x_mm; needed: id, x_mm, y_mm"},
      {1, "header: missing column y_mm; needed: id, x_mm, y_mm"}}},
    {"wrong unit in the header",
     "id,x_m,y_mm\n1,2,3\n",
     {{1, "header: unknown column: found \"x_m\", allowed: " NAMES},
      {1, "header: missing column x_mm; needed: id, x_mm, y_mm"}}},
    {"column twice, direction in part",
     "\nid,x_mm,y_mm,x_mm,nx\n1,2,3,4,5\n",
     {{2, "header: column given twice: found \"x_mm\", allowed: each once"},
      {2, "header: nx, ny, nz go together: found 1 of them, allowed: all or none"}}},
    {"ids twice",
     HEADER "5,0,0\n6,0,0\n\n5,1,1\n6,1,1\n",
     {{5, "id: given twice: found 5, first in line 2; give each hole its own"},
      {6, "id: given twice: found 6, first in line 3; give each hole its own"}}},
    {"id of a refused row twice",
     HEADER "5,x,0\n5,1,1\n",
     {{2, "x_mm: not a number: found \"x\", allowed: any finite number"},
      {3, "id: given twice: found 5, first in line 2; give each hole its own"}}},
    {"no numbers",
     HEADER "a,2,3\n2,,3\n3,1,2;5\n4,0x1,1e\n0,0,0\n",
     {{2, "id: not a number: found \"a\", allowed: any finite number"},
      {3, "x_mm: no value: found \"\", allowed: any finite number"},
      {4, "y_mm: not a number: found \"2;5\", allowed: any finite number"},
      {5, "x_mm: not a number: found \"0x1\", allowed: any finite number"},
      {5, "y_mm: not a number: found \"1e\", allowed: any finite number"}}},
    {"not finite",
     HEADER "1,nan,inf\n2,1e999,0\n",
     {{2, "x_mm: not finite: found \"nan\", allowed: any finite number"},
      {2, "y_mm: not finite: found \"inf\", allowed: any finite number"},
      {3, "x_mm: not finite: found \"1e999\", allowed: any finite number"}}},
    {"ids that are none",
     HEADER "1.5,0,0\n3000000000,0,0\n",
     {{2,
       "id: not a whole number of 32 bits: found \"1.5\", allowed: -2147483647 to 2147483647"},
      {3, "id: not a whole number of 32 bits: found \"3000000000\", allowed: -2147483647 to "
          "2147483647"}}},
    {"rows too short and too long",
     HEADER "1,2\n2,3,4,5\n",
     {{2, "row: found 2 cells, the header names 3"},
      {3, "row: found 4 cells, the header names 3"}}},
    {"no direction",
     "id,x_mm,y_mm,nx,ny,nz\n1,0,0,0,0,1e-7\n2,0,0,1e200,0,1e200\n",
     {{2, "nx,ny,nz: no direction: the length must be above 1e-6 and finite"},
      {3, "nx,ny,nz: no direction: the length must be above 1e-6 and finite"}}},
    {"too many",
     HEADER "1,0,0\n2,0,0\n3,0,0\n4,0,0\n5,0,0\n6,0,0\n7,0,0\n8,0,0\n9,0,0\n10,0,0\n",
     {{10, "too many holes: allowed 8"}}},
};

static void check_row(const row *r)
{
    char what[96];
    size_t n_want = 0;
    while (n_want < MAX_WANTED && r->want[n_want].message[0] != '\0') {
        n_want++;
    }
    setUp();
    TEST_ASSERT_EQUAL_MESSAGE(EXK_ERR_ARG, parse(r->text), r->name);
    for (size_t i = 0; i < n_faults && i < n_want; i++) {
        snprintf(what, sizeof(what), "%s, fault %zu", r->name, i + 1);
        TEST_ASSERT_EQUAL_STRING_MESSAGE(r->want[i].message, faults[i].message, what);
        TEST_ASSERT_EQUAL_INT_MESSAGE(r->want[i].line, faults[i].line, what);
    }
    TEST_ASSERT_EQUAL_UINT_MESSAGE(n_want, n_faults, r->name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(77, n_holes, r->name); /* written on success only */
}

static void every_fault_is_named_with_its_line(void)
{
    for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
        check_row(&rows[i]);
    }
}

static void the_largest_job_fits_and_one_more_does_not(void)
{
    static char text[EXK_MAX_HOLES * 16 + 64];
    size_t length = (size_t)snprintf(text, sizeof(text), HEADER);
    for (int i = 0; i < EXK_MAX_HOLES; i++) {
        length += (size_t)snprintf(text + length, sizeof(text) - length, "%d,1,2\n", i);
    }
    TEST_ASSERT_EQUAL(EXK_OK, exk_job_csv_parse(text, 1.0, holes, EXK_MAX_HOLES, &n_holes,
                                                faults, MAX_FAULTS, &n_faults));
    TEST_ASSERT_EQUAL_UINT(EXK_MAX_HOLES, n_holes);
    snprintf(text + length, sizeof(text) - length, "-1,1,2\n");
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_job_csv_parse(text, 1.0, holes, EXK_MAX_HOLES, &n_holes,
                                                     faults, MAX_FAULTS, &n_faults));
    TEST_ASSERT_EQUAL_STRING("too many holes: allowed 4096", faults[0].message);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(three_columns_are_enough);
    RUN_TEST(columns_come_in_any_order);
    RUN_TEST(line_ends_blanks_and_comments_do_not_matter);
    RUN_TEST(every_fault_is_named_with_its_line);
    RUN_TEST(the_largest_job_fits_and_one_more_does_not);
    return UNITY_END();
}
