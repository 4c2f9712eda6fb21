# Our warnings, for our own code only. Generated LCM code is compiled without them.
add_library(exk_warnings INTERFACE)
target_compile_options(exk_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wstrict-prototypes
    -Wmissing-prototypes -Wold-style-definition -Wundef -Wvla -Wcast-qual -Wwrite-strings
    -Wswitch-enum -Wpointer-arith -Wformat=2 -Wnull-dereference
    -ffp-contract=off
    $<$<BOOL:${EXK_WERROR}>:-Werror>)

if(EXK_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all
        -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
endif()
if(EXK_COVERAGE)
    add_compile_options(--coverage -fprofile-update=atomic)
    add_link_options(--coverage)
endif()
