# SPDX-License-Identifier: MIT
# Capacity sets: values for csrc/nck/base/limits.h. The default set is limits.h itself.
# tests/size/table.py reads this file too.

# A three-axis machine in a small microcontroller.
set(NCK_CAPACITY_SMALL
    NCK_AXIS_MAX=3 NCK_WINDOW=32 NCK_CELL_MAX=16 NCK_TOOL_MAX=8 NCK_CORNER_SPAN=8 NCK_LINE_MAX=128
    NCK_PROFILE=64 NCK_SMOOTH_SPAN=16 NCK_VARIABLES=0 NCK_CALL_DEPTH=0
    NCK_CYCLES=0 NCK_COMP_SPAN=32)

# The Python module: look-ahead over more than 10 000 blocks.
set(NCK_CAPACITY_HOST
    NCK_WINDOW=16384 NCK_CELL_MAX=4096 NCK_TOOL_MAX=1000 NCK_LINE_MAX=4096 NCK_PROFILE=4096
    NCK_SMOOTH_SPAN=1024 NCK_VARIABLES=1024 NCK_CALL_DEPTH=64
    NCK_COMP_SPAN=256)

# Sources that macro programs and cycles alone need: on a microcontroller small before fast.
set(NCK_MACRO_SOURCES call control cycle expression jump oword power sign system variables)
list(TRANSFORM NCK_MACRO_SOURCES
    REPLACE "(.+)" "${CMAKE_CURRENT_LIST_DIR}/../csrc/nck/prep/1_decode/\\1.c")
if(CMAKE_CROSSCOMPILING)
    set_source_files_properties(${NCK_MACRO_SOURCES} PROPERTIES COMPILE_OPTIONS -Os)
endif()
