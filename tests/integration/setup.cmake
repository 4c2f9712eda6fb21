# The front door without its network: apt entries, the pin of Unity, refusals, wrong use.
foreach(part entries pin refusals)
    exk_script_test(integration test_setup_${part} ${CMAKE_CURRENT_LIST_DIR}/setup/${part}.sh
        ARGS ${PROJECT_SOURCE_DIR})
endforeach()
