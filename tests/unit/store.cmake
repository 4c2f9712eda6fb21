exk_test(unit test_store SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_store.c NEEDS exk::store)
