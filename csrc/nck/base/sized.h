// SPDX-License-Identifier: MIT
// Names that carry the build. Whoever has other capacities or another version than the library has
// records of other sizes: for them the library has no such function, and nothing links.
#ifndef NCK_BASE_SIZED_H
#define NCK_BASE_SIZED_H

#include "nck/base/limits.h"  // the capacities
#include "nck/base/version.h" // NCK_VERSION_MAJOR NCK_VERSION_MINOR

// What a function is called for the linker: its name and what the sizes of records hang on. A
// capacity is a plain decimal number.
#define NCK_SIZED(name) \
    NCK_SIZED_OF(name, NCK_VERSION_MAJOR, NCK_VERSION_MINOR, NCK_AXIS_MAX, NCK_LINE_MAX, \
                 NCK_TOOL_MAX, NCK_OWN_M_MAX, NCK_VARIABLES, NCK_CALL_DEPTH, NCK_LANGUAGE, \
                 NCK_CYCLES, NCK_CONTOUR, NCK_COMP_SPAN, NCK_WINDOW, \
                 NCK_CORNER_SPAN, NCK_FILTER_TAPS, NCK_PROFILE, NCK_CLOCKED, \
                 NCK_CELL_MAX)
// The same, with the values put in for the macros.
#define NCK_SIZED_OF(...) NCK_SIZED_BY(__VA_ARGS__)
// The same, joined.
#define NCK_SIZED_BY(name, major, minor, axes, line, tools, own, variables, calls, language, \
                     cycles, contour, comp, window, corner, taps, profile, clocked, \
                     cells) \
    name##_v##major##_##minor##_axes##axes##_line##line##_tools##tools##_m##own \
    ##_var##variables##_calls##calls##_language##language##_cycles##cycles \
    ##_contour##contour##_comp##comp##_window##window##_corner##corner \
    ##_taps##taps##_profile##profile##_clocked##clocked##_cells##cells

#endif
