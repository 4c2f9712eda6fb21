exk_test(unit test_plan SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_plan.c NEEDS exk::plan)
exk_test(unit test_job SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_job.c NEEDS exk::plan)
