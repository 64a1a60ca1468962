# SPDX-License-Identifier: MIT
# Capacity sets: values for csrc/nck/base/limits.h. The default set is limits.h itself.
# tests/size/table.py reads this file too.

# A three-axis machine in a small microcontroller.
set(NCK_CAPACITY_SMALL
    NCK_AXIS_MAX=3 NCK_WINDOW=32 NCK_CELL_MAX=16 NCK_TOOL_MAX=8 NCK_CORNER_SPAN=8 NCK_LINE_MAX=128
    NCK_PROFILE=64 NCK_SMOOTH_SPAN=16)

# The Python module: look-ahead over more than 10 000 blocks.
set(NCK_CAPACITY_HOST
    NCK_WINDOW=16384 NCK_CELL_MAX=4096 NCK_TOOL_MAX=1000 NCK_LINE_MAX=4096 NCK_PROFILE=4096
    NCK_SMOOTH_SPAN=1024)
