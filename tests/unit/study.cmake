foreach(name tally block verdict report)
    exk_test(unit test_study_${name} SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_study_${name}.c
        NEEDS exk_study_lib)
endforeach()
