exk_test(unit test_disturbance SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_disturbance.c NEEDS exk::noise)
