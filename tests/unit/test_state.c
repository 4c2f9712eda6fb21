/* Every state times every event, against a table written here by hand. */
#include "exk/state.h"

#include <string.h>

#include "unity.h"

static exk_state_machine sm;

void setUp(void)
{
    exk_state_init(&sm);
}

void tearDown(void)
{
}

/* One row an event; one letter a state of INIT IDLE RUN HOLD FAULT DONE: the first letter of the next
 * state, I for INIT, L for IDLE; a dot where the event is refused. */
static const struct {
    exk_cause cause;
    const char *next;
} rows[EXK_CAUSE_COUNT] = {
    {EXK_CAUSE_NONE, "......"},   {EXK_CAUSE_READY, "L....."}, {EXK_CAUSE_START, ".R.R.."},
    {EXK_CAUSE_STOP, "..H..."},   {EXK_CAUSE_ABORT, ".FFF.."}, {EXK_CAUSE_CLEAR, "....L."},
    {EXK_CAUSE_QUIT, ".DDD.."},   {EXK_CAUSE_END, "..D..."},   {EXK_CAUSE_TIMEOUT, "..H..."},
    {EXK_CAUSE_SENSOR, "..FF.."}, {EXK_CAUSE_LIMIT, ".FFF.."}, {EXK_CAUSE_OVERRUN, ".FFF.."},
    {EXK_CAUSE_SOURCE, ".FFF.."},
};

static const char letters[] = "ILRHFD";

static void every_state_takes_or_refuses_every_event(void)
{
    for (int e = 0; e < EXK_CAUSE_COUNT; e++) {
        TEST_ASSERT_EQUAL_INT(e, rows[e].cause);
        for (int s = 0; s < EXK_STATE_COUNT; s++) {
            const char *want = strchr(letters, rows[e].next[s]);
            exk_state_init(&sm);
            sm.state = (exk_state)s;
            const bool taken = exk_state_take(&sm, (exk_cause)e, 7);
            const char *name = exk_cause_name((exk_cause)e);
            TEST_ASSERT_EQUAL_MESSAGE(want != NULL, taken, name);
            TEST_ASSERT_EQUAL_INT_MESSAGE(want != NULL ? want - letters : s, sm.state, name);
            TEST_ASSERT_EQUAL_INT64_MESSAGE(taken ? 1 : 0, sm.n_taken, name);
            TEST_ASSERT_EQUAL_INT64_MESSAGE(taken ? 0 : 1, sm.n_refused, name);
            TEST_ASSERT_EQUAL_INT_MESSAGE(taken ? e : EXK_CAUSE_NONE, sm.cause, name);
            TEST_ASSERT_EQUAL_INT64_MESSAGE(taken ? 7 : -1, sm.k, name);
            TEST_ASSERT_EQUAL_INT_MESSAGE(taken ? 1 : 0, sm.n_notes, name);
        }
    }
}

static void values_that_are_no_event_or_state_are_refused(void)
{
    TEST_ASSERT_FALSE(exk_state_take(&sm, EXK_CAUSE_COUNT, 0));
    TEST_ASSERT_FALSE(exk_state_take(&sm, (exk_cause)1000000, 0));
    sm.state = EXK_STATE_COUNT;
    TEST_ASSERT_FALSE(exk_state_take(&sm, EXK_CAUSE_START, 0));
    TEST_ASSERT_EQUAL_INT64(3, sm.n_refused);
}

/* No row twice: the first would hide the second. */
static void the_table_is_a_function(void)
{
    const exk_transition *table;
    const size_t n = exk_state_transitions(&table);
    for (size_t i = 0; i < n; i++) {
        for (size_t j = i + 1; j < n; j++) {
            TEST_ASSERT_FALSE(table[i].from == table[j].from &&
                              table[i].cause == table[j].cause);
        }
    }
}

static void notes_tell_the_way_and_never_overflow(void)
{
    static const exk_cause way[] = {EXK_CAUSE_READY, EXK_CAUSE_START,  EXK_CAUSE_STOP,
                                    EXK_CAUSE_START, EXK_CAUSE_SENSOR, EXK_CAUSE_CLEAR};
    for (size_t i = 0; i < sizeof way / sizeof way[0]; i++) {
        TEST_ASSERT_TRUE(exk_state_take(&sm, way[i], (int64_t)i));
    }
    TEST_ASSERT_EQUAL_INT(EXK_STATE_NOTES, sm.n_notes);
    TEST_ASSERT_EQUAL_INT(EXK_STATE_RUN, sm.note[1].to);
    TEST_ASSERT_EQUAL_INT64(6, sm.n_taken);
    exk_state_forget_notes(&sm);
    TEST_ASSERT_EQUAL_INT(0, sm.n_notes);
    TEST_ASSERT_EQUAL_INT(EXK_STATE_IDLE, sm.state);
}

static void names_are_never_null(void)
{
    for (int i = -1; i <= EXK_CAUSE_COUNT; i++) {
        TEST_ASSERT_NOT_NULL(exk_cause_name((exk_cause)i));
        TEST_ASSERT_NOT_NULL(exk_state_name((exk_state)i));
    }
    TEST_ASSERT_EQUAL_STRING("command time-out", exk_cause_name(EXK_CAUSE_TIMEOUT));
    TEST_ASSERT_EQUAL_STRING("unknown", exk_cause_name(EXK_CAUSE_COUNT));
    TEST_ASSERT_EQUAL_STRING("hold", exk_state_name(EXK_STATE_HOLD));
    TEST_ASSERT_EQUAL_STRING("unknown", exk_state_name((exk_state)-1));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(every_state_takes_or_refuses_every_event);
    RUN_TEST(values_that_are_no_event_or_state_are_refused);
    RUN_TEST(the_table_is_a_function);
    RUN_TEST(notes_tell_the_way_and_never_overflow);
    RUN_TEST(names_are_never_null);
    return UNITY_END();
}
