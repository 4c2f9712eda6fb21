if(TARGET exk_input)
    exk_test(unit test_stop_signal SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_stop_signal.c NEEDS exk::input)
endif()
