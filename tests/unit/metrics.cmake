exk_test(unit test_accuracy SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_accuracy.c NEEDS exk::metrics)
exk_test(unit test_stats SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_stats.c NEEDS exk::metrics)
