// SPDX-License-Identifier: MIT
// Ticks that the programs of test_pace.c took when this was written, in the default and in the
// small capacities: a row a family, a column a way. The rows are what `test_pace write` and
// `test_pace_small write` print.
#ifndef PACE_H
#define PACE_H

#include <stdint.h> // uint32_t

static const uint32_t pace_ticks[2][10][7] = {
    {
        {14310, 21102, 21021, 14004, 20067, 20739, 19505}, // long lines
        {1002, 1767, 1890, 309, 1155, 1368, 431}, // smooth micro-segments
        {1025, 1791, 1905, 330, 1118, 1271, 618}, // rough micro-segments
        {488, 650, 745, 72, 260, 367, 219}, // five micrometres
        {56, 566, 438, 35, 109, 98, 109}, // ten nanometres
        {16926, 26760, 26882, 15098, 29810, 38445, 26932}, // lines and arcs
        {2511, 5737, 5894, 1597, 5386, 5755, 2870}, // small arcs
        {6736, 13318, 13622, 5821, 11395, 13347, 8591}, // nearly straight
        {4535, 11550, 11805, 4209, 10514, 10983, 6849}, // zigzag
        {2226, 2425, 2448, 2202, 2519, 2630, 2449}, // creep
    },
    {
        {14310, 35394, 21021, 13982, 35342, 20894, 37549}, // long lines
        {1002, 1784, 1890, 312, 1312, 1638, 840}, // smooth micro-segments
        {1025, 1809, 1905, 311, 1244, 1516, 908}, // rough micro-segments
        {488, 660, 745, 102, 471, 496, 305}, // five micrometres
        {56, 208, 438, 36, 116, 103, 116}, // ten nanometres
        {16926, 35662, 26882, 15150, 45131, 38983, 45962}, // lines and arcs
        {2511, 5823, 5894, 1598, 6490, 6773, 3785}, // small arcs
        {6736, 15412, 13622, 5848, 15943, 13629, 12810}, // nearly straight
        {4535, 12206, 11805, 4202, 12601, 11896, 10071}, // zigzag
        {2226, 2436, 2448, 2150, 2420, 2461, 2357}, // creep
    },
};

#endif
