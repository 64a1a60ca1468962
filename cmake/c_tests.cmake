# SPDX-License-Identifier: MIT
# The C tests, tests/<room>/test_*.c: one program for each room and capacity set, tests_<room> and
# tests_<room>_small, which runs the test that it is asked for (tests/c/run.c). A test that brings a
# source of the kernel with it has a program of its own, test_<name>.
# Bits are the same at any level (tests/package/test_bits.py): what is shipped is compiled at the
# level it is shipped with, what is not in two thirds of the time.
set(nck_soon -O1)
nck_add_libraries(_small ${NCK_CAPACITY_SMALL})
target_compile_options(nck_small PRIVATE ${nck_soon})
nck_add_app(_small)

# nck_add_test_program(NAME SOURCE …): one program of several tests. Every test is written with a
# main of its own, which goes by the file's name here.
function(nck_add_test_program name)
    set(prototypes "")
    set(list "")
    foreach(source IN LISTS ARGN)
        cmake_path(GET source STEM stem)
        file(STRINGS ${source} head REGEX "^int main\\(")
        if(head MATCHES "char")
            string(APPEND prototypes "int ${stem}(int count, char **words);\n")
            string(APPEND list " TEST_WITH(${stem})")
        else()
            string(APPEND prototypes "int ${stem}(void);\n")
            string(APPEND list " TEST(${stem})")
        endif()
        set_source_files_properties(${source} PROPERTIES COMPILE_DEFINITIONS main=${stem})
    endforeach()
    set(folder "${CMAKE_CURRENT_BINARY_DIR}/tests_of/${name}")
    file(CONFIGURE OUTPUT "${folder}/tests_of_program.h" CONTENT
        "${prototypes}#define TESTS_OF_PROGRAM(TEST, TEST_WITH)${list}\n")
    add_executable(${name} tests/c/run.c ${ARGN})
    target_compile_options(${name} PRIVATE "SHELL:-include ${folder}/tests_of_program.h")
    target_include_directories(${name} PRIVATE tests/c)
    target_compile_options(${name} PRIVATE -O1) # what takes the time is the kernel, not its tests
endfunction()

file(GLOB test_folders CONFIGURE_DEPENDS tests/*)
foreach(folder IN LISTS test_folders)
    cmake_path(GET folder FILENAME room)
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/test_*.c)
    set(shared ${sources})
    foreach(source IN LISTS sources)
        file(STRINGS ${source} brought REGEX "^#include \"nck/.*\\.c\"")
        if(brought)
            list(REMOVE_ITEM shared ${source})
        endif()
    endforeach()
    foreach(suffix IN ITEMS "" _small)
        set(programs "")
        if(shared)
            nck_add_test_program(tests_${room}${suffix} ${shared})
            list(APPEND programs tests_${room}${suffix})
        endif()
        foreach(source IN LISTS sources)
            cmake_path(GET source STEM stem)
            if(NOT source IN_LIST shared)
                add_executable(${stem}${suffix} ${source})
                target_include_directories(${stem}${suffix} PRIVATE tests/c)
                list(APPEND programs ${stem}${suffix})
            endif()
        endforeach()
        foreach(program IN LISTS programs)
            target_link_libraries(${program} PRIVATE
                app${suffix} sim${suffix} nck_host${suffix} os hal_switches nck_flags)
        endforeach()
    endforeach()
endforeach()

# What rooms 1 and 2 make of programs, for who compares it.
add_executable(blocks_of tests/c/blocks_of.c)
target_link_libraries(blocks_of PRIVATE nck_host nck_flags)

# Builds that leave out rooms and planners: what is left of them runs, if it is asked for.
set(nck_lean_tests tests/base/test_link.c tests/decode/test_decode_motion.c
    tests/kernel/test_left_out.c tests/tick/test_interpolate.c)
list(TRANSFORM nck_lean_tests PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
foreach(set IN ITEMS LINEAR JERK)
    string(TOLOWER "_${set}" suffix)
    add_library(nck${suffix} STATIC EXCLUDE_FROM_ALL ${nck_sources})
    target_include_directories(nck${suffix} PUBLIC csrc)
    target_compile_definitions(nck${suffix} PUBLIC ${NCK_CAPACITY_${set}})
    target_link_libraries(nck${suffix} PUBLIC m PRIVATE nck_flags)
    target_compile_options(nck${suffix} PRIVATE ${nck_soon})
    nck_add_test_program(tests_lean${suffix} ${nck_lean_tests})
    target_link_libraries(tests_lean${suffix} PRIVATE nck${suffix} nck_flags)
    set_target_properties(tests_lean${suffix} PROPERTIES EXCLUDE_FROM_ALL ON)
endforeach()

# Fuzz targets need clang's driver. In the small capacities rings wrap and fill up soon; in the
# default ones there are variables, calls and cycles. Code at fixed addresses: what the fuzzer tries
# follows them.
file(GLOB fuzz_sources CONFIGURE_DEPENDS tests/house/fuzz/*.c)
foreach(source IN LISTS fuzz_sources)
    cmake_path(GET source STEM name)
    foreach(suffix IN ITEMS "" _small)
        if(NCK_FUZZ)
            add_executable(fuzz_${name}${suffix} ${source})
            target_link_options(fuzz_${name}${suffix} PRIVATE -fsanitize=fuzzer -no-pie)
            target_link_libraries(fuzz_${name}${suffix} PRIVATE sim${suffix} nck_flags)
        endif()
    endforeach()
endforeach()
