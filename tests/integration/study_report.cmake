# The report of exk-study: whole, standing alone, refusing what it must. Drawn by a browser in the
# Release build alone: the page is the same bytes whatever the build, and a browser takes its time.
if(TARGET exk-study)
    set(dir ${CMAKE_CURRENT_LIST_DIR}/study_report)
    add_executable(check-page ${dir}/check_page.c)
    target_link_libraries(check-page PRIVATE exk_warnings)
    set(names page refuses)
    if(CMAKE_BUILD_TYPE STREQUAL "Release")
        list(APPEND names browser)
    endif()
    foreach(name ${names})
        exk_script_test(integration test_study_report_${name} ${dir}/${name}.sh
            ARGS ${PROJECT_BINARY_DIR}/bin ${PROJECT_SOURCE_DIR}/profiles
                ${CMAKE_CURRENT_BINARY_DIR})
    endforeach()
endif()
