# exk-holes as a user runs it, on logs of exk-loop, whole and damaged.
if(TARGET exk-holes AND TARGET exk-loop)
    set(dir ${CMAKE_CURRENT_LIST_DIR}/holes)
    add_executable(edit-log ${dir}/edit_log.c)
    target_link_libraries(edit-log PRIVATE exk::telemetry exk_warnings)
    add_executable(check-json ${dir}/check_json.c)
    target_link_libraries(check-json PRIVATE exk_jansson exk_warnings m)
    exk_test_port(port)
    foreach(name contract losses refusals outputs live)
        exk_script_test(integration test_holes_${name} ${dir}/${name}.sh
            ARGS ${PROJECT_BINARY_DIR}/bin ${PROJECT_SOURCE_DIR}/profiles
                ${CMAKE_CURRENT_BINARY_DIR} ${port})
    endforeach()
endif()
