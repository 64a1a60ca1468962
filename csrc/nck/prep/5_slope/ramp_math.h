// SPDX-License-Identifier: MIT
// Ramps of constant acceleration, in v².
#ifndef NCK_PREP_RAMP_MATH_H
#define NCK_PREP_RAMP_MATH_H

#include "nck/base/real.h" // nck_real nck_fabs nck_max nck_min

// Duration of a piece of constant acceleration from v0 to v1 (not both zero):   q = 2·length/(v0 +
// v1)
static inline nck_real nck_ramp_duration(nck_real length, nck_real v0, nck_real v1) {
    return 2.0 * length / (v0 + v1);
}

// The acceleration of such a piece:   a = (vv1 − vv0)/(2·length)   (Cao et al. 2014, eq. 15)
static inline nck_real nck_ramp_accel(nck_real length, nck_real vv0, nck_real vv1) {
    return (vv1 - vv0) / (2.0 * length);
}

// Length of a ramp from vv0 to vv1 at |a|:   |vv1 − vv0|/(2a)       (Cao et al. 2014, eq. 6)
static inline nck_real nck_ramp_length(nck_real vv0, nck_real vv1, nck_real a) {
    return nck_fabs(vv1 - vv0) / (2.0 * a);
}

// Peak of the fastest profile over a length with ramps of ±a at both ends:
//        vv_peak  ___        accelerate vv0 → vv_peak, cruise, decelerate vv_peak → vv1:
//                /   \       vv_peak = min(vv_cap, (vv0 + vv1)/2 + a·length)
//         vv0   /     \ vv1  and never below vv0 or vv1 (rounding)
static inline nck_real nck_ramp_peak(nck_real length, nck_real vv0, nck_real vv1, nck_real a,
                                     nck_real vv_cap) {
    const nck_real free = 0.5 * (vv0 + vv1) + a * length;
    return nck_max(nck_max(vv0, vv1), nck_min(vv_cap, free));
}

#endif
