#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>

#include "exk/ring.h"
#include "unity.h"

enum { N_SLOTS = 8, N_STRESS = 1000000 };

static exk_ring ring;
static uint64_t slots[N_SLOTS];

void setUp(void)
{
    TEST_ASSERT_EQUAL(EXK_OK, exk_ring_init(&ring, slots, N_SLOTS, sizeof slots[0]));
}

void tearDown(void)
{
}

static void init_refuses_what_it_cannot_index(void)
{
    static const struct {
        const char *name;
        size_t n_slots;
        size_t slot_bytes;
    } rows[] = {
        {"no slot", 0, 8},      {"one slot", 1, 8},    {"not a power of two", 6, 8},
        {"one too many", 9, 8}, {"empty slots", 8, 0},
    };
    exk_ring other;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        TEST_ASSERT_EQUAL_MESSAGE(
            EXK_ERR_ARG, exk_ring_init(&other, slots, rows[i].n_slots, rows[i].slot_bytes),
            rows[i].name);
    }
    TEST_ASSERT_EQUAL(EXK_ERR_ARG, exk_ring_init(&other, NULL, 8, 8));
}

static void an_empty_ring_gives_nothing(void)
{
    uint64_t out = 77;
    TEST_ASSERT_FALSE(exk_ring_pop(&ring, &out));
    TEST_ASSERT_NULL(exk_ring_front(&ring));
    TEST_ASSERT_EQUAL_UINT64(77, out);
    TEST_ASSERT_TRUE(exk_ring_has_room(&ring));
}

static void first_in_first_out_over_many_wraps(void)
{
    uint64_t next_in = 0;
    uint64_t next_out = 0;
    for (int round = 0; round < 100; round++) {
        for (int i = 0; i < 1 + round % N_SLOTS; i++, next_in++) {
            TEST_ASSERT_TRUE(exk_ring_push(&ring, &next_in));
        }
        uint64_t out;
        while (exk_ring_pop(&ring, &out)) {
            TEST_ASSERT_EQUAL_UINT64(next_out, out);
            next_out++;
        }
        TEST_ASSERT_EQUAL_UINT64(next_in, next_out);
    }
    TEST_ASSERT_EQUAL_UINT64(0, exk_ring_dropped(&ring));
}

static void a_full_ring_refuses_counts_and_keeps_the_old(void)
{
    for (uint64_t i = 0; i < N_SLOTS + 3; i++) {
        TEST_ASSERT_EQUAL(i < N_SLOTS, exk_ring_push(&ring, &i));
    }
    TEST_ASSERT_FALSE(exk_ring_has_room(&ring));
    TEST_ASSERT_EQUAL_UINT64(3, exk_ring_dropped(&ring));
    uint64_t out;
    TEST_ASSERT_TRUE(exk_ring_pop(&ring, &out));
    TEST_ASSERT_EQUAL_UINT64(0, out);
    TEST_ASSERT_TRUE(exk_ring_has_room(&ring));
    TEST_ASSERT_EQUAL_UINT64(N_SLOTS, ring.deepest);
}

static void begin_is_seen_only_after_commit(void)
{
    uint64_t *slot = exk_ring_begin(&ring);
    *slot = 42;
    TEST_ASSERT_NULL(exk_ring_front(&ring));
    exk_ring_commit(&ring);
    const uint64_t *front = exk_ring_front(&ring);
    TEST_ASSERT_NOT_NULL(front);
    TEST_ASSERT_EQUAL_UINT64(42, *front);
    exk_ring_release(&ring);
    TEST_ASSERT_NULL(exk_ring_front(&ring));
}

/* A record as large as the real ones; every word carries the same number, so that a torn copy or a
 * slot read before it was written shows. */
typedef struct {
    uint64_t word[48];
} wide;

static exk_ring wide_ring;
static wide wide_slots[64];

typedef struct {
    uint64_t n_seen;
    uint64_t n_torn;
    uint64_t n_disorder;
} findings;

static _Atomic bool finished;

static void *consume(void *ctx)
{
    findings *found = ctx;
    wide record;
    uint64_t last = 0;
    for (;;) {
        const bool over = atomic_load(&finished);
        if (exk_ring_pop(&wide_ring, &record)) {
            for (size_t i = 1; i < 48; i++) {
                found->n_torn += record.word[i] != record.word[0];
            }
            found->n_disorder += record.word[0] <= last;
            last = record.word[0];
            found->n_seen++;
        } else if (over) {
            return NULL;
        } else {
            sched_yield();
        }
    }
}

static uint64_t produce(bool patient)
{
    uint64_t n_pushed = 0;
    for (uint64_t i = 1; i <= N_STRESS; i++) {
        wide record;
        for (size_t j = 0; j < 48; j++) {
            record.word[j] = i;
        }
        while (patient && !exk_ring_has_room(&wide_ring)) {
            sched_yield();
        }
        n_pushed += exk_ring_push(&wide_ring, &record);
    }
    return n_pushed;
}

static void stress(bool patient)
{
    pthread_t thread;
    findings found = {0};
    exk_ring_init(&wide_ring, wide_slots, 64, sizeof wide_slots[0]);
    atomic_store(&finished, false);
    TEST_ASSERT_EQUAL(0, pthread_create(&thread, NULL, consume, &found));
    const uint64_t n_pushed = produce(patient);
    atomic_store(&finished, true);
    pthread_join(thread, NULL);
    TEST_ASSERT_EQUAL_UINT64(N_STRESS, n_pushed + exk_ring_dropped(&wide_ring));
    TEST_ASSERT_EQUAL_UINT64(n_pushed, found.n_seen);
    TEST_ASSERT_EQUAL_UINT64(0, found.n_torn);
    TEST_ASSERT_EQUAL_UINT64(0, found.n_disorder);
    if (patient) {
        TEST_ASSERT_EQUAL_UINT64(0, exk_ring_dropped(&wide_ring));
    }
}

static void two_threads_a_million_records_none_torn(void)
{
    stress(false);
}

static void a_patient_producer_loses_none(void)
{
    stress(true);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(init_refuses_what_it_cannot_index);
    RUN_TEST(an_empty_ring_gives_nothing);
    RUN_TEST(first_in_first_out_over_many_wraps);
    RUN_TEST(a_full_ring_refuses_counts_and_keeps_the_old);
    RUN_TEST(begin_is_seen_only_after_commit);
    RUN_TEST(two_threads_a_million_records_none_torn);
    RUN_TEST(a_patient_producer_loses_none);
    return UNITY_END();
}
