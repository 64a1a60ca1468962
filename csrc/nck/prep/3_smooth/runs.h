// SPDX-License-Identifier: MIT
// Inside room 3: the clocked run in work, in builds that have one.
#ifndef NCK_PREP_RUNS_H
#define NCK_PREP_RUNS_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t nck_clocked_t

// The run's state; where there is none it must not be asked for anything. Cost: constant.
static inline nck_clocked_t *nck_runs_of(nck_smooth_t *self) {
    (void)self; // of no use without one
    return NCK_OPTIMAL_AT(self, clocked);
}

// 1 if paths within a tolerance are clocked. Cost: constant.
static inline int nck_runs_are_clocked(const nck_smooth_t *self) {
    return NCK_HAS_OPTIMAL && self->terms->knot_s > 0.0;
}

// 1 if a clocked run is in work. Cost: constant.
static inline int nck_runs_is_open(const nck_smooth_t *self) {
    (void)self; // of no use without one
    return (int)NCK_OPTIMAL_VALUE(self, clocked.open);
}

#endif
