// SPDX-License-Identifier: MIT
// Ticks that the programs of test_pace.c took when this was written, in the default and in the
// small capacities: a row a family, a column a way. The rows are what `test_pace write` and
// `test_pace_small write` print.
#ifndef PACE_H
#define PACE_H

#include <stdint.h> // uint32_t

static const uint32_t pace_ticks[2][10][7] = {
    {
        {14310, 21099, 21021, 14004, 19818, 20736, 19378}, // long lines
        {1002, 1765, 1890, 308, 1165, 1319, 427}, // smooth micro-segments
        {1025, 1789, 1905, 330, 1145, 1251, 543}, // rough micro-segments
        {488, 648, 745, 73, 271, 375, 218}, // five micrometres
        {56, 565, 438, 35, 99, 87, 99}, // ten nanometres
        {16926, 26755, 26882, 14989, 29429, 37920, 25813}, // lines and arcs
        {2511, 5720, 5894, 1617, 5085, 5407, 2649}, // small arcs
        {6736, 13304, 13622, 5819, 11213, 13658, 8330}, // nearly straight
        {4535, 11541, 11805, 4212, 10134, 10976, 6993}, // zigzag
        {2226, 2424, 2448, 2179, 2491, 2604, 2447}, // creep
    },
    {
        {14310, 35394, 21021, 13982, 35317, 20891, 37529}, // long lines
        {1002, 1784, 1890, 318, 1335, 1520, 801}, // smooth micro-segments
        {1025, 1809, 1905, 325, 1348, 1474, 908}, // rough micro-segments
        {488, 660, 745, 96, 451, 476, 305}, // five micrometres
        {56, 208, 438, 35, 100, 87, 100}, // ten nanometres
        {16926, 35662, 26882, 15086, 45133, 38502, 43542}, // lines and arcs
        {2511, 5823, 5894, 1616, 6300, 6553, 3456}, // small arcs
        {6736, 15412, 13622, 5846, 15861, 13940, 13103}, // nearly straight
        {4535, 12206, 11805, 4209, 12628, 11880, 10291}, // zigzag
        {2226, 2436, 2448, 2136, 2414, 2502, 2357}, // creep
    },
};

#endif
