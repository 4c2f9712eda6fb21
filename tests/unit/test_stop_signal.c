/* Ctrl-C and its like are noted, the newest counts, and catching again begins anew. */
#define _POSIX_C_SOURCE 200809L
#include "exk/stop_signal.h"

#include <signal.h>

#include "unity.h"

void setUp(void)
{
    exk_stop_catch();
}

void tearDown(void)
{
}

static void none_at_first(void)
{
    TEST_ASSERT_EQUAL_INT(0, exk_stop_signal());
}

static void each_is_noted_and_not_deadly(void)
{
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        TEST_ASSERT_EQUAL_INT(0, raise(numbers[i]));
        TEST_ASSERT_EQUAL_INT(numbers[i], exk_stop_signal());
    }
}

static void under_nohup_a_closed_terminal_means_nothing(void)
{
    void (*const before)(int) = signal(SIGHUP, SIG_IGN);
    exk_stop_catch();
    TEST_ASSERT_EQUAL_INT(0, raise(SIGHUP));
    TEST_ASSERT_EQUAL_INT(0, exk_stop_signal());
    signal(SIGHUP, before);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(none_at_first);
    RUN_TEST(each_is_noted_and_not_deadly);
    RUN_TEST(none_at_first);
    RUN_TEST(under_nohup_a_closed_terminal_means_nothing);
    return UNITY_END();
}
