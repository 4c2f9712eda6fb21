# cmake --install: programs and rooms are installed where they are declared; here is the rest.
include(CMakePackageConfigHelpers)
set(EXK_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/exk)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/exk ${PROJECT_BINARY_DIR}/include/exk
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
if(EXISTS ${PROJECT_SOURCE_DIR}/profiles)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/profiles DESTINATION ${CMAKE_INSTALL_DATADIR}/exk)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
    DESTINATION ${CMAKE_INSTALL_DOCDIR})

# find_package(exk) gives exk::loop and the other rooms.
install(EXPORT exkTargets NAMESPACE exk:: DESTINATION ${EXK_CMAKE_DIR})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/exkConfig.cmake.in exkConfig.cmake
    INSTALL_DESTINATION ${EXK_CMAKE_DIR})
write_basic_package_version_file(exkConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/exkConfig.cmake ${PROJECT_BINARY_DIR}/exkConfigVersion.cmake
    DESTINATION ${EXK_CMAKE_DIR})

# exk.pc names the core only, users before what they use.
get_property(rooms GLOBAL PROPERTY EXK_CORE_ROOMS)
list(REVERSE rooms)
list(TRANSFORM rooms PREPEND "-l")
list(JOIN rooms " " EXK_PC_LIBS)
file(RELATIVE_PATH EXK_PC_UP /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" EXK_PC_UP ${EXK_PC_UP})
configure_file(${CMAKE_CURRENT_LIST_DIR}/exk.pc.in exk.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/exk.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# Every program at once: cmake --build --preset release --target programs
get_property(programs GLOBAL PROPERTY EXK_PROGRAMS)
add_custom_target(programs DEPENDS ${programs})

# Man pages, made of each program's own --help.
if(HELP2MAN AND NOT EXK_INSTRUMENTED AND NOT CMAKE_CROSSCOMPILING)
    set(pages)
    foreach(program ${programs})
        set(page ${PROJECT_BINARY_DIR}/man/${program}.1)
        set(about ${CMAKE_CURRENT_LIST_DIR}/man/${program}.h2m)
        if(NOT EXISTS ${about})
            message(FATAL_ERROR "exk: ${program} has no ${about}: two lines, [name] and what it does")
        endif()
        add_custom_command(OUTPUT ${page}
            COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/man
            COMMAND ${CMAKE_COMMAND} -E env ARGP_HELP_FMT=rmargin=200 ${HELP2MAN} --no-info --section=1 --manual=exk
                --include=${about}
                --output=${page} ${PROJECT_BINARY_DIR}/bin/${program}
            COMMAND sh ${CMAKE_CURRENT_LIST_DIR}/man/examples.sh
                ${PROJECT_BINARY_DIR}/bin/${program} ${page}
            DEPENDS ${program} ${about} ${CMAKE_CURRENT_LIST_DIR}/man/examples.sh VERBATIM)
        list(APPEND pages ${page})
    endforeach()
    add_custom_target(man_pages ALL DEPENDS ${pages})
    add_dependencies(programs man_pages) # so that what ./drill built can be installed
    install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()
