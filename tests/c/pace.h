// SPDX-License-Identifier: MIT
// Ticks that the programs of test_pace.c took when this was written, in the default and in the small
// capacities: a row a family, a column a way. The rows are what `test_pace write` and
// `test_pace_small write` print.
#ifndef PACE_H
#define PACE_H

#include <stdint.h> // uint32_t

static const uint32_t pace_ticks[2][10][7] = {
    {
        {14310, 21023, 21011, 13989, 21707, 25010, 19905}, // long lines
        {1002, 1766, 1890, 335, 1374, 1815, 726}, // smooth micro-segments
        {1025, 1789, 1904, 357, 1365, 1614, 1154}, // rough micro-segments
        {488, 649, 745, 95, 424, 570, 297}, // five micrometres
        {56, 821, 444, 35, 129, 117, 129}, // ten nanometres
        {16926, 26688, 26866, 15038, 30145, 48802, 26443}, // lines and arcs
        {2511, 5723, 5887, 1635, 5519, 6302, 3201}, // small arcs
        {6736, 13291, 13608, 5865, 12782, 16415, 8857}, // nearly straight
        {4535, 11528, 11792, 4209, 11167, 14611, 7349}, // zigzag
        {2226, 2423, 2448, 2154, 2492, 2527, 2399}, // creep
    },
    {
        {14310, 35379, 21011, 13989, 56931, 29814, 132776}, // long lines
        {1002, 1785, 1890, 333, 1530, 2385, 1142}, // smooth micro-segments
        {1025, 1808, 1905, 356, 1477, 2382, 1559}, // rough micro-segments
        {488, 660, 745, 152, 780, 1130, 391}, // five micrometres
        {56, 793, 444, 38, 142, 124, 142}, // ten nanometres
        {16926, 35801, 26866, 15140, 56027, 62696, 67816}, // lines and arcs
        {2511, 5808, 5887, 1643, 7191, 11615, 4403}, // small arcs
        {6736, 15370, 13608, 5865, 24151, 29401, 32002}, // nearly straight
        {4535, 12260, 11792, 4209, 19299, 29854, 24616}, // zigzag
        {2226, 2444, 2449, 2161, 2479, 2560, 2424}, // creep
    },
};

#endif
