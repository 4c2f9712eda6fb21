#include <stdlib.h>
#include <string.h>

#include "blocks.h"
#include "unity.h"

enum { MEASURES = 3, WHY_SIZE = 256 };

static const study_measure measures[MEASURES] = {
    {.key = "length", .unit = "m", .kind = STUDY_LENGTH},
    {.key = "count", .kind = STUDY_COUNT, .count_max = 45},
    {.key = "difference", .kind = STUDY_SIGNED}};

static const study_task task = {
    .name = "test", .measures = measures, .n_measures = MEASURES, .hash = 77};

static study_sums sums;
static char why[WHY_SIZE];

static void fill(uint64_t first)
{
    for (int m = 0; m < MEASURES; m++) {
        study_tally_clear(&sums.tallies[m]);
        for (int i = 0; i < 50; i++) {
            study_tally_add(&sums.tallies[m],
                            1e-3 * (double)((first + 7 * (uint64_t)i) % 41) - 1e-3 * m);
        }
    }
}

static uint8_t *record(uint64_t hash, uint64_t first, uint64_t n_trials, size_t *n)
{
    const study_block_head head = {.hash = hash, .first = first, .n_trials = n_trials};
    fill(first);
    return study_block_encode(sums.tallies, MEASURES, &head, n);
}

void setUp(void)
{
    why[0] = '\0';
    study_sums_open(&sums, measures, MEASURES);
}

void tearDown(void)
{
    study_sums_close(&sums);
}

static void a_record_comes_back_to_the_bit(void)
{
    study_sums back, part;
    study_block_head head;
    size_t n = 0;
    uint8_t *bytes = record(77, 100, 50, &n);
    study_sums_open(&back, measures, MEASURES);
    study_sums_open(&part, measures, MEASURES);
    TEST_ASSERT_TRUE(study_block_check(bytes, n, &head, why, sizeof why));
    TEST_ASSERT_EQUAL_UINT64(100, head.first);
    TEST_ASSERT_EQUAL_UINT64(n, head.n_bytes);
    TEST_ASSERT_TRUE(study_block_fold(bytes, n, back.tallies, part.tallies, MEASURES));
    for (int m = 0; m < MEASURES; m++) {
        const study_tally *want = &sums.tallies[m], *got = &part.tallies[m];
        TEST_ASSERT_EQUAL_MEMORY(&want->moments, &got->moments, sizeof want->moments);
        TEST_ASSERT_EQUAL_MEMORY(&want->min, &got->min, sizeof want->min);
        TEST_ASSERT_EQUAL_UINT64(want->n_positive, got->n_positive);
        for (uint32_t i = 0; i < want->n_bins; i++) {
            TEST_ASSERT_EQUAL_UINT32(want->bins[i], got->bins[i]);
        }
    }
    free(bytes);
    study_sums_close(&back);
    study_sums_close(&part);
}

static void every_flipped_bit_is_seen(void)
{
    study_block_head head;
    size_t n = 0;
    uint8_t *bytes = record(77, 0, 50, &n);
    for (size_t i = 0; i < n; i++) {
        bytes[i] ^= (uint8_t)(1U << i % 8);
        TEST_ASSERT_FALSE_MESSAGE(study_block_check(bytes, n, &head, why, sizeof why),
                                  "a flipped bit was taken");
        TEST_ASSERT_TRUE(strlen(why) > 0);
        bytes[i] ^= (uint8_t)(1U << i % 8);
    }
    TEST_ASSERT_TRUE(study_block_check(bytes, n, &head, why, sizeof why));
    free(bytes);
}

static void every_cut_is_seen(void)
{
    study_block_head head;
    size_t n = 0;
    uint8_t *bytes = record(77, 0, 50, &n);
    for (size_t i = 0; i < n; i++) {
        TEST_ASSERT_FALSE(study_block_check(bytes, i, &head, why, sizeof why));
    }
    free(bytes);
}

static void a_record_of_fewer_measures_is_not_folded(void)
{
    study_sums part;
    size_t n = 0;
    uint8_t *bytes = record(77, 0, 50, &n);
    study_sums_open(&part, measures, MEASURES);
    study_sums_close(&sums);
    study_sums_open(&sums, measures, MEASURES - 1);
    TEST_ASSERT_FALSE(study_block_fold(bytes, n, sums.tallies, part.tallies, MEASURES - 1));
    TEST_ASSERT_EQUAL_UINT64(0, sums.tallies[0].moments.n);
    free(bytes);
    study_sums_close(&part);
}

static void strangers_are_refused_with_a_reason(void)
{
    static const struct {
        const char *name;
        uint64_t hash, first, n_trials;
        const char *says;
    } rows[] = {{"of another study", 78, 0, 50, "another study"},
                {"off the grid", 77, 10, 50, "no block"},
                {"past the end", 77, 150, 50, "no block"},
                {"too short", 77, 0, 40, "no block"}};
    study_blocks blocks;
    study_blocks_open(&blocks, &task, 120);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        size_t n = 0;
        uint8_t *bytes = record(rows[i].hash, rows[i].first, rows[i].n_trials, &n);
        TEST_ASSERT_FALSE_MESSAGE(study_blocks_take(&blocks, bytes, n, why, sizeof why),
                                  rows[i].name);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why, rows[i].says), why);
    }
    study_blocks_close(&blocks);
}

static void taken_in_any_order_they_fold_to_the_same_bits(void)
{
    static const int orders[2][3] = {{0, 1, 2}, {2, 0, 1}};
    study_sums totals[2];
    for (int o = 0; o < 2; o++) {
        study_blocks blocks;
        study_blocks_open(&blocks, &task, 120);
        study_sums_open(&totals[o], measures, MEASURES);
        for (int i = 0; i < 3; i++) {
            const uint64_t first = 50 * (uint64_t)orders[o][i];
            size_t n = 0;
            uint8_t *bytes = record(77, first, first == 100 ? 20 : 50, &n);
            TEST_ASSERT_TRUE_MESSAGE(study_blocks_take(&blocks, bytes, n, why, sizeof why),
                                     why);
        }
        TEST_ASSERT_EQUAL_INT(STUDY_GOOD, study_blocks_fold(&blocks, &totals[o]));
        study_blocks_close(&blocks);
    }
    for (int m = 0; m < MEASURES; m++) {
        TEST_ASSERT_EQUAL_MEMORY(&totals[0].tallies[m].moments, &totals[1].tallies[m].moments,
                                 sizeof totals[0].tallies[m].moments);
    }
    study_sums_close(&totals[0]);
    study_sums_close(&totals[1]);
}

static void a_block_is_taken_once(void)
{
    study_blocks blocks;
    size_t n = 0;
    study_blocks_open(&blocks, &task, 120);
    uint8_t *bytes = record(77, 50, 50, &n);
    TEST_ASSERT_TRUE(study_blocks_take(&blocks, bytes, n, why, sizeof why));
    bytes = record(77, 50, 50, &n);
    TEST_ASSERT_FALSE(study_blocks_take(&blocks, bytes, n, why, sizeof why));
    TEST_ASSERT_NOT_NULL(strstr(why, "already"));
    TEST_ASSERT_EQUAL_UINT64(1, study_blocks_done(&blocks));
    study_blocks_close(&blocks);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_record_comes_back_to_the_bit);
    RUN_TEST(every_flipped_bit_is_seen);
    RUN_TEST(every_cut_is_seen);
    RUN_TEST(a_record_of_fewer_measures_is_not_folded);
    RUN_TEST(strangers_are_refused_with_a_reason);
    RUN_TEST(taken_in_any_order_they_fold_to_the_same_bits);
    RUN_TEST(a_block_is_taken_once);
    return UNITY_END();
}
