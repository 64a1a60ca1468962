// SPDX-License-Identifier: MIT
// Two motions that overlap at a corner: the end of one, from rest backward, and the begin of the
// next. Both are straight there, and the place is their sum.
#ifndef NCK_BASE_OVERLAP_MATH_H
#define NCK_BASE_OVERLAP_MATH_H

#include "nck/base/machine.h"   // nck_machine_t
#include "nck/base/real.h"      // nck_fabs nck_min
#include "nck/base/root_math.h" // nck_root_cube

// While the first motion has the distance δ left to go and the second has come as far, the path is
//        δ·|out − in|
// off the corner, further than at any other time; its unit tangents are `in` and `out`. Returns the
// distance that keeps to the tolerance; turn = |out − in| > 0. Cost: a division.
static inline double nck_overlap_distance(double tolerance, double turn) {
    return tolerance / turn;
}

// How long either motion takes for the distance d next to the corner: d = j·t³/6.
static inline double nck_overlap_time(double d, double j) { return nck_root_cube(6.0 * d / j); }

// Both motions have their jerk to the same side in time: the deceleration of the one goes, the
// acceleration of the other comes. On an axis that both move along the same way it adds up; where
// they move opposite ways only the larger counts. Returns the sum's largest share of an axis' jerk.
// j: along either path [path mm/s³]. Cost: linear in the axes.
static inline double nck_overlap_jerk(const nck_machine_t *machine, int axes, const double *in,
                                      const double *out, const double j[2]) {
    double most = 0.0;
    for (int x = 0; x < axes; x++) {
        const double first = in[x] * j[0];
        const double second = out[x] * j[1];
        const double sum = first * second > 0.0
                               ? nck_fabs(first) + nck_fabs(second)
                               : nck_max(nck_fabs(first), nck_fabs(second));
        if (sum > 0.0) most = nck_max(most, sum / machine->axis[x].j_max);
    }
    return most;
}

// 1 if an axis moves in both. Cost: linear in the axes.
static inline int nck_overlap_shares(int axes, const double *in, const double *out) {
    for (int x = 0; x < axes; x++) {
        if (in[x] * out[x] != 0.0) return 1;
    }
    return 0;
}

// Where they move opposite ways their accelerations add up, to no more than t·j at any time. Returns
// how long the motions may overlap by that [s]. Cost: linear in the axes.
static inline double nck_overlap_most(const nck_machine_t *machine, int axes, const double *in,
                                      const double *out, const double j[2]) {
    double most = 1e9;
    for (int x = 0; x < axes; x++) {
        const double first = in[x] * j[0];
        const double second = out[x] * j[1];
        if (!(first * second < 0.0)) continue;
        const double larger = nck_max(nck_fabs(first), nck_fabs(second));
        most = nck_min(most, machine->axis[x].a_max / larger);
    }
    return most;
}

#endif
