# SPDX-License-Identifier: MIT
# nck_add_board_image(TARGET [script]): start-up code, semihosting and the linker script of the core
# for an executable. `script` is another one of this folder than <core>.ld. A core without doubles
# gets ../soft_double as well.
include("${CMAKE_CURRENT_LIST_DIR}/../soft_double/soft_double.cmake")

function(nck_add_board_image target)
    set(board "${CMAKE_CURRENT_FUNCTION_LIST_DIR}")
    set(script "${ARGV1}")
    if(NOT script)
        set(script ${NCK_CORE}.ld)
    endif()
    target_sources(${target} PRIVATE "${board}/startup.c" "${board}/board.c")
    target_include_directories(${target} PRIVATE "${board}/..") # "board/board.h"
    target_link_options(${target} PRIVATE
        -nostartfiles "-L${board}" "-T${script}" -Wl,--gc-sections -Wl,--fatal-warnings)
    set_target_properties(${target} PROPERTIES SUFFIX .elf
        LINK_DEPENDS "${board}/${script};${board}/sections.ld")
    if(NCK_CORE STREQUAL "m4f")
        soft_double_add(${target})
    endif()
endfunction()
