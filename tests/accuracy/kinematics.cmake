foreach(test tripod_reference tripod_round_trip kinematics_refusal jacobians machine_accuracy)
    exk_test(accuracy test_${test} SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_${test}.c
        NEEDS exk::kinematics)
    target_include_directories(test_${test} PRIVATE ${CMAKE_CURRENT_LIST_DIR}/../support)
endforeach()
