// SPDX-License-Identifier: MIT
// Formulas of other controls' planners. c = −u·w is the cosine of the corner between directions u
// and w, 1 where they turn back; L [mm], a [mm/s²], δ: junction deviation [mm], vv = v².
#ifndef NCK_HOST_CONTROL_MATH_H
#define NCK_HOST_CONTROL_MATH_H

#include "nck/base/limits.h" // NCK_AXIS_MAX
#include "nck/base/real.h"   // nck_real nck_sqrt

// The extruder's place among the axes: U, where a build has it.
enum { NCK_CONTROL_E = NCK_AXIS_MAX > 6 ? 6 : 0 };

// Beyond this cosine a corner turns back, or goes straight on.
#define NCK_CONTROL_STRAIGHT 0.999999

//  s = √((1 − c)/2), k = √((1 + c)/2): sine and cosine of half the corner
static inline nck_real nck_control_half(nck_real one) {
    return one > 0.0 ? nck_sqrt(0.5 * one) : 0.0;
}

//  vv = a δ s/(1 − s)                                            [mm²/s²], s < 1
// The circle that touches both lines and leaves the corner by δ, at the acceleration a.
static inline nck_real nck_control_deviation(nck_real c, nck_real a, nck_real deviation) {
    const nck_real s = nck_control_half(1.0 - c);
    return a * deviation * s / (1.0 - s);
}

//  δ = v² (√2 − 1)/a                                             [mm]
// of the speed v at which a right angle is passed.
static inline nck_real nck_control_square_corner(nck_real v, nck_real a) {
    return v * v * (nck_sqrt(2.0) - 1.0) / a;
}

//  vv = (2 a L) s/(4 k)                                          [mm²/s²]
// The circle touches a line no further from the corner than its middle.
static inline nck_real nck_control_mid_line(nck_real c, nck_real gain) {
    const nck_real s = nck_control_half(1.0 - c);
    return 0.25 * gain * s / nck_control_half(1.0 + c);
}

//  vv_top = min(vv_most, (vv_0 + vv_1)/2 + a L)                  [mm²/s²]
// At the top of a trapezoid; vv_0, vv_1: at its ends.
static inline nck_real nck_control_top(nck_real length, nck_real a, const nck_real vv[2],
                                       nck_real most) {
    return nck_max(nck_min(most, 0.5 * (vv[0] + vv[1]) + a * length), nck_max(vv[0], vv[1]));
}

#endif
