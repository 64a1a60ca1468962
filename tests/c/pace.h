// SPDX-License-Identifier: MIT
// Ticks that the programs of test_pace.c took when this was written, in the default and in the
// small capacities: a row a family, a column a way. The rows are what `test_pace write` and
// `test_pace_small write` print.
#ifndef PACE_H
#define PACE_H

#include <stdint.h> // uint32_t

static const uint32_t pace_ticks[2][10][7] = {
    {
        {14310, 21023, 21011, 13989, 21707, 25010, 19905}, // long lines
        {1002, 1766, 1890, 335, 1374, 1816, 726}, // smooth micro-segments
        {1025, 1789, 1904, 357, 1365, 1616, 1155}, // rough micro-segments
        {488, 649, 745, 95, 424, 569, 297}, // five micrometres
        {56, 816, 442, 35, 129, 117, 129}, // ten nanometres
        {16926, 26688, 26866, 15106, 30148, 48824, 26454}, // lines and arcs
        {2511, 5723, 5887, 1634, 5520, 6306, 3201}, // small arcs
        {6736, 13291, 13608, 5862, 12787, 16268, 8858}, // nearly straight
        {4535, 11528, 11792, 4209, 11167, 14618, 7350}, // zigzag
        {2226, 2423, 2448, 2154, 2492, 2527, 2399}, // creep
    },
    {
        {14310, 35379, 21011, 13989, 56950, 29814, 132849}, // long lines
        {1002, 1785, 1890, 333, 1531, 2385, 1139}, // smooth micro-segments
        {1025, 1808, 1905, 355, 1478, 2382, 1562}, // rough micro-segments
        {488, 660, 745, 152, 780, 1130, 391}, // five micrometres
        {56, 788, 442, 38, 142, 124, 142}, // ten nanometres
        {16926, 35801, 26866, 15203, 56047, 62762, 68116}, // lines and arcs
        {2511, 5808, 5887, 1642, 7172, 11612, 4327}, // small arcs
        {6736, 15370, 13608, 5862, 24067, 29153, 31982}, // nearly straight
        {4535, 12260, 11792, 4209, 19267, 29857, 24626}, // zigzag
        {2226, 2444, 2449, 2161, 2479, 2561, 2424}, // creep
    },
};

#endif
