exk_test(unit test_twin SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_twin.c NEEDS exk::plant)
exk_test(unit test_inject SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_inject.c NEEDS exk::plant)
