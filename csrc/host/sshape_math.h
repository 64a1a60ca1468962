// SPDX-License-Identifier: MIT
// The classical S-shaped ramp between two speeds: acceleration zero at both ends.
//
//   a_max ___           j ┐     dv = |v1 − v0|
//    a   /   \            │     dv ≥ a²/j: trapezoid of acceleration, peak a
//       /     \           │     dv < a²/j: triangle, peak √(dv·j)
//   ___/       \___       ┘     symmetric in time, so its mean speed is (v0 + v1)/2
//
// Derived in docs/papers.md, section "The S-shape". a [mm/s²] and j [mm/s³] are positive.
#ifndef NCK_HOST_SSHAPE_MATH_H
#define NCK_HOST_SSHAPE_MATH_H

#include "nck/base/real.h" // nck_real nck_sqrt nck_min

// Newton steps at most: far from the root a step takes off a third, near it doubles the digits.
#define NCK_SSHAPE_STEPS 100

// Peak acceleration of the ramp over dv ≥ 0:   min(a, √(dv·j))
static inline nck_real nck_sshape_peak(nck_real dv, nck_real a, nck_real j) {
    return nck_min(a, nck_sqrt(dv * j));
}

// Duration of the ramp over dv ≥ 0:   dv/a + a/j, or 2√(dv/j) for a triangle; dv = 0: 0
static inline nck_real nck_sshape_duration(nck_real dv, nck_real a, nck_real j) {
    return dv * j >= a * a ? dv / a + a / j : 2.0 * nck_sqrt(dv / j);
}

// Length of the ramp between v0 and v1, either way:   (v0 + v1)/2 · duration
static inline nck_real nck_sshape_length(nck_real v0, nck_real v1, nck_real a, nck_real j) {
    return 0.5 * (v0 + v1) * nck_sshape_duration(nck_fabs(v1 - v0), a, j);
}

// Half of the duration of the triangular ramp from v over a whole length:   j x³ + 2 v x = length
// Newton from x_above, which is not below the root: convex, so monotone from above.
static inline nck_real nck_sshape_half(nck_real v, nck_real length, nck_real j, nck_real x_above) {
    nck_real x = x_above;
    for (int k = 0; k < NCK_SSHAPE_STEPS; k++) {
        const nck_real next = (2.0 * j * x * x * x + length) / (3.0 * j * x * x + 2.0 * v);
        if (!(next < x)) return x;
        x = next;
    }
    return x;
}

// Largest speed that a ramp from v reaches within the length:
//   √((v − q)² + 2a·length) − q with q = a²/(2j), or v + j x² if a is not reached. length > 0.
static inline nck_real nck_sshape_reach(nck_real v, nck_real length, nck_real a, nck_real j) {
    const nck_real rise = a / j;
    if (length >= (2.0 * v + a * rise) * rise) {
        const nck_real q = 0.5 * a * rise;
        return nck_sqrt((v - q) * (v - q) + 2.0 * a * length) - q;
    }
    const nck_real x = nck_sshape_half(v, length, j, rise);
    return v + j * x * x;
}

// One S over a whole piece, a triangle of acceleration that peaks at a:   v1² = v0² + a·length
// (the mean acceleration is half of the peak). Jerk follows from the piece instead of limiting it.
static inline nck_real nck_sshape_whole_reach(nck_real v, nck_real length, nck_real a) {
    return nck_sqrt(v * v + a * length);
}

// The jerk of a triangular ramp over dv in a given time:   j = 4 dv/duration²
static inline nck_real nck_sshape_jerk(nck_real dv, nck_real duration) {
    return 4.0 * dv / (duration * duration);
}

#endif
