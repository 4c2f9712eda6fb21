exk_test(unit test_arrivals SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_arrivals.c NEEDS exk::link)
exk_test(unit test_gate SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_gate.c NEEDS exk::command)
exk_test(unit test_key_file SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_key_file.c NEEDS exk::command)
