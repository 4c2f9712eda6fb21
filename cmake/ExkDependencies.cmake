# What is used from outside, each said at configure time. Third-party headers are SYSTEM.
#
# exk_use(exk_zlib zlib.h z): an interface target when header and library are there, else none.
# Installed static libraries name it by -l, so that a consumer links the same library.
function(exk_use target header library)
    string(TOUPPER EXK_${library} VAR)
    find_path(${VAR}_INCLUDE_DIR ${header})
    find_library(${VAR}_LIBRARY ${library})
    mark_as_advanced(${VAR}_INCLUDE_DIR ${VAR}_LIBRARY)
    if(NOT ${VAR}_INCLUDE_DIR OR NOT ${VAR}_LIBRARY)
        message(STATUS "exk: ${library} (${header}): not found")
        return()
    endif()
    add_library(${target} INTERFACE)
    target_include_directories(${target} SYSTEM INTERFACE
        $<BUILD_INTERFACE:${${VAR}_INCLUDE_DIR}>)
    target_link_libraries(${target} INTERFACE
        $<BUILD_INTERFACE:${${VAR}_LIBRARY}> $<INSTALL_INTERFACE:${library}>)
    install(TARGETS ${target} EXPORT exkTargets)
    message(STATUS "exk: ${library}: ${${VAR}_LIBRARY}")
endfunction()

# exk_need(TARGET package why): stops with what to install when exk_use did not find it.
function(exk_need target package why)
    if(NOT TARGET ${target})
        message(FATAL_ERROR "exk: ${why} needs Debian's ${package}, which was not found. "
            "Run ./drill or ./check once, or install it: apt-get install ${package}")
    endif()
endfunction()

function(exk_say_program var name what)
    find_program(${var} ${name})
    mark_as_advanced(${var})
    if(${var})
        message(STATUS "exk: ${name}: ${${var}}")
    else()
        message(STATUS "exk: ${name}: not found; ${what}")
    endif()
endfunction()

find_package(Threads REQUIRED)

find_path(RANDOM123_INCLUDE_DIR Random123/philox.h)
if(NOT RANDOM123_INCLUDE_DIR)
    message(FATAL_ERROR "exk: the core needs Random123 (Random123/philox.h not found). "
        "Run ./drill or ./check once, or: apt-get install librandom123-dev")
endif()
add_library(exk_random123 INTERFACE)
target_include_directories(exk_random123 SYSTEM INTERFACE
    $<BUILD_INTERFACE:${RANDOM123_INCLUDE_DIR}>)

exk_use(exk_inih ini.h inih)
exk_use(exk_zlib zlib.h z)
exk_use(exk_sodium sodium.h sodium)
if(EXK_WITH_LCM)
    exk_use(exk_lcm lcm/lcm.h lcm)
    exk_use(exk_jansson jansson.h jansson)
    exk_need(exk_lcm liblcm-dev "EXK_WITH_LCM=ON")
    exk_need(exk_jansson libjansson-dev "EXK_WITH_LCM=ON")
    exk_need(exk_inih libinih-dev "EXK_WITH_LCM=ON")
    exk_need(exk_zlib zlib1g-dev "EXK_WITH_LCM=ON")
    exk_need(exk_sodium libsodium-dev "EXK_WITH_LCM=ON")
    find_program(LCM_GEN lcm-gen)
    if(NOT LCM_GEN)
        message(FATAL_ERROR "exk: EXK_WITH_LCM=ON needs lcm-gen: apt-get install liblcm-bin")
    endif()
    message(STATUS "exk: lcm-gen: ${LCM_GEN}")
endif()

exk_say_program(GNUPLOT gnuplot "the tools write tables but no pictures")
exk_say_program(JAVA java "exk-spy cannot run here")
exk_say_program(HELP2MAN help2man "no man pages")
exk_say_program(PKG_CONFIG pkg-config "the pkg-config file is installed but not tested")

# Unity, in this order: the folder that was given, what ./check fetched, the usual places, none.
if(BUILD_TESTING)
    if(UNITY_SOURCE_DIR AND NOT EXISTS "${UNITY_SOURCE_DIR}/unity.c")
        message(FATAL_ERROR "exk: UNITY_SOURCE_DIR=${UNITY_SOURCE_DIR} holds no unity.c. "
            "Name the folder that holds unity.c and unity.h, or leave it out.")
    endif()
    if(EXK_UNITY_DIR AND NOT EXISTS "${EXK_UNITY_DIR}/unity.c")
        unset(EXK_UNITY_DIR CACHE)
    endif()
    find_path(EXK_UNITY_DIR unity.c NO_DEFAULT_PATH
        HINTS ${UNITY_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/.deps/unity
        PATHS /usr/local/src/unity/src /usr/local/src/unity /usr/src/unity/src /usr/src/unity
            /usr/share/unity/src)
    mark_as_advanced(EXK_UNITY_DIR)
    if(EXK_UNITY_DIR)
        message(STATUS "exk: Unity: ${EXK_UNITY_DIR}")
        add_library(exk_unity STATIC ${EXK_UNITY_DIR}/unity.c)
        target_include_directories(exk_unity SYSTEM PUBLIC ${EXK_UNITY_DIR})
        target_compile_definitions(exk_unity PUBLIC UNITY_INCLUDE_DOUBLE
            UNITY_DOUBLE_PRECISION=1e-12)
        target_compile_options(exk_unity PUBLIC -Wno-cast-qual) # its array macros drop const
    else()
        message(STATUS "exk: Unity: not found, so the tests are off. Run ./check once (it fetches "
            "Unity), or pass -DUNITY_SOURCE_DIR=DIR with the folder of unity.c.")
        set(BUILD_TESTING OFF)
    endif()
endif()
