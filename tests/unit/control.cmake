exk_test(unit test_pid SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_pid.c NEEDS exk::control)
exk_test(unit test_pid_stability SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_pid_stability.c
    NEEDS exk::control)
exk_test(unit test_feedback SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_feedback.c NEEDS exk::control)
exk_test(unit test_ilc SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_ilc.c NEEDS exk::control)
exk_test(unit test_ilc_filter SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_ilc_filter.c
    NEEDS exk::control)
