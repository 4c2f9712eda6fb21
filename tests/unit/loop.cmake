exk_test(unit test_loop SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_loop.c NEEDS exk::loop)
exk_test(unit test_state SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_state.c NEEDS exk::loop)
exk_test(unit test_brief SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_brief.c NEEDS exk::loop)
