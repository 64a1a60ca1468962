# SPDX-License-Identifier: MIT
# Capacity sets: values for csrc/nck/base/limits.h. The default set is limits.h itself.
# tests/house/size/table.py reads this file too.

# A three-axis machine in a small microcontroller.
set(NCK_CAPACITY_SMALL
    NCK_AXIS_MAX=3 NCK_WINDOW=32 NCK_CELL_MAX=16 NCK_TOOL_MAX=8 NCK_OWN_M_MAX=4 NCK_CORNER_SPAN=8
    NCK_LINE_MAX=128 NCK_PROFILE=64 NCK_CLOCKED=0 NCK_VARIABLES=0 NCK_CALL_DEPTH=0
    NCK_CYCLES=0 NCK_LANGUAGE=3 NCK_CONTOUR=0 NCK_COMP_SPAN=16)

# The least: the linear slope on the exact path.
set(NCK_CAPACITY_LINEAR
    NCK_AXIS_MAX=3 NCK_WINDOW=16 NCK_CELL_MAX=16 NCK_TOOL_MAX=4 NCK_OWN_M_MAX=4 NCK_CORNER_SPAN=2
    NCK_LINE_MAX=128 NCK_PROFILE=0 NCK_CLOCKED=0 NCK_FILTER_TAPS=1 NCK_VARIABLES=0
    NCK_CALL_DEPTH=0 NCK_CYCLES=0 NCK_LANGUAGE=3 NCK_CONTOUR=0 NCK_COMP_SPAN=0)

# The same with the jerk-limited slope beside it, through a window of 64 nodes.
set(NCK_CAPACITY_JERK
    NCK_AXIS_MAX=3 NCK_WINDOW=16 NCK_CELL_MAX=16 NCK_TOOL_MAX=8 NCK_OWN_M_MAX=4 NCK_CORNER_SPAN=4
    NCK_LINE_MAX=128 NCK_PROFILE=64 NCK_CLOCKED=0 NCK_VARIABLES=0
    NCK_CALL_DEPTH=0 NCK_CYCLES=0 NCK_LANGUAGE=3 NCK_CONTOUR=0 NCK_COMP_SPAN=0)

# A mill with the jerk-limited slope and the words of its own alone.
set(NCK_CAPACITY_MILL
    NCK_AXIS_MAX=3 NCK_WINDOW=16 NCK_CELL_MAX=16 NCK_TOOL_MAX=8 NCK_OWN_M_MAX=4 NCK_CORNER_SPAN=4
    NCK_LINE_MAX=128 NCK_PROFILE=64 NCK_CLOCKED=0 NCK_LANGUAGE=0 NCK_VARIABLES=0
    NCK_CALL_DEPTH=0)

# The optimal slope for three axes, solved in single precision: a large microcontroller.
set(NCK_CAPACITY_OPTIMAL
    NCK_AXIS_MAX=3 NCK_WINDOW=64 NCK_CELL_MAX=32 NCK_TOOL_MAX=8 NCK_CORNER_SPAN=8 NCK_LINE_MAX=128
    NCK_PROFILE=64 NCK_CLOCKED=64 NCK_VARIABLES=0 NCK_CALL_DEPTH=0
    NCK_CYCLES=0 NCK_LANGUAGE=3 NCK_CONTOUR=0 NCK_COMP_SPAN=16)

# All of the language, nine axes, the optimal slope through 96 knots: the simulated controller.
set(NCK_CAPACITY_FULL
    NCK_WINDOW=128 NCK_CELL_MAX=64 NCK_CORNER_SPAN=32 NCK_PROFILE=256 NCK_CLOCKED=96)

# The Python module: look-ahead over more than 10 000 blocks.
set(NCK_CAPACITY_HOST
    NCK_WINDOW=16384 NCK_CELL_MAX=4096 NCK_TOOL_MAX=1000 NCK_LINE_MAX=4096 NCK_PROFILE=4096
    NCK_CLOCKED=256 NCK_VARIABLES=1024 NCK_CALL_DEPTH=64
    NCK_CONTOUR=1000 NCK_COMP_SPAN=256)

# Sources that no ordinary line needs, or a rare one: on a microcontroller small before fast.
set(NCK_RARE_SOURCES
    base/link_invariants base/machine base/thread front prep/3_smooth/divide prep/5_slope/terms)
foreach(name IN ITEMS state/finding state/variables number/bits number/integer number/power
        tongue/foreign tongue/printer tongue/turning modal/port modal/spindle place/comp
        place/layout place/place place/table place/tool macro/argument macro/call macro/control
        macro/expression macro/jump macro/keep macro/oword macro/sign macro/system motion/corner
        motion/fillet motion/knots motion/probe motion/slant motion/spline motion/tap motion/thread
        lathe/contour lathe/contour_cycle lathe/follow lathe/level lathe/rough lathe/turn
        cycle/cycle cycle/height line/block_in entry source)
    list(APPEND NCK_RARE_SOURCES prep/1_decode/${name})
endforeach()
foreach(name IN ITEMS clear contour entry give join judge level pieces ring shape toolcomp
        way)
    list(APPEND NCK_RARE_SOURCES prep/2_toolcomp/${name})
endforeach()
list(TRANSFORM NCK_RARE_SOURCES
    REPLACE "(.+)" "${CMAKE_CURRENT_LIST_DIR}/../csrc/nck/\\1.c")
if(CMAKE_CROSSCOMPILING)
    set_source_files_properties(${NCK_RARE_SOURCES} PROPERTIES COMPILE_OPTIONS -Os)
endif()

# The text of limits.h with capacities NAME=VALUE as its defaults; one that it does not have is
# refused.
function(nck_fill_in_capacities text_out)
    file(READ "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../csrc/nck/base/limits.h" text)
    foreach(capacity IN LISTS ARGN)
        string(REGEX REPLACE "=.*" "" name "${capacity}")
        if(NOT capacity MATCHES "^[A-Z_]+=(0|[1-9][0-9]*)$"
           OR NOT text MATCHES "\n#define ${name} [0-9]")
            message(FATAL_ERROR "NCK_CAPACITIES: limits.h has no capacity like ${capacity}")
        endif()
        string(REPLACE "=" " " filled_in "${capacity}")
        string(REGEX REPLACE "\n#define ${name} [0-9]+" "\n#define ${filled_in}" text "${text}")
    endforeach()
    set(${text_out} "${text}" PARENT_SCOPE)
endfunction()
