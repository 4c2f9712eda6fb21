# Controller and machine in two processes, commands, hostile traffic: a UDP port each (relay: and the next).
if(EXK_WITH_LCM)
    set(dir ${CMAKE_CURRENT_LIST_DIR}/two)
    add_executable(exk_relay ${dir}/relay.c)
    target_link_libraries(exk_relay PRIVATE exk::telemetry exk_warnings)
    add_executable(exk_last_status ${dir}/last_status.c)
    target_link_libraries(exk_last_status PRIVATE exk::telemetry exk_warnings)
    foreach(name same_bytes paced relay alone command)
        exk_test_port(port)
        exk_test_port(port_behind)
        exk_script_test(integration test_two_${name} ${dir}/${name}.sh
            ARGS ${PROJECT_BINARY_DIR}/bin ${PROJECT_SOURCE_DIR}/profiles ${port} ${port_behind}
                $<TARGET_FILE:exk_relay> $<TARGET_FILE:exk_last_status>)
    endforeach()
    add_executable(exk_hostile ${CMAKE_CURRENT_LIST_DIR}/hostile/hostile.c)
    target_link_libraries(exk_hostile PRIVATE exk::command exk::realtime exk_warnings)
    set(names bus logger)
    if(NOT EXK_INSTRUMENTED) # a sanitizer makes system calls of its own
        list(APPEND names quiet_flood)
    endif()
    foreach(name ${names})
        exk_test_port(port)
        exk_script_test(integration test_hostile_${name}
            ${CMAKE_CURRENT_LIST_DIR}/hostile/${name}.sh
            ARGS ${PROJECT_BINARY_DIR}/bin ${PROJECT_SOURCE_DIR}/profiles ${port} 0
                $<TARGET_FILE:exk_relay> $<TARGET_FILE:exk_last_status>
                $<TARGET_FILE:exk_hostile>)
    endforeach()
    # Paced runs against a wall clock of their own: nothing else beside them.
    set_tests_properties(test_two_paced test_two_alone test_hostile_bus PROPERTIES RUN_SERIAL ON)
endif()
