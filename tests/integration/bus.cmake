# Recorder, stock LCM tools, doctor and spy with real processes on a real bus: a UDP port each.
if(EXK_WITH_LCM)
    set(dir ${CMAKE_CURRENT_LIST_DIR}/bus)
    foreach(name record stock_tools ends loss late terminal refuses full_disk no_route doctor spy)
        exk_test_port(port)
        exk_script_test(integration test_bus_${name} ${dir}/${name}.sh
            ARGS ${PROJECT_BINARY_DIR}/bin ${PROJECT_SOURCE_DIR}/profiles ${port})
    endforeach()
endif()
