# What is used from outside, each said at configure time. Third-party headers are SYSTEM.
find_package(Threads REQUIRED)

find_path(RANDOM123_INCLUDE_DIR Random123/philox.h REQUIRED)
add_library(exk_random123 INTERFACE)
target_include_directories(exk_random123 SYSTEM INTERFACE
    $<BUILD_INTERFACE:${RANDOM123_INCLUDE_DIR}>)

function(exk_find_library target header library)
    string(TOUPPER ${library} VAR)
    find_path(${VAR}_INCLUDE_DIR ${header} REQUIRED)
    find_library(${VAR}_LIBRARY ${library} REQUIRED)
    add_library(${target} INTERFACE)
    target_include_directories(${target} SYSTEM INTERFACE
        $<BUILD_INTERFACE:${${VAR}_INCLUDE_DIR}>)
    target_link_libraries(${target} INTERFACE ${${VAR}_LIBRARY})
    message(STATUS "exk: ${library} ${${VAR}_LIBRARY}")
endfunction()

exk_find_library(exk_inih ini.h inih)
exk_find_library(exk_zlib zlib.h z)
exk_find_library(exk_sodium sodium.h sodium)
if(EXK_WITH_LCM)
    exk_find_library(exk_lcm lcm/lcm.h lcm)
    exk_find_library(exk_jansson jansson.h jansson)
    find_program(LCM_GEN lcm-gen REQUIRED)
endif()

if(BUILD_TESTING)
    if(NOT EXISTS "${UNITY_SOURCE_DIR}/unity.c")
        message(WARNING "exk: UNITY_SOURCE_DIR does not hold unity.c: tests are off. "
            "Run ./check once, or pass -DUNITY_SOURCE_DIR=DIR.")
        set(BUILD_TESTING OFF)
    else()
        add_library(exk_unity STATIC ${UNITY_SOURCE_DIR}/unity.c)
        target_include_directories(exk_unity SYSTEM PUBLIC ${UNITY_SOURCE_DIR})
        target_compile_definitions(exk_unity PUBLIC UNITY_INCLUDE_DOUBLE
            UNITY_DOUBLE_PRECISION=1e-12)
    endif()
endif()
