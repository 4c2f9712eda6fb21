exk_test(unit test_profile SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_profile.c NEEDS exk::config)
exk_test(unit test_profile_faults SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_profile_faults.c
    NEEDS exk::config)
exk_test(unit test_profile_files SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_profile_files.c
    NEEDS exk::config)
exk_test(unit test_job_csv SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_job_csv.c NEEDS exk::config)
