# SPDX-License-Identifier: MIT
# Bulk planning for the processor at hand: one source file for each number type and processor, and
# threads by OpenMP. Both are left out where the compiler lacks them
# (-DCMAKE_DISABLE_FIND_PACKAGE_OpenMP=ON builds without threads in any case).
include(CheckCCompilerFlag)
include(CheckCSourceCompiles)
check_c_compiler_flag(-mavx2 NCK_COMPILER_HAS_AVX2)
find_package(OpenMP COMPONENTS C)

set(nck_variant_options "")
if(NOT NCK_SANITIZE)
    set(nck_variant_options -O3) # loops become vectors
endif()

function(nck_add_host_variants target)
    set(plain csrc/host/envelope/float_plain.c csrc/host/envelope/double_plain.c)
    set(avx2 csrc/host/envelope/float_avx2.c csrc/host/envelope/double_avx2.c)
    target_sources(${target} PRIVATE ${plain})
    set_source_files_properties(${plain} csrc/host/triad.c PROPERTIES
        COMPILE_OPTIONS "${nck_variant_options}")
    if(NCK_COMPILER_HAS_AVX2)
        target_sources(${target} PRIVATE ${avx2})
        target_compile_definitions(${target} PRIVATE NCK_HOST_AVX2)
        set_source_files_properties(${avx2} PROPERTIES
            COMPILE_OPTIONS "${nck_variant_options};-mavx2")
    endif()
    if(OpenMP_C_FOUND)
        target_link_libraries(${target} PRIVATE OpenMP::OpenMP_C)
    endif()
endfunction()

# The kernel's solvers for AVX2, too, chosen when the module is loaded: where the compiler and the
# C library can.
function(nck_clone_lanes)
    set(clones "__attribute__((flatten, target_clones(\"avx2\", \"default\")))")
    set(CMAKE_REQUIRED_FLAGS -Werror)
    check_c_source_compiles("${clones} int f(void) { return 0; } int main(void) { return f(); }"
        NCK_COMPILER_HAS_CLONES)
    if(NCK_COMPILER_HAS_CLONES)
        add_compile_definitions("NCK_LANES=${clones}")
    endif()
endfunction()
