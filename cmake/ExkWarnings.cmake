# Our warnings, for our own code only. Generated LCM code is compiled without them.
add_library(exk_warnings INTERFACE)
target_compile_options(exk_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wstrict-prototypes
    -Wmissing-prototypes -Wold-style-definition -Wundef -Wvla -Wcast-qual -Wwrite-strings
    -Wswitch-enum -Wpointer-arith -Wformat=2 -Wnull-dereference
    $<$<C_COMPILER_ID:Clang>:-Wno-enum-float-conversion> # counts are enumerators
    -ffp-contract=off
    $<$<BOOL:${EXK_WERROR}>:-Werror>)

# Each of these builds is of its own; names, variables and pages are looked at in the plain ones.
if(EXK_SANITIZE OR EXK_TSAN OR EXK_FUZZ OR EXK_COVERAGE OR EXK_MCDC)
    set(EXK_INSTRUMENTED ON)
endif()

function(exk_instrument)
    add_compile_options(${ARGN})
    add_link_options(${ARGN})
endfunction()

if(EXK_SANITIZE OR EXK_FUZZ)
    exk_instrument(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
endif()
if(EXK_FUZZ)
    exk_instrument(-fsanitize=fuzzer-no-link)
endif()
if(EXK_TSAN)
    exk_instrument(-fsanitize=thread)
endif()
if(EXK_COVERAGE)
    exk_instrument(--coverage -O0 -fprofile-update=atomic)
endif()
if(EXK_MCDC)
    exk_instrument(-fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc
        -fprofile-update=atomic)
endif()
