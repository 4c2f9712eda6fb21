#include "exk/arrivals.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "unity.h"

enum { ROW_MAX = 12, END = -1000 };

void setUp(void)
{
}

void tearDown(void)
{
}

static const struct {
    const char *name;
    int64_t seq[ROW_MAX];
    const char *want; /* n new, o reordered, r repeated */
    int64_t n_lost;
    int64_t n_reordered;
    int64_t n_repeated;
} rows[] = {
    {"in order", {0, 1, 2, 3, END}, "nnnn", 0, 0, 0},
    {"one lost", {0, 1, 3, END}, "nnn", 1, 0, 0},
    {"begins late", {5, 6, END}, "nn", 5, 0, 0},
    {"two swapped", {0, 2, 1, 3, END}, "nnon", 0, 1, 0},
    {"twice", {0, 1, 1, 2, END}, "nnrn", 0, 0, 1},
    {"swapped, then twice", {0, 2, 1, 1, 2, END}, "nnorr", 0, 1, 2},
    {"a far jump, then its end", {0, 100, 99, 36, END}, "nnor", 98, 1, 1},
    {"the oldest that is remembered", {0, 64, 1, 0, END}, "nnor", 62, 1, 1},
    {"backwards", {3, 2, 1, 0, END}, "nooo", 0, 3, 0},
    {"below zero", {-1, 0, -5, END}, "rnr", 0, 0, 2},
    {"a jump of exactly the window", {0, 64, 0, END}, "nnr", 63, 0, 1},
    {"a jump of one less", {0, 63, 0, END}, "nnr", 62, 0, 1},
};

static char letter(exk_arrival arrival)
{
    return arrival == EXK_ARRIVAL_NEW ? 'n' : arrival == EXK_ARRIVAL_REORDERED ? 'o' : 'r';
}

static void each_kind_is_told_apart(void)
{
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        exk_arrivals a;
        char got[ROW_MAX + 1] = "";
        exk_arrivals_init(&a);
        for (size_t j = 0; rows[i].seq[j] != END; j++) {
            got[j] = letter(exk_arrivals_take(&a, rows[i].seq[j]));
        }
        TEST_ASSERT_EQUAL_STRING_MESSAGE(rows[i].want, got, rows[i].name);
        TEST_ASSERT_EQUAL_INT64_MESSAGE(rows[i].n_lost, a.n_lost, rows[i].name);
        TEST_ASSERT_EQUAL_INT64_MESSAGE(rows[i].n_reordered, a.n_reordered, rows[i].name);
        TEST_ASSERT_EQUAL_INT64_MESSAGE(rows[i].n_repeated, a.n_repeated, rows[i].name);
    }
}

/* Within the window the counts agree with a list of what came, whatever came. */
static void counts_agree_with_a_full_memory(void)
{
    enum { SEQS = 60, ROUNDS = 2000 };
    srand(1);
    for (int round = 0; round < ROUNDS; round++) {
        bool came[SEQS] = {false};
        int64_t newest = -1;
        int64_t n_came = 0;
        int64_t n_repeated = 0;
        exk_arrivals a;
        exk_arrivals_init(&a);
        for (int i = 0; i < SEQS; i++) {
            const int64_t seq = rand() % SEQS;
            const exk_arrival got = exk_arrivals_take(&a, seq);
            TEST_ASSERT_EQUAL(came[seq], got == EXK_ARRIVAL_REPEATED);
            TEST_ASSERT_EQUAL(!came[seq] && seq < newest, got == EXK_ARRIVAL_REORDERED);
            n_repeated += came[seq] ? 1 : 0;
            n_came += came[seq] ? 0 : 1;
            came[seq] = true;
            newest = seq > newest ? seq : newest;
        }
        TEST_ASSERT_EQUAL_INT64(newest + 1 - n_came, a.n_lost);
        TEST_ASSERT_EQUAL_INT64(n_repeated, a.n_repeated);
    }
}

/* What a hostile sender may write: nothing overflows. */
static void the_ends_of_the_range_are_survived(void)
{
    exk_arrivals a;
    exk_arrivals_init(&a);
    TEST_ASSERT_EQUAL(EXK_ARRIVAL_NEW, exk_arrivals_take(&a, INT64_MAX));
    TEST_ASSERT_EQUAL(EXK_ARRIVAL_REPEATED, exk_arrivals_take(&a, INT64_MIN));
    TEST_ASSERT_EQUAL(EXK_ARRIVAL_REPEATED, exk_arrivals_take(&a, 0));
    TEST_ASSERT_EQUAL(EXK_ARRIVAL_REORDERED, exk_arrivals_take(&a, INT64_MAX - 63));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(each_kind_is_told_apart);
    RUN_TEST(counts_agree_with_a_full_memory);
    RUN_TEST(the_ends_of_the_range_are_survived);
    return UNITY_END();
}
