exk_test(unit test_ring SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_ring.c NEEDS exk::telemetry)
exk_test(unit test_wire SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_wire.c NEEDS exk::telemetry)
foreach(module event_file run_log publisher)
    exk_test(unit test_${module} SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_${module}.c
        ${CMAKE_CURRENT_LIST_DIR}/telemetry_samples.c NEEDS exk::telemetry)
endforeach()
exk_test(unit test_bus SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_bus.c NEEDS exk::telemetry)
exk_test(unit test_path_points SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_path_points.c
    ${PROJECT_SOURCE_DIR}/host_tools/log/path_points.c NEEDS exk::telemetry exk::metrics)
if(TARGET test_path_points)
    target_include_directories(test_path_points PRIVATE ${PROJECT_SOURCE_DIR}/host_tools/log)
endif()
