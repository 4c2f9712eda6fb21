exk_test(accuracy test_noise_statistics SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_noise_statistics.c
    NEEDS exk::noise)
