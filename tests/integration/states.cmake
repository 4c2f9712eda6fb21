# The picture of the state machine comes from its table: the text kept beside it must be the same.
add_executable(exk-states-dot ${CMAKE_CURRENT_LIST_DIR}/states/dot.c)
target_link_libraries(exk-states-dot PRIVATE exk::loop exk_warnings)
set_target_properties(exk-states-dot PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
exk_script_test(integration test_states_picture ${CMAKE_CURRENT_LIST_DIR}/states/picture.sh
    ARGS $<TARGET_FILE:exk-states-dot> ${PROJECT_SOURCE_DIR}/docs/img)
