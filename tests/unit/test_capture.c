/* The last n samples, in order, until something went wrong. */
#include "exk/capture.h"

#include "unity.h"

enum { N_SLOTS = 4 };

static exk_sample slots[N_SLOTS];
static exk_capture capture;

void setUp(void)
{
    TEST_ASSERT_EQUAL(EXK_OK, exk_capture_init(&capture, slots, N_SLOTS));
}

void tearDown(void)
{
}

static void push(int64_t from, int64_t to)
{
    for (int64_t k = from; k < to; k++) {
        const exk_sample sample = {.k = k};
        exk_capture_push(&capture, &sample);
    }
}

static void holds(int64_t from, size_t n)
{
    TEST_ASSERT_EQUAL_UINT(n, exk_capture_count(&capture));
    for (size_t i = 0; i < n; i++) {
        TEST_ASSERT_NOT_NULL(exk_capture_at(&capture, i));
        TEST_ASSERT_EQUAL_INT64(from + (int64_t)i, exk_capture_at(&capture, i)->k);
    }
    TEST_ASSERT_NULL(exk_capture_at(&capture, n));
    TEST_ASSERT_NULL(exk_capture_at(&capture, SIZE_MAX));
}

static void a_ring_without_slots_is_refused(void)
{
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_capture_init(&capture, NULL, N_SLOTS));
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_capture_init(&capture, slots, 0));
    holds(0, 0); /* the ring of before is as it was */
}

static void the_oldest_is_forgotten_first(void)
{
    for (int64_t n = 0; n <= 3 * N_SLOTS; n++) {
        setUp();
        push(0, n);
        holds(n > N_SLOTS ? n - N_SLOTS : 0, n > N_SLOTS ? N_SLOTS : (size_t)n);
    }
}

static void one_slot_holds_the_newest(void)
{
    TEST_ASSERT_EQUAL(EXK_OK, exk_capture_init(&capture, slots, 1));
    push(0, 3);
    holds(2, 1);
}

static void what_is_frozen_stays_until_reset(void)
{
    push(0, 6);
    exk_capture_freeze(&capture);
    push(6, 9);
    holds(2, N_SLOTS);
    exk_capture_reset(&capture);
    holds(0, 0);
    push(20, 22);
    holds(20, 2);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_ring_without_slots_is_refused);
    RUN_TEST(the_oldest_is_forgotten_first);
    RUN_TEST(one_slot_holds_the_newest);
    RUN_TEST(what_is_frozen_stays_until_reset);
    return UNITY_END();
}
