// SPDX-License-Identifier: MIT
// Ticks that the programs of test_pace.c took when this was written, in the default and in the
// small capacities: a row a family, a column a way. The rows are what `test_pace write` and
// `test_pace_small write` print.
#ifndef PACE_H
#define PACE_H

#include <stdint.h> // uint32_t

static const uint32_t pace_ticks[2][10][7] = {
    {
        {14310, 21023, 21021, 13989, 21549, 22571, 19989}, // long lines
        {1002, 1766, 1889, 335, 1374, 1817, 726}, // smooth micro-segments
        {1025, 1789, 1904, 357, 1365, 1616, 1155}, // rough micro-segments
        {488, 649, 745, 95, 424, 569, 297}, // five micrometres
        {56, 816, 442, 35, 129, 118, 129}, // ten nanometres
        {16926, 26688, 26882, 15106, 30165, 48657, 27769}, // lines and arcs
        {2511, 5723, 5897, 1634, 5521, 6310, 3202}, // small arcs
        {6736, 13291, 13622, 5862, 12807, 15902, 8858}, // nearly straight
        {4535, 11528, 11805, 4209, 11109, 14822, 7350}, // zigzag
        {2226, 2423, 2448, 2154, 2549, 2527, 2482}, // creep
    },
    {
        {14310, 35394, 21021, 13989, 39589, 24025, 132048}, // long lines
        {1002, 1785, 1890, 333, 1537, 2386, 1138}, // smooth micro-segments
        {1025, 1808, 1905, 355, 1497, 2375, 1563}, // rough micro-segments
        {488, 660, 745, 152, 780, 1123, 391}, // five micrometres
        {56, 788, 442, 38, 144, 125, 144}, // ten nanometres
        {16926, 35662, 26882, 15203, 52297, 61073, 58075}, // lines and arcs
        {2511, 5810, 5897, 1642, 7167, 11606, 4337}, // small arcs
        {6736, 15410, 13622, 5862, 23336, 27567, 32164}, // nearly straight
        {4535, 12216, 11805, 4209, 19268, 28948, 24652}, // zigzag
        {2226, 2444, 2449, 2161, 2514, 2553, 2424}, // creep
    },
};

#endif
