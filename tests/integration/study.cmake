# exk-study as a user runs it: the same bytes by every way, killed and resumed, refusals.
if(TARGET exk-study)
    set(dir ${CMAKE_CURRENT_LIST_DIR}/study)
    foreach(name same_bytes killed stopped refuses calibrate)
        exk_script_test(integration test_study_${name} ${dir}/${name}.sh
            ARGS ${PROJECT_BINARY_DIR}/bin ${PROJECT_SOURCE_DIR}/profiles)
    endforeach()
    exk_test(integration test_study_one_seed SOURCES ${dir}/one_seed.c NEEDS exk_study_lib
        exk::telemetry)
endif()
