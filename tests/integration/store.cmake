# kill -9 while a store is saved; exk_killed 10000 FOLDER is the long form.
if(TARGET exk::store)
    add_executable(exk_killed ${CMAKE_CURRENT_LIST_DIR}/store/killed.c)
    target_link_libraries(exk_killed PRIVATE exk::store exk_warnings)
    exk_script_test(integration test_store_killed ${CMAKE_CURRENT_LIST_DIR}/store/killed.sh
        ARGS $<TARGET_FILE:exk_killed> 300)
endif()
