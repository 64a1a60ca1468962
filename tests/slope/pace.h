// SPDX-License-Identifier: MIT
// Ticks that the programs of test_pace.c took when this was written, in the default and in the
// small capacities: a row a family, a column a way. The rows are what `test_pace write` and
// `test_pace_small write` print.
#ifndef PACE_H
#define PACE_H

#include <stdint.h> // uint32_t

static const uint32_t pace_ticks[2][10][5] = {
    {
        {14310, 21099, 14004, 19727, 19173}, // long lines
        {1002, 1765, 308, 1142, 418}, // smooth micro-segments
        {1025, 1789, 330, 1118, 510}, // rough micro-segments
        {488, 648, 73, 256, 207}, // five micrometres
        {71, 565, 35, 97, 97}, // ten nanometres
        {16926, 34578, 14989, 29395, 25789}, // lines and arcs
        {2511, 7487, 1617, 5051, 2610}, // small arcs
        {6736, 13304, 5819, 11184, 8375}, // nearly straight
        {4535, 11541, 4212, 9980, 6994}, // zigzag
        {2226, 2512, 2155, 2413, 2352}, // creep
    },
    {
        {14310, 35394, 13982, 34822, 35839}, // long lines
        {1002, 1784, 318, 1300, 766}, // smooth micro-segments
        {1025, 1809, 325, 1248, 851}, // rough micro-segments
        {488, 660, 96, 434, 285}, // five micrometres
        {56, 208, 35, 97, 97}, // ten nanometres
        {16926, 53839, 15086, 44623, 42821}, // lines and arcs
        {2511, 8234, 1616, 6102, 3280}, // small arcs
        {6736, 15412, 5846, 14997, 12631}, // nearly straight
        {4535, 12206, 4209, 12633, 9831}, // zigzag
        {2226, 2524, 2136, 2419, 2350}, // creep
    },
};

#endif
