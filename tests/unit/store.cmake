exk_test(unit test_store SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_store.c NEEDS exk::store)
exk_test(unit test_store_power SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_store_power.c
    ${CMAKE_CURRENT_LIST_DIR}/power_fs.c NEEDS exk::store)
