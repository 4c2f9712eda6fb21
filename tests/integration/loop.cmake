# The controller process and the ILC tool as a user runs them. Every bus test has a port of its own.
if(EXK_WITH_LCM)
    set(dir ${CMAKE_CURRENT_LIST_DIR}/loop)
    foreach(name closed faults same_bytes learning stop terminal refuses bad_input store_faults full_disk replay no_route)
        exk_script_test(integration test_loop_${name} ${dir}/${name}.sh
            ARGS ${PROJECT_BINARY_DIR}/bin ${PROJECT_SOURCE_DIR}/profiles)
    endforeach()
endif()
