# exk-kin as a real process: its CSV contract, and each refusal with its words.
if(TARGET exk-kin)
    foreach(part contract refusals)
        exk_script_test(integration test_kin_${part} ${CMAKE_CURRENT_LIST_DIR}/kin/${part}.sh
            ARGS $<TARGET_FILE:exk-kin> ${PROJECT_SOURCE_DIR})
    endforeach()
endif()
