// SPDX-License-Identifier: MIT
// Ramps of constant acceleration, in w = v².
#ifndef NCK_PREP_RAMP_MATH_H
#define NCK_PREP_RAMP_MATH_H

#include "nck/base/real.h" // nck_real nck_sqrt nck_min

// Duration of a piece of constant acceleration from v0 to v1 (not both zero):   q = 2·length/(v0 +
// v1)
static inline nck_real nck_ramp_duration(nck_real length, nck_real v0, nck_real v1) {
    return 2.0 * length / (v0 + v1);
}

// The acceleration of such a piece:   a = (w1 − w0)/(2·length)     (Cao et al. 2014, eq. 15)
static inline nck_real nck_ramp_accel(nck_real length, nck_real w0, nck_real w1) {
    return (w1 - w0) / (2.0 * length);
}

// Length of a ramp from w0 to w1 at |a|:   |w1 − w0|/(2a)         (Cao et al. 2014, eq. 6)
static inline nck_real nck_ramp_length(nck_real w0, nck_real w1, nck_real a) {
    return nck_fabs(w1 - w0) / (2.0 * a);
}

// Peak of the fastest profile over a length with ramps of ±a at both ends:
//        w_peak  ___        accelerate w0 → w_peak, cruise, decelerate w_peak → w1:
//               /   \       w_peak = min(w_cap, (w0 + w1)/2 + a·length)
//         w0   /     \  w1  and never below w0 or w1 (rounding)
static inline nck_real nck_ramp_peak(nck_real length, nck_real w0, nck_real w1, nck_real a,
                                     nck_real w_cap) {
    const nck_real free = 0.5 * (w0 + w1) + a * length;
    return nck_max(nck_max(w0, w1), nck_min(w_cap, free));
}

#endif
