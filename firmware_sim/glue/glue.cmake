# SPDX-License-Identifier: MIT
# os: os.h on a kernel of the user's own checkout, in place of ../os.
#
#   -DUCOS2_DIR=…      µC/OS-II: Source, Ports, Cfg
#   -DUCOS3_DIR=…      µC/OS-III; uC-CPU and uC-LIB lie beside it, or UCCPU_DIR and UCLIB_DIR say
#                      where
#   -DFREERTOS_DIR=…   the FreeRTOS kernel: tasks.c, queue.c, include, portable
#
# NCK_KERNEL_CONFIG_DIR: a folder with the configuration headers of µC/OS; without it the templates
# of the checkout are used. The headers in ucos2 and ucos3 come before either: they include the
# next of their name and add what it leaves out.
enable_language(ASM)
set(NCK_KERNEL_CONFIG_DIR "" CACHE PATH "Configuration headers of the kernel, before its templates")
set(glue "${CMAKE_CURRENT_LIST_DIR}")

if(UCOS2_DIR)
    set(port "${UCOS2_DIR}/Ports/ARM-Cortex-M/ARMv7-M")
    set(glue_source ucos2.c)
    set(kernel_sources "${UCOS2_DIR}/Source/ucos_ii.c" # includes the others
        "${port}/os_cpu_c.c" "${port}/GNU/os_cpu_a.S" "${port}/GNU/os_dbg.c")
    set(own_includes "${glue}/ucos2")
    set(kernel_includes "${UCOS2_DIR}/Source" "${port}/GNU" "${UCOS2_DIR}/Cfg/Template")
elseif(UCOS3_DIR)
    cmake_path(GET UCOS3_DIR PARENT_PATH beside)
    if(NOT UCCPU_DIR) # not cached: another UCOS3_DIR has others beside it
        set(UCCPU_DIR "${beside}/uC-CPU")
    endif()
    if(NOT UCLIB_DIR)
        set(UCLIB_DIR "${beside}/uC-LIB")
    endif()
    set(port "${UCOS3_DIR}/Ports/ARM-Cortex-M/ARMv7-M")
    set(processor "${UCCPU_DIR}/ARM-Cortex-M/ARMv7-M")
    set(glue_source ucos3.c)
    file(GLOB kernel_sources "${UCOS3_DIR}/Source/os*.c" "${UCLIB_DIR}/lib_*.c")
    list(APPEND kernel_sources "${port}/os_cpu_c.c" "${port}/GNU/os_cpu_a.S"
        "${UCCPU_DIR}/cpu_core.c" "${processor}/cpu_c.c" "${processor}/GNU/cpu_a.s")
    set(own_includes "${glue}/ucos3")
    set(kernel_includes "${UCOS3_DIR}/Source" "${port}/GNU" "${UCCPU_DIR}" "${processor}/GNU"
        "${UCLIB_DIR}" "${UCOS3_DIR}/Cfg/Template" "${UCCPU_DIR}/Cfg/Template"
        "${UCLIB_DIR}/Cfg/Template")
else()
    if(NCK_CORE STREQUAL "m4f")
        set(port "${FREERTOS_DIR}/portable/GCC/ARM_CM4F")
    else()
        set(port "${FREERTOS_DIR}/portable/GCC/ARM_CM7/r0p1")
    endif()
    set(glue_source freertos.c)
    set(kernel_sources "${FREERTOS_DIR}/tasks.c" "${FREERTOS_DIR}/queue.c" "${FREERTOS_DIR}/list.c"
        "${port}/port.c")
    set(own_includes "") # one file of settings: ours, or the user's
    set(kernel_includes "${FREERTOS_DIR}/include" "${port}" "${glue}/freertos")
endif()
if(NCK_KERNEL_CONFIG_DIR)
    list(PREPEND kernel_includes "${NCK_KERNEL_CONFIG_DIR}")
endif()
list(PREPEND kernel_includes ${own_includes})

# The kernel's files are its authors' and compile without our warnings.
add_library(kernel OBJECT ${kernel_sources})
target_include_directories(kernel PRIVATE ${kernel_includes} "${CMAKE_CURRENT_SOURCE_DIR}")

add_library(os STATIC "${glue}/os.c" "${glue}/${glue_source}" $<TARGET_OBJECTS:kernel>)
target_include_directories(os PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
target_include_directories(os SYSTEM PRIVATE ${kernel_includes})
target_link_libraries(os PRIVATE nck_flags)
