# SPDX-License-Identifier: MIT
# The module pycnc._nck: face headers → preprocessor → cdef → generated C → one abi3 module.
# The module pycnc._nck_tp: one function, the door to plans and runs with the capacities that the
# planner module for LinuxCNC is compiled with.
find_package(Python 3.11 REQUIRED COMPONENTS Interpreter Development.Module)

file(GLOB host_headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/csrc" csrc/host/*.h)
list(FILTER host_headers EXCLUDE REGEX "_math\\.h$")
file(GLOB_RECURSE all_headers CONFIGURE_DEPENDS csrc/*.h firmware_sim/*.h)
set(definitions ${NCK_CAPACITY_HOST})
list(TRANSFORM definitions PREPEND "--define=")

add_custom_command(
    OUTPUT _nck.c
    COMMAND Python::Interpreter "${PROJECT_SOURCE_DIR}/cmake/make_binding.py"
            --cc "${CMAKE_C_COMPILER}" --module pycnc._nck --out _nck.c
            --include "${PROJECT_SOURCE_DIR}/csrc" --include "${PROJECT_SOURCE_DIR}/firmware_sim"
            --capacities nck/base/limits.h
            ${definitions} nck/nck_tools.h ${host_headers} sim.h sim_build.h sim_door.h
            host_serve.h app/outcome.h
            board/exits.h
    DEPENDS cmake/make_binding.py cmake/capacities.cmake ${all_headers}
    VERBATIM)

python_add_library(_nck MODULE _nck.c)
target_link_libraries(_nck PRIVATE sim nck_host)
set_target_properties(_nck PROPERTIES SUFFIX ".abi3.so")
install(TARGETS _nck DESTINATION pycnc)

# What a program may have in it, and records, are as in pycnc._nck; look-ahead is the module's.
file(READ "${PROJECT_SOURCE_DIR}/adapters/linuxcnc/Makefile" tp_makefile)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS adapters/linuxcnc/Makefile)
string(REGEX MATCH "-DNCK_WINDOW=[^\n]*" tp_capacities "${tp_makefile}")
string(REGEX MATCHALL "NCK_[A-Z_]+=[0-9]+" tp_capacities "${tp_capacities}")
set(tp_all ${NCK_CAPACITY_HOST})
list(FILTER tp_all EXCLUDE REGEX "^NCK_(WINDOW|CELL_MAX|PROFILE|CLOCKED)=")
nck_add_libraries(_tp ${tp_all} ${tp_capacities})
add_custom_command(
    OUTPUT _nck_tp.c
    COMMAND Python::Interpreter "${PROJECT_SOURCE_DIR}/cmake/make_binding.py"
            --cc "${CMAKE_C_COMPILER}" --module pycnc._nck_tp --out _nck_tp.c
            --include "${PROJECT_SOURCE_DIR}/firmware_sim" --capacities limits.h sim_door.h
    DEPENDS cmake/make_binding.py firmware_sim/sim_door.h
    VERBATIM)
python_add_library(_nck_tp MODULE _nck_tp.c)
target_link_libraries(_nck_tp PRIVATE sim_tp nck_host_tp)
set_target_properties(_nck_tp PROPERTIES SUFFIX ".abi3.so")
install(TARGETS _nck_tp DESTINATION pycnc)

# The planner module for LinuxCNC is compiled on the machine that it is for.
add_custom_command(
    OUTPUT adapter/nck/nck.c
    COMMAND Python::Interpreter "${PROJECT_SOURCE_DIR}/cmake/amalgamate.py" --out adapter/nck
    DEPENDS cmake/amalgamate.py ${all_headers} ${nck_sources}
    VERBATIM)
add_custom_target(adapter ALL DEPENDS adapter/nck/nck.c)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/adapters/linuxcnc" DESTINATION pycnc/adapters
        PATTERN "README.md" EXCLUDE)
install(DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/adapter/nck" DESTINATION pycnc/adapters/linuxcnc)

# The kernels and the headers that they include stand beside the Python files.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/opencl" DESTINATION pycnc)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/csrc/nck" DESTINATION pycnc/csrc
        FILES_MATCHING PATTERN "limits.h" PATTERN "real.h" PATTERN "records.h" PATTERN "*_math.h")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/csrc/host" DESTINATION pycnc/csrc
        FILES_MATCHING PATTERN "unit.h" PATTERN "*_math.h")

# What a wheel is made of and needs, for whoever has to account for it (PEP 770).
if(SKBUILD_METADATA_DIR)
    configure_file(cmake/sbom.cdx.json.in sbom/pycnc.cdx.json @ONLY)
    install(FILES "${CMAKE_CURRENT_BINARY_DIR}/sbom/pycnc.cdx.json"
            DESTINATION "${SKBUILD_METADATA_DIR}/sboms")
endif()
