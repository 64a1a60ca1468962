// SPDX-License-Identifier: MIT
// Ticks that the programs of test_pace.c took when this was written, in the default and in the
// small capacities: a row a family, a column a way. The rows are what `test_pace write` and
// `test_pace_small write` print.
#ifndef PACE_H
#define PACE_H

#include <stdint.h> // uint32_t

static const uint32_t pace_ticks[2][10][3] = {
    {
        {14310, 21099, 14004}, // long lines
        {1002, 1765, 308}, // smooth micro-segments
        {1025, 1789, 330}, // rough micro-segments
        {488, 648, 73}, // five micrometres
        {71, 565, 35}, // ten nanometres
        {16926, 34578, 14989}, // lines and arcs
        {2511, 7487, 1617}, // small arcs
        {6736, 13304, 5819}, // nearly straight
        {4535, 11541, 4212}, // zigzag
        {2226, 2512, 2155}, // creep
    },
    {
        {14310, 35394, 13982}, // long lines
        {1002, 1784, 318}, // smooth micro-segments
        {1025, 1809, 325}, // rough micro-segments
        {488, 660, 96}, // five micrometres
        {56, 208, 35}, // ten nanometres
        {16926, 53839, 15086}, // lines and arcs
        {2511, 8234, 1616}, // small arcs
        {6736, 15412, 5846}, // nearly straight
        {4535, 12206, 4209}, // zigzag
        {2226, 2524, 2136}, // creep
    },
};

#endif
