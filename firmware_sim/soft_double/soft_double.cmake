# SPDX-License-Identifier: MIT
# soft_double_add(TARGET): an executable for a core without doubles takes soft_double.c's quotient,
# root and comparisons in place of the library's.
set(soft_double_folder "${CMAKE_CURRENT_LIST_DIR}")

function(soft_double_add target)
    target_sources(${target} PRIVATE "${soft_double_folder}/soft_double.c")
    target_include_directories(${target} PRIVATE "${soft_double_folder}/..")
    foreach(name __aeabi_ddiv sqrt
            __aeabi_dcmplt __aeabi_dcmpgt __aeabi_dcmple __aeabi_dcmpge __aeabi_dcmpeq)
        target_link_options(${target} PRIVATE "-Wl,--wrap=${name}")
    endforeach()
endfunction()
