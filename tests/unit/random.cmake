exk_test(unit test_random SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_random.c NEEDS exk::random)
