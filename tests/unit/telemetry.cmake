exk_test(unit test_ring SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_ring.c NEEDS exk::telemetry)
exk_test(unit test_wire SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_wire.c NEEDS exk::telemetry)
foreach(module event_file run_log publisher)
    exk_test(unit test_${module} SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_${module}.c
        ${CMAKE_CURRENT_LIST_DIR}/telemetry_samples.c NEEDS exk::telemetry)
endforeach()
