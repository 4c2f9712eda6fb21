foreach(test fault_product detection machine_day odd_moments)
    exk_test(accuracy test_${test} SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_${test}.c NEEDS exk::loop)
    set_tests_properties(test_${test} PROPERTIES TIMEOUT 600)
    if(EXK_INSTRUMENTED)
        # ten times slower: every 11th tick there, every tick in the other builds
        set_tests_properties(test_${test} PROPERTIES ENVIRONMENT EXK_STRIDE=11)
    endif()
    target_include_directories(test_${test} PRIVATE ${CMAKE_CURRENT_LIST_DIR}/../support)
endforeach()
