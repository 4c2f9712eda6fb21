# The core stays pure: what its archives ask for, and that they hold no mutable variable.
# Sanitizers and gcov put their own names and counters in, so these run on the other builds.
get_property(core GLOBAL PROPERTY EXK_CORE_ROOMS)
set(archives)
foreach(room ${core})
    list(APPEND archives $<TARGET_FILE:${room}>)
endforeach()
set(guard ${CMAKE_CURRENT_LIST_DIR}/guard)
if(NOT EXK_INSTRUMENTED)
    add_library(exk_impure STATIC ${guard}/impure.c)
    exk_script_test(integration test_core_names ${guard}/names.sh ARGS ${CMAKE_NM} ${archives})
    exk_script_test(integration test_core_variables ${guard}/variables.sh
        ARGS ${CMAKE_OBJDUMP} ${archives})
    exk_script_test(integration test_core_guards_find ${guard}/finds.sh
        ARGS ${CMAKE_NM} ${CMAKE_OBJDUMP} $<TARGET_FILE:exk_impure>)
endif()

# Every program answers --help and --version and refuses what it does not know.
get_property(programs GLOBAL PROPERTY EXK_PROGRAMS)
foreach(program ${programs})
    exk_script_test(integration test_options_${program} ${guard}/options.sh
        ARGS ${PROJECT_BINARY_DIR}/bin/${program} ${PROJECT_VERSION})
    exk_script_test(integration test_man_${program} ${guard}/man.sh
        ARGS ${PROJECT_BINARY_DIR}/bin/${program} ${PROJECT_BINARY_DIR}/man/${program}.1)
endforeach()

exk_script_test(integration test_pages_are_there ${guard}/pages.sh ARGS ${PROJECT_SOURCE_DIR})
