if(TARGET exk_tools)
    exk_test(unit test_out_file SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_out_file.c NEEDS exk_tools)
    exk_test(unit test_gnuplot SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_gnuplot.c NEEDS exk_tools)
    exk_test(unit test_noise_word SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_noise_word.c
        NEEDS exk_tools)
endif()
exk_test(unit test_hole_report SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_hole_report.c
    NEEDS exk_holes_parts)
exk_test(unit test_hole_picture SOURCES ${CMAKE_CURRENT_LIST_DIR}/test_hole_picture.c
    NEEDS exk_holes_parts)
