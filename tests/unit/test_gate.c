#include <stdlib.h>
#include <string.h>

#include "exk/command.h"
#include "unity.h"

enum { RUN = 77, FRESH_US = 500000 };
static const int64_t now_us = 1800000000000000;

static exk_key_secret key;
static exk_gate gate;
static exk_command got;

void setUp(void)
{
    memset(key.bytes, 0x5a, sizeof key.bytes);
    exk_gate_init(&gate, &key, RUN, FRESH_US);
    got = EXK_COMMAND_COUNT;
}

void tearDown(void)
{
}

static exk_wire_command good(int64_t seq)
{
    return (exk_wire_command){
        .run_id = RUN, .seq = seq, .utime_us = now_us, .command = EXK_COMMAND_STOP};
}

static bool pass(const exk_wire_command *m)
{
    unsigned char buffer[EXK_WIRE_COMMAND_MAX];
    const int bytes = exk_wire_command_encode(m, buffer, sizeof buffer);
    TEST_ASSERT_GREATER_THAN(0, bytes);
    return exk_gate_pass(&gate, buffer, (size_t)bytes, now_us, &got);
}

static bool pass_signed(exk_wire_command m)
{
    exk_command_sign(&m, &key);
    return pass(&m);
}

static void want_refused(exk_refusal kind, int64_t n, const char *name)
{
    for (int i = 0; i < EXK_REFUSED_COUNT; i++) {
        TEST_ASSERT_EQUAL_INT64_MESSAGE(i == (int)kind ? n : 0, gate.counts.n_refused[i], name);
    }
}

static void a_good_command_passes_once(void)
{
    TEST_ASSERT_TRUE(pass_signed(good(5)));
    TEST_ASSERT_EQUAL(EXK_COMMAND_STOP, got);
    TEST_ASSERT_EQUAL_INT64(1, gate.counts.n_taken);
    TEST_ASSERT_EQUAL_INT64(5, gate.last_seq);
    TEST_ASSERT_FALSE(pass_signed(good(5)));
    want_refused(EXK_REFUSED_REPLAYED, 1, "the same again");
    TEST_ASSERT_TRUE(pass_signed(good(6)));
}

static void each_refusal_has_its_kind_and_changes_nothing(void)
{
    static const struct {
        const char *name;
        int64_t run_id;
        int64_t seq;
        int64_t utime_us;
        int8_t command;
        exk_refusal want;
    } rows[] = {
        {"another run", RUN + 1, 9, 0, 1, EXK_REFUSED_RUN},
        {"whichever run", 0, 9, 0, 1, EXK_REFUSED_RUN},
        {"too old", RUN, 9, -FRESH_US - 1, 1, EXK_REFUSED_STALE},
        {"too far in the future", RUN, 9, FRESH_US + 1, 1, EXK_REFUSED_STALE},
        {"before all time", RUN, 9, INT64_MIN / 2, 1, EXK_REFUSED_STALE},
        {"an old seq", RUN, 3, 0, 1, EXK_REFUSED_REPLAYED},
        {"the lowest seq", RUN, INT64_MIN, 0, 1, EXK_REFUSED_REPLAYED},
        {"no such command", RUN, 9, 0, EXK_COMMAND_COUNT, EXK_REFUSED_UNKNOWN},
        {"below all commands", RUN, 9, 0, -1, EXK_REFUSED_UNKNOWN},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        exk_gate_init(&gate, &key, RUN, FRESH_US);
        TEST_ASSERT_TRUE(pass_signed(good(3)));
        got = EXK_COMMAND_COUNT;
        TEST_ASSERT_FALSE_MESSAGE(
            pass_signed((exk_wire_command){.run_id = rows[i].run_id,
                                           .seq = rows[i].seq,
                                           .utime_us = now_us + rows[i].utime_us,
                                           .command = rows[i].command}),
            rows[i].name);
        want_refused(rows[i].want, 1, rows[i].name);
        TEST_ASSERT_EQUAL_MESSAGE(EXK_COMMAND_COUNT, got, rows[i].name);
        TEST_ASSERT_EQUAL_INT64_MESSAGE(3, gate.last_seq, rows[i].name);
        TEST_ASSERT_EQUAL_INT64_MESSAGE(1, gate.counts.n_taken, rows[i].name);
    }
}

static void the_edges_of_freshness_pass(void)
{
    exk_wire_command m = good(1);
    m.utime_us = now_us - FRESH_US;
    TEST_ASSERT_TRUE(pass_signed(m));
    m = good(2);
    m.utime_us = now_us + FRESH_US;
    TEST_ASSERT_TRUE(pass_signed(m));
}

/* Every bit of a signed message: none can be changed without being refused. */
static void no_bit_can_be_flipped(void)
{
    unsigned char buffer[EXK_WIRE_COMMAND_MAX];
    exk_wire_command m = good(5);
    exk_command_sign(&m, &key);
    const int bytes = exk_wire_command_encode(&m, buffer, sizeof buffer);
    for (int bit = 0; bit < 8 * bytes; bit++) {
        buffer[bit / 8] ^= (unsigned char)(1U << (bit % 8));
        TEST_ASSERT_FALSE(exk_gate_pass(&gate, buffer, (size_t)bytes, now_us, &got));
        buffer[bit / 8] ^= (unsigned char)(1U << (bit % 8));
    }
    const exk_command_counts *c = &gate.counts;
    TEST_ASSERT_EQUAL_INT64(64, c->n_refused[EXK_REFUSED_MALFORMED]); /* fingerprint */
    TEST_ASSERT_EQUAL_INT64(64, c->n_refused[EXK_REFUSED_RUN]);
    TEST_ASSERT_EQUAL_INT64(8 * bytes - 128, c->n_refused[EXK_REFUSED_KEY]);
    TEST_ASSERT_TRUE(exk_gate_pass(&gate, buffer, (size_t)bytes, now_us, &got));
}

static void another_key_and_no_key_are_refused(void)
{
    exk_key_secret other = key;
    exk_wire_command m = good(1);
    TEST_ASSERT_FALSE(pass(&m));
    other.bytes[31] ^= 1U;
    exk_command_sign(&m, &other);
    TEST_ASSERT_FALSE(pass(&m));
    want_refused(EXK_REFUSED_KEY, 2, "keys");
}

static void random_bytes_and_every_length_are_refused(void)
{
    unsigned char bytes[EXK_WIRE_COMMAND_MAX + 8];
    srand(2);
    for (int i = 0; i < 10000; i++) {
        const size_t n = (size_t)i % sizeof bytes;
        for (size_t j = 0; j < n; j++) {
            bytes[j] = (unsigned char)rand();
        }
        TEST_ASSERT_FALSE(exk_gate_pass(&gate, bytes, n, now_us, &got));
    }
    want_refused(EXK_REFUSED_MALFORMED, 10000, "random bytes");
}

static void names_are_found_again(void)
{
    for (int i = 0; i < EXK_COMMAND_COUNT; i++) {
        exk_command found = EXK_COMMAND_COUNT;
        TEST_ASSERT_TRUE(exk_command_find(exk_command_name((exk_command)i), &found));
        TEST_ASSERT_EQUAL(i, found);
    }
    TEST_ASSERT_FALSE(exk_command_find("go", &got));
    TEST_ASSERT_EQUAL_STRING("unknown", exk_command_name(EXK_COMMAND_COUNT));
    TEST_ASSERT_EQUAL_STRING("unknown", exk_refusal_name(EXK_REFUSED_COUNT));
    TEST_ASSERT_EQUAL_STRING("wrong key", exk_refusal_name(EXK_REFUSED_KEY));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(a_good_command_passes_once);
    RUN_TEST(each_refusal_has_its_kind_and_changes_nothing);
    RUN_TEST(the_edges_of_freshness_pass);
    RUN_TEST(no_bit_can_be_flipped);
    RUN_TEST(another_key_and_no_key_are_refused);
    RUN_TEST(random_bytes_and_every_length_are_refused);
    RUN_TEST(names_are_found_again);
    return UNITY_END();
}
