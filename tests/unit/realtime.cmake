exk_test(unit test_pacer SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_pacer.c NEEDS exk::realtime)
exk_test(unit test_histogram SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_histogram.c NEEDS exk::realtime)
