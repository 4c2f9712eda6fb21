# The installed tree from a user's side. Instrumented builds would need their flags in the user's.
if(NOT EXK_INSTRUMENTED)
    foreach(way cmake pkg-config)
        exk_script_test(integration test_consumer_${way} ${CMAKE_CURRENT_LIST_DIR}/consumer/run.sh
            ARGS ${way} ${PROJECT_BINARY_DIR} ${CMAKE_C_COMPILER} ${CMAKE_INSTALL_LIBDIR})
    endforeach()
    get_property(programs GLOBAL PROPERTY EXK_PROGRAMS)
    exk_script_test(integration test_installed_files
        ${CMAKE_CURRENT_LIST_DIR}/consumer/files.sh
        ARGS ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR} ${CMAKE_INSTALL_LIBDIR} ${programs})
endif()
