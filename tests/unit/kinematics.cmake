foreach(test geometry pendulum universal tripod wrist machine kinematics excess)
    exk_test(unit test_${test} SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_${test}.c
        NEEDS exk::kinematics)
endforeach()
