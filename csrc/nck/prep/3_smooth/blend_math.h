// SPDX-License-Identifier: MIT
// The blend of one sharp corner between two straight pieces: the path comes to the corner V along
// u1 and leaves along u2, and each of the two motions is a smooth stop and a smooth start of its
// own, overlapping as far as the tolerance lets them. Derived in README, section "Corners".
#ifndef NCK_PREP_BLEND_MATH_H
#define NCK_PREP_BLEND_MATH_H

#include "nck/base/real.h"      // nck_real
#include "nck/base/root_math.h" // nck_root_cube

// The first motion, as a distance along u1 from V, at the path coordinate s (0: its middle), with
// the half-width d:
//        f″ = −hat(s/d)/d,   hat(x) = max(0, 1 − |x|)
//        f  = s,  s − (s + d)³/6d²,  −(d − s)³/6d²,  0     up to −d, 0, d, beyond
// At a constant ds/dt = v this is the time-optimal stop from v under the jerk v³/d².
static inline nck_real nck_blend_stop(nck_real s, nck_real d) {
    if (s >= d) return 0.0;
    if (s >= 0.0) return -(d - s) * (d - s) * (d - s) / (6.0 * d * d);
    if (s <= -d) return s;
    return s - (s + d) * (s + d) * (s + d) / (6.0 * d * d);
}

// df/ds of it.
static inline nck_real nck_blend_stop_slope(nck_real s, nck_real d) {
    if (s >= d) return 0.0;
    if (s >= 0.0) return (d - s) * (d - s) / (2.0 * d * d);
    if (s <= -d) return 1.0;
    return 1.0 - (s + d) * (s + d) / (2.0 * d * d);
}

// The blend:   p(s) = V + u1·f(s) − u2·f(D − s).
// The two motions overlap over o = 2d − D of s. In its middle both are (o/2)³/6d² from V, and the
// path is that far times |u2 − u1| = 2 sin(α/2) from V, α the angle it turns by. Nowhere is it
// further from its two lines than there from V: of either line it leaves it is off by no more than
// the other motion times sin α. So the corner is no further from the path than the tolerance, and
// the path no further from the lines, if
//        o = min(2d, ∛(48·d²·tol/|u2 − u1|))
// Returns D. A blend without parking (D = 0) is what a cubic spline makes of the corner.
// turn = |u2 − u1| > 0.
static inline nck_real nck_blend_parking(nck_real d, nck_real tolerance, nck_real turn) {
    const nck_real cube = 48.0 * d * d * tolerance;
    if (8.0 * d * d * d * turn <= cube) return 0.0;
    return 2.0 * d - nck_root_cube(cube / turn);
}

#endif
