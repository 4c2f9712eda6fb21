#include <string.h>

#include "exk/err.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static void every_code_has_a_name_of_its_own(void)
{
    for (int i = 0; i < EXK_ERR_COUNT; i++) {
        TEST_ASSERT_NOT_EQUAL(0, strcmp("unknown", exk_err_name((exk_err)i)));
        for (int j = 0; j < i; j++) {
            TEST_ASSERT_NOT_EQUAL(0,
                                  strcmp(exk_err_name((exk_err)j), exk_err_name((exk_err)i)));
        }
    }
}

static void a_value_outside_is_unknown(void)
{
    TEST_ASSERT_EQUAL_STRING("unknown", exk_err_name(EXK_ERR_COUNT));
    TEST_ASSERT_EQUAL_STRING("unknown", exk_err_name((exk_err)1000));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(every_code_has_a_name_of_its_own);
    RUN_TEST(a_value_outside_is_unknown);
    return UNITY_END();
}
