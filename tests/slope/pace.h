// SPDX-License-Identifier: MIT
// Ticks that the programs of test_pace.c took when this was written, in the default and in the
// small capacities: a row a family, a column a way. The rows are what `test_pace write` and
// `test_pace_small write` print.
#ifndef PACE_H
#define PACE_H

#include <stdint.h> // uint32_t

static const uint32_t pace_ticks[2][10][7] = {
    {
        {14310, 21099, 21021, 14004, 19727, 20736, 19173}, // long lines
        {1002, 1765, 1890, 308, 1142, 1282, 418}, // smooth micro-segments
        {1025, 1789, 1905, 330, 1118, 1241, 510}, // rough micro-segments
        {488, 648, 745, 73, 256, 357, 207}, // five micrometres
        {71, 565, 438, 35, 97, 82, 97}, // ten nanometres
        {16926, 34578, 34347, 14989, 29395, 37875, 25789}, // lines and arcs
        {2511, 7487, 7615, 1617, 5051, 5325, 2610}, // small arcs
        {6736, 13304, 13622, 5819, 11184, 13639, 8375}, // nearly straight
        {4535, 11541, 11805, 4212, 9980, 10939, 6994}, // zigzag
        {2226, 2512, 2535, 2155, 2413, 2506, 2352}, // creep
    },
    {
        {14310, 35394, 21021, 13982, 34822, 20891, 35839}, // long lines
        {1002, 1784, 1890, 318, 1300, 1493, 766}, // smooth micro-segments
        {1025, 1809, 1905, 325, 1248, 1464, 851}, // rough micro-segments
        {488, 660, 745, 96, 434, 482, 285}, // five micrometres
        {56, 208, 438, 35, 97, 82, 97}, // ten nanometres
        {16926, 53839, 34347, 15086, 44623, 38457, 42821}, // lines and arcs
        {2511, 8234, 7615, 1616, 6102, 6651, 3280}, // small arcs
        {6736, 15412, 13622, 5846, 14997, 13922, 12631}, // nearly straight
        {4535, 12206, 11805, 4209, 12633, 11843, 9831}, // zigzag
        {2226, 2524, 2535, 2136, 2419, 2440, 2350}, // creep
    },
};

#endif
