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
        {1002, 1765, 1890, 275, 1030, 1155, 428}, // smooth micro-segments
        {1025, 1789, 1905, 303, 1068, 1358, 495}, // rough micro-segments
        {488, 648, 745, 74, 274, 366, 218}, // five micrometres
        {56, 565, 438, 35, 108, 98, 108}, // ten nanometres
        {16926, 26755, 26882, 15024, 29470, 37981, 26235}, // lines and arcs
        {2511, 5720, 5894, 1616, 5157, 5583, 2862}, // small arcs
        {6736, 13304, 13622, 5821, 11213, 13644, 8491}, // nearly straight
        {4535, 11541, 11805, 4211, 10132, 10978, 7044}, // zigzag
        {2226, 2424, 2448, 2179, 2491, 2604, 2447}, // creep
    },
    {
        {14310, 35394, 21021, 13982, 35323, 20894, 37535}, // long lines
        {1002, 1784, 1890, 294, 1297, 1499, 822}, // smooth micro-segments
        {1025, 1809, 1905, 293, 1205, 1442, 908}, // rough micro-segments
        {488, 660, 745, 96, 451, 476, 305}, // five micrometres
        {56, 208, 438, 36, 116, 103, 116}, // ten nanometres
        {16926, 35662, 26882, 15122, 45144, 38516, 43673}, // lines and arcs
        {2511, 5823, 5894, 1617, 6457, 6514, 3785}, // small arcs
        {6736, 15412, 13622, 5848, 15899, 13926, 13341}, // nearly straight
        {4535, 12206, 11805, 4208, 12597, 11878, 10456}, // zigzag
        {2226, 2436, 2448, 2157, 2433, 2502, 2357}, // creep
    },
};

#endif
