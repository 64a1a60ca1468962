// SPDX-License-Identifier: MIT
// Ticks that the programs of test_pace.c took when this was written, in the default and in the
// small capacities: a row a family, a column a way. The rows are what `test_pace write` and
// `test_pace_small write` print.
#ifndef PACE_H
#define PACE_H

#include <stdint.h> // uint32_t

static const uint32_t pace_ticks[2][10][7] = {
    {
        {14310, 21099, 21021, 14004, 19824, 20739, 19385}, // long lines
        {1002, 1765, 1890, 309, 1154, 1368, 428}, // smooth micro-segments
        {1025, 1789, 1905, 330, 1117, 1271, 618}, // rough micro-segments
        {488, 648, 745, 72, 259, 367, 218}, // five micrometres
        {56, 565, 438, 35, 108, 98, 108}, // ten nanometres
        {16926, 26755, 26882, 15098, 29591, 38445, 26863}, // lines and arcs
        {2511, 5720, 5894, 1597, 5254, 5755, 2869}, // small arcs
        {6736, 13304, 13622, 5821, 11199, 13347, 8427}, // nearly straight
        {4535, 11541, 11805, 4209, 10131, 10998, 6849}, // zigzag
        {2226, 2424, 2448, 2202, 2517, 2630, 2447}, // creep
    },
    {
        {14310, 35394, 21021, 13982, 35323, 20894, 37535}, // long lines
        {1002, 1784, 1890, 312, 1312, 1638, 840}, // smooth micro-segments
        {1025, 1809, 1905, 311, 1244, 1516, 908}, // rough micro-segments
        {488, 660, 745, 102, 471, 496, 305}, // five micrometres
        {56, 208, 438, 36, 116, 103, 116}, // ten nanometres
        {16926, 35662, 26882, 15150, 45123, 38983, 45961}, // lines and arcs
        {2511, 5823, 5894, 1598, 6490, 6773, 3785}, // small arcs
        {6736, 15412, 13622, 5848, 15934, 13629, 12776}, // nearly straight
        {4535, 12206, 11805, 4202, 12590, 11892, 10071}, // zigzag
        {2226, 2436, 2448, 2150, 2420, 2461, 2357}, // creep
    },
};

#endif
