// SPDX-License-Identifier: MIT
// Ticks that the programs of test_pace.c took when this was written, in the default and in the
// small capacities: a row a family, a column a way. The rows are what `test_pace write` and
// `test_pace_small write` print.
#ifndef PACE_H
#define PACE_H

#include <stdint.h> // uint32_t

static const uint32_t pace_ticks[2][10][7] = {
    {
        {14310, 21023, 21021, 13982, 21487, 20921, 19947}, // long lines
        {1002, 1766, 1889, 331, 1331, 1599, 553}, // smooth micro-segments
        {1025, 1789, 1905, 334, 1288, 1572, 1181}, // rough micro-segments
        {488, 649, 745, 95, 419, 513, 244}, // five micrometres
        {56, 816, 442, 35, 129, 114, 129}, // ten nanometres
        {16926, 26688, 26882, 15100, 30104, 38017, 26386}, // lines and arcs
        {2511, 5723, 5897, 1601, 5246, 5656, 2602}, // small arcs
        {6736, 13291, 13622, 5855, 12688, 13900, 8988}, // nearly straight
        {4535, 11528, 11805, 4207, 11181, 12227, 7341}, // zigzag
        {2226, 2423, 2448, 2134, 2496, 2517, 2425}, // creep
    },
    {
        {14310, 35394, 21021, 13982, 39041, 20921, 126873}, // long lines
        {1002, 1785, 1890, 330, 1495, 1789, 1107}, // smooth micro-segments
        {1025, 1808, 1906, 332, 1457, 1779, 1614}, // rough micro-segments
        {488, 660, 745, 152, 773, 875, 347}, // five micrometres
        {56, 788, 442, 38, 144, 121, 144}, // ten nanometres
        {16926, 35662, 26882, 15196, 52517, 39001, 67109}, // lines and arcs
        {2511, 5810, 5897, 1606, 6914, 6167, 3885}, // small arcs
        {6736, 15410, 13622, 5855, 23147, 14936, 32351}, // nearly straight
        {4535, 12216, 11805, 4207, 19103, 15032, 24684}, // zigzag
        {2226, 2444, 2449, 2145, 2517, 2519, 2331}, // creep
    },
};

#endif
