foreach(test fault_product detection machine_day)
    exk_test(accuracy test_${test} SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_${test}.c NEEDS exk::loop)
    target_include_directories(test_${test} PRIVATE ${CMAKE_CURRENT_LIST_DIR}/../support)
endforeach()
