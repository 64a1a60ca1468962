# SPDX-License-Identifier: MIT
# What `cmake --install` puts where, for find_package(nck) and pkg-config, and the pair of files
# (target "amalgamation") for projects that take sources.
#
#   component nck    libnck.a, its headers, nckConfig.cmake, nck.pc
#   component host   libnck_host.a and its headers: bulk planning on a PC
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The capacities of this build become the defaults of the installed limits.h: a caller who defines
# nothing has the sizes that the library was compiled with.
set(nck_limits "${CMAKE_CURRENT_BINARY_DIR}/package/limits.h")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS csrc/nck/base/limits.h)
file(CONFIGURE OUTPUT "${nck_limits}" CONTENT "${nck_limits_text}" @ONLY)

set(nck_cmake_folder "${CMAKE_INSTALL_LIBDIR}/cmake/nck")
target_include_directories(nck INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
install(TARGETS nck EXPORT nck ARCHIVE COMPONENT nck)
install(EXPORT nck NAMESPACE nck:: FILE nckTargets.cmake DESTINATION "${nck_cmake_folder}"
        COMPONENT nck)
install(DIRECTORY csrc/nck DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT nck
        FILES_MATCHING PATTERN "*.h" PATTERN "limits.h" EXCLUDE)
install(FILES "${nck_limits}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/nck/base" COMPONENT nck)
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT nck)

if(TARGET nck_host)
    set_target_properties(nck_host PROPERTIES EXPORT_NAME host)
    target_include_directories(nck_host INTERFACE
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/nck_host>)
    install(TARGETS nck_host EXPORT nck_host ARCHIVE COMPONENT host)
    install(EXPORT nck_host NAMESPACE nck:: FILE nckHostTargets.cmake
            DESTINATION "${nck_cmake_folder}" COMPONENT host)
    install(DIRECTORY csrc/host DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/nck_host" COMPONENT host
            FILES_MATCHING PATTERN "*.h" PATTERN "envelope" EXCLUDE)
endif()

configure_package_config_file(cmake/nckConfig.cmake.in package/nckConfig.cmake
    INSTALL_DESTINATION "${nck_cmake_folder}")
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(package/nckConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/package/nckConfig.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/package/nckConfigVersion.cmake"
        DESTINATION "${nck_cmake_folder}" COMPONENT nck)

# The .pc file finds the prefix from where it lies, so that the tree may be moved.
file(RELATIVE_PATH nck_up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" nck_up "${nck_up}")
configure_file(cmake/nck.pc.in package/nck.pc @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/package/nck.pc"
        DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT nck)

find_package(Python 3.11 QUIET COMPONENTS Interpreter)
if(Python_FOUND)
    set(definitions ${nck_capacities})
    list(TRANSFORM definitions PREPEND "--define=")
    add_custom_target(amalgamation
        COMMAND Python::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/cmake/amalgamate.py"
                --out "${CMAKE_CURRENT_BINARY_DIR}/amalgamation/nck" ${definitions}
        COMMENT "nck.h and nck.c in ${CMAKE_CURRENT_BINARY_DIR}/amalgamation/nck"
        VERBATIM)
endif()
