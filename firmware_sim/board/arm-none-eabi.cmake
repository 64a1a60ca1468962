# SPDX-License-Identifier: MIT
# Cross compilation for a core of firmware_sim/board:
#
#   cmake --toolchain firmware_sim/board/arm-none-eabi.cmake -DNCK_CORE=m4f|m7|m55 …
#
# board.cmake, beside this file, makes an image out of a target.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES NCK_CORE)

set(NCK_CORE m7 CACHE STRING "m4f (single-precision FPU), m7 or m55 (double)")
if(NCK_CORE STREQUAL "m4f")
    set(core_options "-mcpu=cortex-m4 -mfpu=fpv4-sp-d16")
elseif(NCK_CORE STREQUAL "m7")
    set(core_options "-mcpu=cortex-m7 -mfpu=fpv5-d16")
elseif(NCK_CORE STREQUAL "m55")
    set(core_options "-mcpu=cortex-m55")
else()
    message(FATAL_ERROR "NCK_CORE is m4f, m7 or m55, not ${NCK_CORE}")
endif()
string(APPEND core_options " -mthumb -mfloat-abi=hard")
set(CMAKE_C_FLAGS_INIT "${core_options} -DNDEBUG -ffunction-sections -fdata-sections")
set(CMAKE_ASM_FLAGS_INIT "${core_options}") # without it the assembler takes another core
