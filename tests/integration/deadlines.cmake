# The whole run policy of exk-loop under an injected clock: its ticks, with the real loop and publisher.
if(TARGET exk_rig AND TARGET exk_link AND TARGET exk_command)
    exk_test(integration test_deadlines SOURCES ${CMAKE_CURRENT_LIST_DIR}/deadlines/test_deadlines.c
        ${PROJECT_SOURCE_DIR}/src/app/ticks.c
        NEEDS exk::rig exk::telemetry exk::realtime exk::link exk::command)
    target_include_directories(test_deadlines PRIVATE ${PROJECT_SOURCE_DIR}/src/app)
endif()
