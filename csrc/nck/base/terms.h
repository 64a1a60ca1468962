// SPDX-License-Identifier: MIT
// What the other rooms must know of the slope in force, in one place: 5_slope fills it.
#ifndef NCK_BASE_TERMS_H
#define NCK_BASE_TERMS_H

#include <stdint.h> // uint8_t

#include "nck/base/machine.h" // nck_machine_t

// The terms of a machine's slope.
typedef struct nck_terms {
    const nck_machine_t *machine; // whose terms they are
    uint8_t limits_jerk; // 1: the slope keeps to limits of jerk
    uint8_t limits_path; // 1: the path has limits of its own, before those of its axes
    uint8_t taps;        // the tick hands out the mean of so many periods; 1: no filter
    uint8_t axes;        // the machine's are among the first so many; the others never move
    double j_max;        // the most jerk along a path that a plan asks for [path mm/s³]
    double mix_s;        // how far in time accelerations are mixed: half the filter's length [s]
    double v_filter;     // by how much the speed at a node may pass the planned one [path mm/s]
    double knot_s;       // how long an interval of a clocked path lasts by its clock [s]; 0: there
                         // are none
    double knot_p;       // the least tolerance that such intervals are short enough for [mm]
    double knots_most;   // so many times as long at most where nothing is near; 1 at least
} nck_terms_t;

#endif
