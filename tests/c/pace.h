// SPDX-License-Identifier: MIT
// Ticks that the programs of test_pace.c took when this was written, in the default and in the
// small capacities: a row a family, a column a way. The rows are what `test_pace write` and
// `test_pace_small write` print.
#ifndef PACE_H
#define PACE_H

#include <stdint.h> // uint32_t

static const uint32_t pace_ticks[2][10][7] = {
    {
        {14310, 21023, 21021, 13982, 21486, 20921, 19759}, // long lines
        {1002, 1766, 1890, 309, 1151, 1368, 431}, // smooth micro-segments
        {1025, 1789, 1905, 330, 1119, 1271, 619}, // rough micro-segments
        {488, 649, 745, 72, 260, 367, 219}, // five micrometres
        {56, 816, 442, 35, 108, 98, 108}, // ten nanometres
        {16926, 26680, 26882, 15106, 30320, 38561, 27255}, // lines and arcs
        {2511, 5726, 5894, 1597, 5294, 5760, 3125}, // small arcs
        {6736, 13294, 13622, 5862, 12641, 13509, 8978}, // nearly straight
        {4535, 11525, 11805, 4202, 11119, 11824, 6847}, // zigzag
        {2226, 2423, 2448, 2202, 2587, 2630, 2448}, // creep
    },
    {
        {14310, 35394, 21021, 13982, 40344, 20921, 136188}, // long lines
        {1002, 1784, 1890, 312, 1294, 1638, 785}, // smooth micro-segments
        {1025, 1808, 1905, 311, 1230, 1516, 913}, // rough micro-segments
        {488, 660, 745, 102, 457, 496, 300}, // five micrometres
        {56, 788, 442, 36, 116, 103, 116}, // ten nanometres
        {16926, 35662, 26882, 15150, 48133, 39559, 49662}, // lines and arcs
        {2511, 5823, 5894, 1597, 6391, 6837, 3805}, // small arcs
        {6736, 15410, 13622, 5862, 18083, 14612, 15249}, // nearly straight
        {4535, 12206, 11805, 4202, 15468, 15035, 11870}, // zigzag
        {2226, 2434, 2448, 2150, 2429, 2461, 2357}, // creep
    },
};

#endif
