# exk_room(control SOURCES pid.c ilc.c NEEDS exk::base m)
# One static library exk::<room> that names the rooms it needs; a call in a forbidden direction
# does not link.
function(exk_room name)
    cmake_parse_arguments(ROOM "" "" "SOURCES;NEEDS;PRIVATE" ${ARGN})
    add_library(exk_${name} STATIC ${ROOM_SOURCES})
    add_library(exk::${name} ALIAS exk_${name})
    target_include_directories(exk_${name} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
        $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(exk_${name} PUBLIC ${ROOM_NEEDS}
        PRIVATE $<BUILD_INTERFACE:exk_warnings> ${ROOM_PRIVATE})
    set_target_properties(exk_${name} PROPERTIES EXPORT_NAME ${name})
    install(TARGETS exk_${name} EXPORT exkTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    set_property(GLOBAL APPEND PROPERTY EXK_ROOMS exk_${name})
endfunction()

# exk_program(exk-kin SOURCES main.c NEEDS exk::kinematics)
function(exk_program name)
    cmake_parse_arguments(PROGRAM "" "" "SOURCES;NEEDS" ${ARGN})
    exk_lacks(lacks ${name} ${PROGRAM_NEEDS})
    if(lacks)
        return()
    endif()
    add_executable(${name} ${PROGRAM_SOURCES})
    target_link_libraries(${name} PRIVATE ${PROGRAM_NEEDS} exk_warnings)
    set_target_properties(${name} PROPERTIES
        RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
    install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    set_property(GLOBAL APPEND PROPERTY EXK_PROGRAMS ${name})
endfunction()

# Sets var in the caller when one of the targets named after it is not built here, and says so.
function(exk_lacks var what)
    set(${var} OFF PARENT_SCOPE)
    foreach(need ${ARGN})
        if(need MATCHES "^exk" AND NOT TARGET ${need})
            message(STATUS "exk: ${what} is off: ${need} is not built")
            set(${var} ON PARENT_SCOPE)
        endif()
    endforeach()
endfunction()

# exk_test(unit test_pid SOURCES test_pid.c NEEDS exk::control)
# A Unity test; its label is the folder (unit, accuracy, integration). It links what it names only.
function(exk_test label name)
    cmake_parse_arguments(TEST "" "" "SOURCES;NEEDS;ARGS" ${ARGN})
    exk_lacks(lacks ${name} ${TEST_NEEDS})
    if(lacks)
        return()
    endif()
    add_executable(${name} ${TEST_SOURCES})
    target_link_libraries(${name} PRIVATE ${TEST_NEEDS} exk_warnings exk_unity m)
    target_compile_definitions(${name} PRIVATE
        EXK_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data"
        EXK_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
        EXK_BIN_DIR="${PROJECT_BINARY_DIR}/bin")
    add_test(NAME ${name} COMMAND ${name} ${TEST_ARGS})
    set_tests_properties(${name} PROPERTIES LABELS ${label} TIMEOUT 120)
endfunction()

# exk_script_test(integration test_install run.sh ARGS ...): a bash script; exit 77 means skipped.
function(exk_script_test label name script)
    cmake_parse_arguments(TEST "" "" "ARGS" ${ARGN})
    add_test(NAME ${name} COMMAND bash ${script} ${TEST_ARGS})
    set_tests_properties(${name} PROPERTIES LABELS ${label} TIMEOUT 120 SKIP_RETURN_CODE 77)
endfunction()

# exk_test_port(port): a UDP port no other test of this build tree has; trees start apart, so that
# two of them can be tested on one machine at the same time.
function(exk_test_port var)
    get_property(port GLOBAL PROPERTY EXK_NEXT_PORT)
    if(NOT port)
        string(SHA256 tree ${PROJECT_BINARY_DIR})
        string(SUBSTRING ${tree} 0 6 tree)
        math(EXPR port "20000 + (0x${tree} % 400) * 100")
    endif()
    set(${var} ${port} PARENT_SCOPE)
    math(EXPR port "${port} + 1")
    set_property(GLOBAL PROPERTY EXK_NEXT_PORT ${port})
endfunction()
