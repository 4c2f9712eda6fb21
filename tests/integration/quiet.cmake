# The loop thread while it runs: no heap, no system call but the sleep.
if(EXK_WITH_LCM AND NOT EXK_INSTRUMENTED)
    set(dir ${CMAKE_CURRENT_LIST_DIR}/quiet)
    add_library(exk_heap_count SHARED ${dir}/heap_count.c)
    target_link_libraries(exk_heap_count PRIVATE ${CMAKE_DL_LIBS})
    exk_script_test(integration test_loop_no_heap ${dir}/heap.sh ARGS ${PROJECT_BINARY_DIR}/bin
        ${PROJECT_SOURCE_DIR}/profiles $<TARGET_FILE:exk_heap_count>)
    exk_script_test(integration test_loop_no_system_call ${dir}/system_calls.sh
        ARGS ${PROJECT_BINARY_DIR}/bin ${PROJECT_SOURCE_DIR}/profiles)
endif()
