exk_test(accuracy test_study_figures SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_study_figures.c
    NEEDS exk_study_lib)
exk_test(accuracy test_study_limits SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_study_limits.c
    NEEDS exk_study_lib)
