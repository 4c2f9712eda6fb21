exk_test(unit test_ring SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_ring.c NEEDS exk::telemetry)
exk_test(unit test_wire SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_wire.c NEEDS exk::telemetry)
