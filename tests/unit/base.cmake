exk_test(unit test_err SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_err.c NEEDS exk::base)
