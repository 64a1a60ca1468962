// SPDX-License-Identifier: MIT
// Ticks that the programs of test_pace.c took when this was written, in the default and in the
// small capacities: a row a family, a column a way. The rows are what `test_pace write` and
// `test_pace_small write` print.
#ifndef PACE_H
#define PACE_H

#include <stdint.h> // uint32_t

static const uint32_t pace_ticks[2][10][2] = {
    {
        {14310, 21099}, // long lines
        {1002, 1765}, // smooth micro-segments
        {1025, 1789}, // rough micro-segments
        {488, 648}, // five micrometres
        {71, 565}, // ten nanometres
        {16926, 34578}, // lines and arcs
        {2511, 7487}, // small arcs
        {6736, 13304}, // nearly straight
        {4535, 11541}, // zigzag
        {2226, 2512}, // creep
    },
    {
        {14310, 35394}, // long lines
        {1002, 1784}, // smooth micro-segments
        {1025, 1809}, // rough micro-segments
        {488, 660}, // five micrometres
        {56, 208}, // ten nanometres
        {16926, 53839}, // lines and arcs
        {2511, 8234}, // small arcs
        {6736, 15412}, // nearly straight
        {4535, 12206}, // zigzag
        {2226, 2524}, // creep
    },
};

#endif
